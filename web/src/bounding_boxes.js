// Boxes along the world's axes around bodies: around all of them on demand, around the chosen one always.

import { BufferAttribute, BufferGeometry, DynamicDrawUsage, LineBasicMaterial, LineSegments } from "three";
import { rotationMatrix, worldBounds } from "./bounds.js";

// A corner is three bits, high or low along x, y and z; an edge joins corners that differ in one.
const EDGES = [];
for (let corner = 0; corner < 8; ++corner) {
  for (const bit of [1, 2, 4]) if (!(corner & bit)) EDGES.push(corner, corner | bit);
}

export class BoundingBoxes extends LineSegments {
  #shapes;
  #turn = new Array(9);
  #low = [0, 0, 0];
  #high = [0, 0, 0];

  constructor(bodies) {
    const geometry = new BufferGeometry();
    const corners = new BufferAttribute(new Float32Array(bodies.length * EDGES.length * 3), 3);
    geometry.setAttribute("position", corners.setUsage(DynamicDrawUsage));
    super(geometry, new LineBasicMaterial({ transparent: true, opacity: 0.8 }));
    this.frustumCulled = false;
    this.#shapes = bodies.map((body) => body.shape);
  }

  /** @param {Iterable<number>} chosen the bodies to draw boxes around */
  show(poses, chosen) {
    const corners = this.geometry.attributes.position;
    let at = 0;
    for (const body of chosen) {
      rotationMatrix(poses, 7 * body + 3, this.#turn);
      if (!worldBounds(this.#shapes[body], this.#turn, this.#low, this.#high)) continue;
      for (const corner of EDGES) {
        for (let axis = 0; axis < 3; ++axis) {
          const side = corner & (1 << axis) ? this.#high : this.#low;
          corners.array[at++] = poses[7 * body + axis] + side[axis];
        }
      }
    }
    corners.needsUpdate = true;
    this.geometry.setDrawRange(0, at / 3);
  }
}
