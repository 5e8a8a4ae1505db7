// The bodies, all in one draw call. Their triangles lie in one geometry and never change; each corner knows its body,
// and the graphics processor turns and moves it by the body's pose, which it reads from a small texture. Instanced
// drawing would be the usual way, but a processor that draws by itself pays for each instance as for a draw call.

import {
  Box3, BufferAttribute, BufferGeometry, Color, DataTexture, FloatType, Mesh, MeshBasicMaterial, MeshDepthMaterial,
  MeshLambertMaterial, RGBAFormat, Vector3,
} from "three";
import { rotationMatrix, worldBounds } from "./bounds.js";
import { SKY, SUN } from "./light.js";
import { isCurved, triangles } from "./shapes.js";

const ROW = 64;  // bodies in a row of the texture, two texels each: the place, the quaternion

export class Bodies extends Mesh {
  #bodies;
  #poses;
  #full;
  #hurried;

  /** @param {object[]} bodies as in bodies.json; planes are the stage's  @param graphics how finely to draw */
  constructor(bodies, graphics) {
    const rows = Math.ceil(bodies.length / ROW);
    const poses = new DataTexture(new Float32Array(8 * ROW * rows), 2 * ROW, rows, RGBAFormat, FloatType);
    super(merged(bodies, graphics), posed(marked(new MeshLambertMaterial({ vertexColors: true })), poses));
    this.#full = this.material;
    this.#hurried = posed(lit(new MeshBasicMaterial({ vertexColors: true, fog: false })), poses);
    this.customDepthMaterial = posed(new MeshDepthMaterial(), poses);
    this.castShadow = true;
    this.receiveShadow = graphics.soft;
    this.frustumCulled = false;
    this.#bodies = bodies;
    this.#poses = poses;
  }

  /** @param {Float32Array} poses seven numbers a body, as interpolate.js writes them */
  show(poses) {
    const texels = this.#poses.image.data;
    for (let body = 0; body < this.#bodies.length; ++body) {
      for (let i = 0; i < 3; ++i) texels[8 * body + i] = poses[7 * body + i];
      for (let i = 0; i < 4; ++i) texels[8 * body + 4 + i] = poses[7 * body + 3 + i];
    }
    this.#poses.needsUpdate = true;
  }

  /** Whether they are drawn for speed. */
  hurry(hurried) {
    this.material = hurried ? this.#hurried : this.#full;
  }

  /** The body whose box a ray meets first, or null. */
  pick({ ray }, poses) {
    const [low, high, turn] = [[], [], []];
    const hit = new Vector3();
    let picked = null;
    let nearest_m = Infinity;
    this.#bodies.forEach(({ shape }, body) => {
      if (!worldBounds(shape, rotationMatrix(poses, 7 * body + 3, turn), low, high)) return;
      const place = new Vector3().fromArray(poses, 7 * body);
      const box = new Box3(new Vector3(...low).add(place), new Vector3(...high).add(place));
      const distance_m = ray.intersectBox(box, hit) ? ray.origin.distanceTo(hit) : Infinity;
      if (distance_m < nearest_m) [picked, nearest_m] = [body, distance_m];
    });
    return picked;
  }
}

