// What happened just now, where it happened: a dot at the point of contact, and an arrow along the impulse on the
// first of the two bodies. The longest arrow is the run's largest impulse.

import {
  ConeGeometry, CylinderGeometry, Group, InstancedMesh, Matrix4, MeshBasicMaterial, Quaternion, SphereGeometry,
  Vector3,
} from "three";
import { mergeGeometries } from "three/examples/jsm/utils/BufferGeometryUtils.js";
import { lastBefore } from "./moments.js";

const UP = new Vector3(0, 1, 0);

export class Impulses extends Group {
  #events;
  #largest_N_s = 0;
  #measured = 0;
  #dots;
  #arrows;
  #most;
  #matrix = new Matrix4();
  #turn = new Quaternion();

  /**
   * @param {object[]} events in the order of time; a live run appends to them
   * @param {number} most shown at once, the newest: more arrows hide each other and the bodies
   */
  constructor(events, most) {
    super();
    this.#most = most;
    this.#events = events;
    // Seen through bodies: contacts lie between two of them.
    const ink = new MeshBasicMaterial({ depthTest: false, transparent: true });
    this.material = ink;
    this.#dots = new InstancedMesh(new SphereGeometry(1, 12, 8), ink, most);
    this.#arrows = new InstancedMesh(arrow(), ink, most);
    for (const mesh of [this.#dots, this.#arrows]) {
      mesh.frustumCulled = false;
      mesh.renderOrder = 2;
      this.add(mesh);
    }
  }

  /** @param {number} window_s how long an event stays to be seen  @param {number} size_m of the longest arrow */
  show(time_s, window_s, size_m) {
    for (; this.#measured < this.#events.length; ++this.#measured) {
      this.#largest_N_s = Math.max(this.#largest_N_s, length(this.#events[this.#measured].impulse_N_s));
    }
    this.#dots.count = this.#arrows.count = 0;
    for (let i = lastBefore(this.#events, time_s); i >= 0 && this.#dots.count < this.#most; --i) {
      const event = this.#events[i];
      if (event.time_s < time_s - window_s) break;
      if (event.point_m) this.#put(event, size_m);
    }
    this.#dots.instanceMatrix.needsUpdate = this.#arrows.instanceMatrix.needsUpdate = true;
  }

  #put(event, size_m) {
    const point = new Vector3(...event.point_m);
    const dot_m = size_m / 34;
    this.#matrix.makeScale(dot_m, dot_m, dot_m).setPosition(point);
    this.#dots.setMatrixAt(this.#dots.count++, this.#matrix);
    const impulse_N_s = length(event.impulse_N_s);
    if (!impulse_N_s) return;
    // A small impulse still has a direction that can be seen.
    const long_m = size_m * Math.max(0.12, impulse_N_s / this.#largest_N_s);
    const wide_m = Math.min(size_m, 2.5 * long_m);
    this.#turn.setFromUnitVectors(UP, new Vector3(...event.impulse_N_s).normalize());
    this.#matrix.compose(point, this.#turn, new Vector3(wide_m, long_m, wide_m));
    this.#arrows.setMatrixAt(this.#arrows.count++, this.#matrix);
  }
}

const length = (vector) => (vector ? Math.hypot(...vector) : 0);

// From the origin up, one long.
function arrow() {
  const shaft = new CylinderGeometry(0.014, 0.014, 0.8, 8).translate(0, 0.4, 0);
  const head = new ConeGeometry(0.05, 0.22, 12).translate(0, 0.89, 0);
  return mergeGeometries([shaft, head]);
}
