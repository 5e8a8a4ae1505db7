// The camera: orbits by mouse, touch and wheel, fits the motion, follows a body.

import { PerspectiveCamera, Vector3 } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";

const FROM = new Vector3(0.55, 0.42, 1).normalize();
const UPRIGHT_DEG = 35;
const MARGIN = 1.08;

export class Camera extends PerspectiveCamera {
  controls;
  touched = false;
  #radius_m = 1;
  #center = new Vector3();
  #followed = null;

  constructor(canvas, changed) {
    super(UPRIGHT_DEG);
    this.controls = new OrbitControls(this, canvas);
    this.controls.addEventListener("start", () => (this.touched = true));
    this.controls.addEventListener("change", changed);
  }

  /** How far the eye is from what it looks at, and how large that is: fog and arrows are measured by it. */
  get distance_m() {
    return this.position.distanceTo(this.controls.target);
  }

  get radius_m() {
    return this.#radius_m;
  }

  /** @param {{low: number[], high: number[]}} box to be seen whole, whatever the canvas' format is */
  fit(box) {
    const low = new Vector3(...box.low);
    const high = new Vector3(...box.high);
    this.#center.copy(low).add(high).multiplyScalar(0.5);
    this.#radius_m = low.distanceTo(high) / 2;
    this.#lookFrom(this.#center, FROM, this.#distanceToSee(low, high));
    this.near = this.#radius_m / 100;
    this.far = this.#radius_m * 100;
    this.controls.minDistance = this.#radius_m / 20;
    this.controls.maxDistance = this.#radius_m * 20;
    this.updateProjectionMatrix();
    this.touched = false;
    this.#followed = null;
  }

  // From how far the eight corners of the box are inside the picture, seen along FROM.
  #distanceToSee(low, high) {
    const tangent = Math.tan((UPRIGHT_DEG * Math.PI) / 360);
    const right = new Vector3(0, 1, 0).cross(FROM).normalize();
    const up = FROM.clone().cross(right);
    let distance_m = 0;
    for (let corner = 0; corner < 8; ++corner) {
      const at = new Vector3(corner & 1 ? low.x : high.x, corner & 2 ? low.y : high.y, corner & 4 ? low.z : high.z);
      at.sub(this.#center);
      const aside = Math.max(Math.abs(at.dot(right)) / this.aspect, Math.abs(at.dot(up)));
      distance_m = Math.max(distance_m, at.dot(FROM) + (MARGIN * aside) / tangent);
    }
    return distance_m;
  }

  #lookFrom(target, direction, distance_m) {
    this.controls.target.copy(target);
    this.position.copy(target).addScaledVector(direction, distance_m);
    this.controls.update();
  }

  /** Keeps its place relative to a body that it follows; null: it stays where it is. */
  follow(body, poses) {
    if (body === null) return void (this.#followed = null);
    const place = new Vector3().fromArray(poses, 7 * body);
    if (this.#followed) {
      const moved = place.clone().sub(this.#followed);
      this.controls.target.add(moved);
      this.position.add(moved);
    } else {
      this.position.add(place.clone().sub(this.controls.target));
      this.controls.target.copy(place);
    }
    this.#followed = place;
    this.controls.update();
  }
}