// The triangles of all bodies, in their own axes.
function merged(bodies, fineness) {
  const forms = new Map();
  const form = (shape) => {
    const key = JSON.stringify(shape);
    if (!forms.has(key)) forms.set(key, triangles(shape, fineness));
    return forms.get(key);
  };
  const parts = bodies.map(({ shape, color }, body) => ({ body, shape, color, geometry: form(shape) }))
    .filter(({ geometry }) => geometry);
  const corners = parts.reduce((sum, { geometry }) => sum + geometry.attributes.position.count, 0);
  const numbers = (size) => new BufferAttribute(new Float32Array(size * corners), size);
  const [position, normal, color, owner] = [numbers(3), numbers(3), numbers(3), numbers(2)];
  const index = new Uint32Array(parts.reduce((sum, { geometry }) => sum + geometry.index.count, 0));
  let first = 0;
  let next = 0;
  for (const part of parts) {
    const { attributes, index: own } = part.geometry;
    position.array.set(attributes.position.array, 3 * first);
    normal.array.set(attributes.normal.array, 3 * first);
    const paint = new Color().setRGB(...part.color, "srgb");
    for (let i = first; i < first + attributes.position.count; ++i) {
      color.setXYZ(i, paint.r, paint.g, paint.b);
      owner.setXY(i, part.body, isCurved(part.shape) ? 1 : 0);
    }
    for (let i = 0; i < own.count; ++i) index[next++] = first + own.getX(i);
    first += attributes.position.count;
  }
  return new BufferGeometry().setIndex(new BufferAttribute(index, 1))
    .setAttribute("position", position).setAttribute("normal", normal)
    .setAttribute("color", color).setAttribute("owner", owner);
}

const POSE = `#include <common>
  attribute vec2 owner;
  uniform sampler2D poses;
  varying vec3 vOwn;
  varying float vMarked;
  vec4 place, turn;
  vec4 poseTexel(int part) {
    int body = int(owner.x);
    return texelFetch(poses, ivec2(2 * (body % ${ROW}) + part, body / ${ROW}), 0);
  }
  vec3 turned(vec3 v, vec4 q) { return v + 2.0 * cross(q.yzw, cross(q.yzw, v) + q.x * v); }`;

// A material of three.js whose corners are turned and moved by the pose of their body.
function posed(material, poses) {
  const before = material.onBeforeCompile;
  material.onBeforeCompile = (shader, renderer) => {
    before?.call(material, shader, renderer);
    shader.uniforms.poses = { value: poses };
    shader.vertexShader = shader.vertexShader
      .replace("#include <common>", POSE)
      .replace("void main() {", "void main() {\nplace = poseTexel(0);\nturn = poseTexel(1);")
      .replace("#include <beginnormal_vertex>", "vec3 objectNormal = turned(normal, turn);")
      .replace("#include <begin_vertex>", `vOwn = position;
        vMarked = owner.y;
        vec3 transformed = turned(position, turn) + place.xyz;`);
  };
  return material;
}

// Lit and marked at the corners, which leaves a colour for a pixel to know: a processor that draws by itself works out
// everything that a pixel is to know for each triangle, however small.
function lit(material) {
  material.onBeforeCompile = (shader) => {
    Object.assign(shader.uniforms, {
      towardsSun: { value: SUN.towards },
      sun: { value: reflected(SUN.color, SUN) },
      above: { value: reflected(SKY.above, SKY) },
      below: { value: reflected(SKY.below, SKY) },
    });
    shader.vertexShader = shader.vertexShader
      .replace("#include <common>", "#include <common>\nuniform vec3 towardsSun, sun, above, below;")
      .replace("#include <color_vertex>", `#include <color_vertex>
        vec3 upright = turned(normal, turn);
        vColor.rgb *= max(dot(upright, towardsSun), 0.0) * sun + mix(below, above, 0.5 * upright.y + 0.5);
        vColor.rgb *= 1.0 - 0.13 * owner.y * (1.0 - sign(position.x * position.y * position.z));`);
  };
  return material;
}

// Of light that comes straight down on white paper.
const reflected = (color, { intensity }) => color.clone().multiplyScalar(intensity / Math.PI);

// A ball of one colour does not show that it turns: every other octant of a curved body is a shade darker, as on the
// marks of crash tests.
function marked(material) {
  material.onBeforeCompile = (shader) => {
    shader.fragmentShader = shader.fragmentShader
      .replace("#include <common>", "#include <common>\nvarying vec3 vOwn;\nvarying float vMarked;")
      .replace("#include <color_fragment>", `#include <color_fragment>
        vec3 side = clamp(vOwn / max(fwidth(vOwn), vec3(1e-6)), -1.0, 1.0);
        diffuseColor.rgb *= 1.0 - 0.13 * vMarked * (1.0 - side.x * side.y * side.z);`);
  };
  return material;
}
