// What is listed, plotted and drawn of a run: src/rows.js, src/series.js, src/sequence_layout.js, src/live_motion.js

import assert from "node:assert/strict";
import { test } from "node:test";
import { LiveMotion } from "../src/live_motion.js";
import { ROW_PX, visibleRows } from "../src/rows.js";
import { layout } from "../src/sequence_layout.js";
import { bodyPlots, scenePlots } from "../src/series.js";

test("of ten thousand rows only those are made that can be seen", () => {
  const { first, end } = visibleRows(5000 * ROW_PX, 10 * ROW_PX, 10000);
  assert.ok(first <= 5000 && end >= 5010 && end - first < 30);
  assert.deepEqual(visibleRows(0, 300, 3), { first: 0, end: 3 });
  assert.deepEqual(visibleRows(0, 300, 0), { first: 0, end: 0 });
});

test("energies: the total is the sum, a kind that is not there has no line", () => {
  const zero = [0, 0];
  const facts = { kinetic_J: [1, 2], potential_J: [5, 3], elastic_J: zero, work_in_J: zero,
                  dissipated_impacts_J: [0, 1], dissipated_friction_J: zero, dissipated_damping_J: zero };
  const [energy, ...others] = scenePlots(facts);
  assert.deepEqual(energy.lines.map(({ label }) => label), ["kinetic", "potential", "total", "lost"]);
  assert.deepEqual([...energy.lines[2].values], [6, 5]);
  assert.deepEqual(others, [], "columns that are not there make no plots");
});

test("a body's plots read its positions and velocities", () => {
  const motion = new LiveMotion([{ motion: "dynamic" }]);
  motion.push({ time_s: 0, position: [0, 0, 0], rotation: [1, 0, 0, 0], facts: {} });
  motion.push({ time_s: 0.5, position: [3, 4, 0], rotation: [1, 0, 0, 0], facts: {} });
  const [position, velocity] = bodyPlots(motion, 0, "ball");
  assert.match(position.title, /ball/);
  assert.deepEqual(position.lines.map(({ values }) => values[1]), [3, 4, 0]);
  assert.deepEqual(velocity.lines.map(({ values }) => values[1]), [6, 8, 0, 10]);
});

test("a question within a question is answered before it", () => {
  const { rows, busy } = layout([
    { at_us: 10, took_us: 50, from: "controle", to: "colisao", method: "respond" },
    { at_us: 20, took_us: 15, from: "colisao", to: "egesp", method: "solve" },
  ]);
  assert.deepEqual(rows.map(({ kind, from, to }) => `${kind} ${from} ${to}`), [
    "request controle colisao", "request colisao egesp", "reply egesp colisao", "reply colisao controle",
  ]);
  assert.deepEqual(rows.map(({ text }) => text), ["respond", "solve", "15.0 µs", "50.0 µs"]);
  assert.deepEqual(busy, [{ module: "egesp", first: 1, last: 2, depth: 0 },
                          { module: "colisao", first: 0, last: 3, depth: 0 }]);
});

test("a live motion forgets its older half when it is too long to keep", () => {
  const bodies = Array.from({ length: 100000 }, () => ({ motion: "dynamic" }));
  const motion = new LiveMotion(bodies);
  const zeros = new Array(300000).fill(0);
  const frame = (time_s) => ({ time_s, position: zeros, rotation: [], facts: { kinetic_J: time_s } });
  for (let i = 0; i < 130; ++i) motion.push(frame(i));
  assert.ok(motion.frames <= 100 && motion.frames >= 50);
  assert.equal(motion.times_s[motion.frames - 1], 129);
  assert.equal(motion.facts.kinetic_J.length, motion.frames);
});
