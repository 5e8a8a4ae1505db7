// The bodies, drawn a kind of shape at a time: a thousand of them cost a few draw calls.

import { Color, Group, InstancedMesh, Matrix4, MeshLambertMaterial, Quaternion, Vector3 } from "three";
import { solid } from "./shapes.js";

const flat = new MeshLambertMaterial();
const marked = markOctants(new MeshLambertMaterial());

export class Bodies extends Group {
  #meshes = [];
  #matrix = new Matrix4();
  #place = new Vector3();
  #turn = new Quaternion();
  #scale = new Vector3();

  /** @param {object[]} bodies as in bodies.json; planes are the stage's  @param graphics how finely to draw */
  constructor(bodies, graphics) {
    super();
    const alike = new Map();
    bodies.forEach((body, index) => {
      if (body.shape.kind === "plane") return;
      const form = solid(body.shape, graphics);
      if (!alike.has(form.key)) alike.set(form.key, { form, members: [] });
      alike.get(form.key).members.push({ index, scale: form.scale, color: body.color });
    });
    for (const { form, members } of alike.values()) this.#draw(form, members, graphics.soft);
  }

  #draw(form, members, soft) {
    const mesh = new InstancedMesh(form.geometry(), form.curved ? marked : flat, members.length);
    members.forEach(({ color }, i) => mesh.setColorAt(i, new Color().setRGB(...color, "srgb")));
    mesh.castShadow = true;
    mesh.receiveShadow = soft;
    mesh.frustumCulled = false;
    mesh.userData.members = members;
    this.#meshes.push(mesh);
    this.add(mesh);
  }

  /** @param {Float32Array} poses seven numbers a body, as interpolate.js writes them */
  show(poses) {
    for (const mesh of this.#meshes) {
      mesh.userData.members.forEach(({ index, scale }, i) => {
        const at = 7 * index;
        this.#place.fromArray(poses, at);
        this.#turn.set(poses[at + 4], poses[at + 5], poses[at + 6], poses[at + 3]);
        this.#matrix.compose(this.#place, this.#turn, this.#scale.fromArray(scale));
        this.#matrix.toArray(mesh.instanceMatrix.array, 16 * i);
      });
      mesh.instanceMatrix.needsUpdate = true;
      mesh.boundingSphere = null;
    }
  }

  /** The body that a ray meets first, or null. */
  pick(raycaster) {
    const [hit] = raycaster.intersectObjects(this.#meshes, false);
    return hit ? hit.object.userData.members[hit.instanceId].index : null;
  }
}

// A ball of one colour does not show that it turns: every other octant of a curved body is a shade darker, as on the
// marks of crash tests.
function markOctants(material) {
  material.onBeforeCompile = (shader) => {
    shader.vertexShader = shader.vertexShader
      .replace("#include <common>", "#include <common>\nvarying vec3 vOwn;")
      .replace("#include <begin_vertex>", "#include <begin_vertex>\nvOwn = position;");
    shader.fragmentShader = shader.fragmentShader
      .replace("#include <common>", "#include <common>\nvarying vec3 vOwn;")
      .replace("#include <color_fragment>", `#include <color_fragment>
        vec3 side = clamp(vOwn / max(fwidth(vOwn), vec3(1e-6)), -1.0, 1.0);
        diffuseColor.rgb *= 0.87 + 0.13 * side.x * side.y * side.z;`);
  };
  return material;
}
