// src/sharpness.js

import assert from "node:assert/strict";
import { test } from "node:test";
import { Sharpness } from "../src/sharpness.js";

function after(sharpness, pictures, took_ms) {
  for (let i = 0; i < pictures; ++i) sharpness.tell(took_ms);
  return sharpness.ratio;
}

test("slow pictures become coarser, step by step, and not without end", () => {
  const sharpness = new Sharpness(1);
  assert.equal(after(sharpness, 11, 40), 1);
  assert.equal(after(sharpness, 1, 40), 0.8);
  assert.equal(after(sharpness, 1000, 40), 0.6);
});

test("quick ones become finer again, as fine as they were", () => {
  const sharpness = new Sharpness(0.5);
  after(sharpness, 120, 40);
  const coarsest = sharpness.ratio;
  assert.ok(after(sharpness, 12, 17) > coarsest);
  assert.equal(after(sharpness, 1000, 17), 0.5);
});

test("one slow picture among quick ones changes nothing, nor does a rate that is just right", () => {
  const sharpness = new Sharpness(1);
  after(sharpness, 11, 17);
  assert.equal(after(sharpness, 1, 100), 1);
  assert.equal(after(sharpness, 1000, 25), 1);
});
