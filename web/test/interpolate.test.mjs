// src/interpolate.js and src/moments.js

import assert from "node:assert/strict";
import { test } from "node:test";
import { pose, slerp } from "../src/interpolate.js";
import { LiveMotion } from "../src/live_motion.js";
import { bracket, lastBefore, nearest } from "../src/moments.js";

const times_s = [0, 0.1, 0.3];
const about_x = (angle) => [Math.cos(angle / 2), Math.sin(angle / 2), 0, 0];
const near = (actual, expected) =>
  expected.forEach((value, i) => assert.ok(Math.abs(actual[i] - value) < 1e-6, `${[...actual]} is not ${expected}`));

test("a bracket holds the time, at the ends too", () => {
  assert.deepEqual(bracket(times_s, -1), { frame: 0, fraction: 0 });
  assert.equal(bracket(times_s, 0.2).frame, 1);
  assert.ok(Math.abs(bracket(times_s, 0.2).fraction - 0.5) < 1e-12);
  assert.deepEqual(bracket(times_s, 0.3), { frame: 2, fraction: 0 });
  assert.deepEqual(bracket(times_s, 9), { frame: 2, fraction: 0 });
  assert.deepEqual(bracket([5], 5), { frame: 0, fraction: 0 });
});

test("the nearest frame is the one before or the one after", () => {
  assert.equal(nearest(times_s, 0.19), 1);
  assert.equal(nearest(times_s, 0.21), 2);
});

test("the last event before a time counts one at that very time", () => {
  const events = [{ time_s: 1 }, { time_s: 2 }, { time_s: 2 }, { time_s: 3 }];
  assert.equal(lastBefore(events, 0.5), -1);
  assert.equal(lastBefore(events, 2), 2);
  assert.equal(lastBefore(events, 9), 3);
  assert.equal(lastBefore([], 1), -1);
});

test("slerp turns evenly, and takes the nearer of q and -q", () => {
  near(slerp(about_x(0), about_x(2), 0.25, []), about_x(0.5));
  near(slerp(about_x(0), about_x(2).map((q) => -q), 0.25, []), about_x(0.5));
  near(slerp(about_x(1), about_x(1), 0.5, []), about_x(1));
});

test("a pose between frames: the straight line and the arc", () => {
  const motion = new LiveMotion([{ motion: "dynamic" }, { motion: "static" }]);
  const rotation = (angle) => [...about_x(angle), 1, 0, 0, 0];
  motion.push({ time_s: 0, position: [0, 0, 0, 7, 7, 7], rotation: rotation(0), facts: { kinetic_J: 1 } });
  motion.push({ time_s: 1, position: [2, 4, 0, 7, 7, 7], rotation: rotation(2), facts: { kinetic_J: 2 } });
  const out = new Float64Array(14);
  const middle = bracket(motion.times_s, 0.5);
  pose(motion, 0, middle, out, 0);
  pose(motion, 1, middle, out, 7);
  near(out, [1, 2, 0, ...about_x(1), 7, 7, 7, 1, 0, 0, 0]);
  const velocity = [];
  motion.velocity(0, 1, velocity);
  near(velocity, [2, 4, 0]);
  assert.deepEqual(motion.facts.kinetic_J, [1, 2]);
});
