// src/bounds.js: boxes around turned solids, against a cloud of their points.

import assert from "node:assert/strict";
import { test } from "node:test";
import { motionBounds, reachRadius, rotationMatrix, worldBounds } from "../src/bounds.js";
import { LiveMotion } from "../src/live_motion.js";

const AROUND = Array.from({ length: 720 }, (_, i) => (i * Math.PI) / 360);
const ring = (radius, y) => AROUND.map((a) => [radius * Math.cos(a), y, radius * Math.sin(a)]);
const corners = ([x, y, z]) => [0, 1, 2, 3, 4, 5, 6, 7].map((i) =>
  [i & 1 ? x / 2 : -x / 2, i & 2 ? y / 2 : -y / 2, i & 4 ? z / 2 : -z / 2]);

const SOLIDS = [
  [{ kind: "box", size_m: [1, 2, 3] }, corners([1, 2, 3])],
  [{ kind: "cylinder", radius_m: 0.5, height_m: 2 }, [...ring(0.5, 1), ...ring(0.5, -1)]],
  [{ kind: "cone", radius_m: 0.5, height_m: 2 }, [[0, 1.5, 0], ...ring(0.5, -0.5)]],
  [{ kind: "hull", vertices_m: corners([1, 1, 2]) }, corners([1, 1, 2])],
];
const length = Math.hypot(0.3, 0.5, -0.4, 0.7);
const QUATERNION = [0.3, 0.5, -0.4, 0.7].map((q) => q / length);

for (const [shape, points] of SOLIDS) {
  test(`a turned ${shape.kind} fills its box`, () => {
    const turn = rotationMatrix(QUATERNION, 0, []);
    const [low, high] = [[], []];
    assert.equal(worldBounds(shape, turn, low, high), true);
    for (let axis = 0; axis < 3; ++axis) {
      const along = points.map((p) => p.reduce((sum, x, i) => sum + turn[3 * axis + i] * x, 0));
      assert.ok(Math.abs(low[axis] - Math.min(...along)) < 1e-4, `low ${axis}`);
      assert.ok(Math.abs(high[axis] - Math.max(...along)) < 1e-4, `high ${axis}`);
    }
    const farthest = Math.max(...points.map((p) => Math.hypot(...p)));
    assert.ok(Math.abs(reachRadius(shape) - farthest) < 1e-9);
  });
}

test("balls and capsules reach by their radius; planes have no box", () => {
  const turn = rotationMatrix([Math.SQRT1_2, 0, 0, Math.SQRT1_2], 0, []);  // y becomes -x
  const [low, high] = [[], []];
  worldBounds({ kind: "capsule", radius_m: 1, height_m: 4 }, turn, low, high);
  [3, 1, 1].forEach((reach, i) => assert.ok(Math.abs(high[i] - reach) < 1e-9 && Math.abs(low[i] + reach) < 1e-9));
  worldBounds({ kind: "sphere", radius_m: 2 }, turn, low, high);
  assert.deepEqual([low, high], [[-2, -2, -2], [2, 2, 2]]);
  assert.equal(worldBounds({ kind: "plane" }, turn, low, high), false);
});

test("the box around a motion holds its ends and what stands, not the planes", () => {
  const bodies = [{ motion: "dynamic", shape: { kind: "sphere", radius_m: 1 } },
                  { motion: "static", shape: { kind: "plane", normal: [0, 1, 0], offset_m: 0 } }];
  const motion = new LiveMotion(bodies);
  for (const x of [0, 5, 3]) {
    motion.push({ time_s: x, position: [x, 0, 0, 90, 90, 90], rotation: [1, 0, 0, 0, 1, 0, 0, 0], facts: {} });
  }
  assert.deepEqual(motionBounds(bodies, motion), { low: [-1, -1, -1], high: [6, 1, 1] });
});
