// What the bodies stand on and are lit by: a sun with soft shadows, the sky's light, the scene's planes. A level plane
// is paper with lines and shadows; a scene without planes gets such a floor at the lowest point of its motion, to tell
// heights by.

import {
  Color, DirectionalLight, Fog, Group, HemisphereLight, Mesh, MeshBasicMaterial, MeshLambertMaterial, PlaneGeometry,
  Quaternion, ShadowMaterial, Vector3,
} from "three";
import { Grid } from "./grid.js";
import { SKY, SUN } from "./light.js";
import { colorOf } from "./theme.js";

const UP = new Vector3(0, 1, 0);
const EXTENT = 24;    // of planes, in radii of the motion
const SHADOWED = 3.2;  // of the part of the floor that shadows reach

export class Stage extends Group {
  #sun = new DirectionalLight(SUN.color, SUN.intensity);
  #sky = new HemisphereLight(SKY.above, SKY.below, SKY.intensity);
  #floor = new Group();
  #planes = [];
  #shadow;  // on the floor
  #bodies;
  #motion;

  constructor(bodies, motion, shadow_px) {
    super();
    this.#bodies = bodies;
    this.#motion = motion;
    this.#sun.castShadow = true;
    this.#sun.shadow.mapSize.set(shadow_px, shadow_px);
    this.#sun.shadow.radius = 3;
    this.#sun.shadow.intensity = 0.75;
    this.add(this.#sun, this.#sun.target, this.#sky, this.#floor);
  }

  /** @param {{low: number[], high: number[]}} box around the motion */
  fit(box) {
    const low = new Vector3(...box.low);
    const high = new Vector3(...box.high);
    const center = low.clone().add(high).multiplyScalar(0.5);
    const radius_m = low.distanceTo(high) / 2;
    this.#aim(center, radius_m);
    this.#build(center, radius_m, box.low[1]);
  }

  #aim(center, radius_m) {
    this.#sun.position.copy(center).addScaledVector(SUN.towards, 3 * radius_m);
    this.#sun.target.position.copy(center);
    const { camera } = this.#sun.shadow;
    camera.left = camera.bottom = -1.4 * radius_m;
    camera.right = camera.top = 1.4 * radius_m;
    camera.near = radius_m;
    camera.far = 6 * radius_m;
    camera.updateProjectionMatrix();
    this.#sun.shadow.normalBias = radius_m / 200;
  }

  #build(center, radius_m, lowest_m) {
    this.#floor.clear();
    this.#planes = [];
    this.#bodies.forEach((body, index) => {
      if (body.shape.kind !== "plane") return;
      const { normal, point } = this.#plane(body.shape, index, center);
      const is_level = normal.y > 0.999;
      this.#place(this.#surface(radius_m, body.color, is_level), normal, point);
      if (normal.y > 0.5) this.#place(new Grid(EXTENT * radius_m, radius_m), normal, point);
      if (is_level) this.#shadows(radius_m, point);
    });
    if (this.#planes.length) return;
    const point = new Vector3(center.x, lowest_m, center.z);
    this.#place(new Grid(EXTENT * radius_m, radius_m), UP, point);
    this.#shadows(radius_m, point);
  }

  #shadows(radius_m, point) {
    const shadow = new Mesh(square(SHADOWED * radius_m), new ShadowMaterial({ opacity: 0.2, depthWrite: false }));
    shadow.receiveShadow = true;
    this.#shadow = shadow;
    this.#place(shadow, UP, point);
  }

  showShadows(visible) {
    if (this.#shadow) this.#shadow.visible = visible;
  }

  // The plane's normal in the world and its point that is nearest to the middle of the motion.
  #plane(shape, index, center) {
    const q = [0, 0, 0, 0];
    const place = [0, 0, 0];
    this.#motion.rotation(index, 0, q);
    this.#motion.position(index, 0, place);
    const normal = new Vector3(...shape.normal).normalize().applyQuaternion(new Quaternion(q[1], q[2], q[3], q[0]));
    const offset_m = shape.offset_m + normal.dot(new Vector3(...place));
    return { normal, point: center.clone().addScaledVector(normal, offset_m - normal.dot(center)) };
  }

  // Level ones are paper, whatever their light; what lies in them, lines and shadows, is nearer by a hair.
  #surface(radius_m, color, is_level) {
    const Material = is_level ? MeshBasicMaterial : MeshLambertMaterial;
    const behind = { polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 4 };
    const mesh = new Mesh(square(EXTENT * radius_m), new Material(behind));
    mesh.userData.tint = is_level ? 0 : 0.15;
    mesh.userData.color = new Color().setRGB(...color, "srgb");
    mesh.receiveShadow = true;
    this.#planes.push(mesh);
    return mesh;
  }

  #place(object, normal, point) {
    object.quaternion.setFromUnitVectors(UP, normal);
    object.position.copy(point);
    this.#floor.add(object);
  }

  /** Takes the page's colours. Planes are hardly tinted: they are the paper that the bodies are drawn on. */
  paint(scene, near_m, far_m) {
    const paper = new Color(colorOf("--stage"));
    const ink = new Color(colorOf("--stage-line"));
    scene.background = paper;
    scene.fog = new Fog(paper, near_m, far_m);
    for (const plane of this.#planes) tint(plane.material.color, paper, plane.userData);
    for (const object of this.#floor.children) if (object instanceof Grid) object.paint(ink);
  }
}

// Mixed as the eye sees, not as light adds up: a tint is as strong on dark paper as on light.
function tint(result, paper, { color, tint: share }) {
  const [from, to] = [{}, {}];
  paper.getRGB(from, "srgb");
  color.getRGB(to, "srgb");
  const mixed = ["r", "g", "b"].map((key) => from[key] + share * (to[key] - from[key]));
  result.setRGB(...mixed, "srgb");
}

const square = (extent_m) => new PlaneGeometry(extent_m, extent_m).rotateX(-Math.PI / 2);
