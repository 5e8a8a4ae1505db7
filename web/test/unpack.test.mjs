// src/unpack.js and src/recorded_motion.js: a payload is read back as it was packed, and a bad one is refused in words.

import assert from "node:assert/strict";
import { test } from "node:test";
import { RecordedMotion } from "../src/recorded_motion.js";
import { parse, PayloadError, unpack } from "../src/unpack.js";
import { encode, pack, quantized, turns } from "./pack.mjs";

const half = Math.SQRT1_2;

function packed(format = 1) {
  const bodies = [{ name: "ball", frames: 3 }, { name: "floor", frames: 1 }, { name: "wall", frames: 1 }];
  const position = [[[0, 0, 5], [0, 10, 5], [0, 7, 5]], [[1, 2, 3]], [[4, 5, 6]]];
  const rotation = [[[1, 0, 0, 0], [half, half, 0, 0], [0, 1, 0, 0]], [[0, 0, 1, 0]], [[0, 0, 0, 1]]];
  return pack({ format, bodies, frames: 3, text: "esferá" }, {
    time_s: { type: "f64", values: [0, 0.1, 0.2] },
    position: quantized(position), rotation: turns(rotation), velocity: quantized(position),
    "facts.kinetic_J": { type: "f32", values: [1, 2, 3] },
  });
}

const near = (actual, expected, error) =>
  expected.forEach((value, i) => assert.ok(Math.abs(actual[i] - value) <= error, `${actual} is not ${expected}`));

test("a payload reads back: header, times, facts, poses within the step of 16 bits", async () => {
  const run = await unpack(`\n${encode(packed())}\n`);
  assert.equal(run.header.text, "esferá");
  const motion = new RecordedMotion(run);
  assert.deepEqual([...motion.times_s], [0, 0.1, 0.2]);
  assert.deepEqual([...motion.facts.kinetic_J], [1, 2, 3]);
  const out = [];
  motion.position(0, 2, out);
  near(out, [0, 7, 5], 10 / 65535);
  motion.rotation(0, 1, out);
  near(out, [half, half, 0, 0], 1e-4);
  assert.ok(Math.abs(Math.hypot(...out) - 1) < 1e-12, "unit quaternion");
});

test("a body that stands has one frame, and is there at all of them", async () => {
  const motion = new RecordedMotion(await unpack(encode(packed())));
  const out = [];
  motion.position(2, 2, out);
  assert.deepEqual(out, [4, 5, 6]);
  motion.rotation(1, 2, out);
  assert.deepEqual(out, [0, 0, 1, 0]);
  assert.deepEqual([0, 1, 2].map((body) => motion.moves(body)), [true, false, false]);
});

for (const [what, payload, message] of [
  ["no run", "   ", /carries no run.*animado report/],
  ["no base64", "%%%", /damaged/],
  ["half a run", encode(packed()).slice(0, 60), /damaged/],
  ["another format", encode(packed(2)), /format 1; this one has 2/],
]) {
  test(`${what} is refused in words`, async () => {
    await assert.rejects(unpack(payload), (error) => error instanceof PayloadError && message.test(error.message));
  });
}

test("an array that is cut short is refused by its name", () => {
  const whole = packed();
  const short = Uint8Array.from(whole.subarray(0, whole.length - 16)).buffer;
  assert.throws(() => parse(short), /facts.kinetic_J is cut short/);
});
