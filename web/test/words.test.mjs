// What a person reads: src/format.js, src/summary_sentence.js, src/event_text.js

import assert from "node:assert/strict";
import { test } from "node:test";
import { eventText } from "../src/event_text.js";
import { count, quantity, seconds, speedText } from "../src/format.js";
import { energySentence, runSentence } from "../src/summary_sentence.js";

test("numbers have the digits that tell something", () => {
  assert.equal(quantity(192.46753100242154, "J"), "192.5 J");
  assert.equal(quantity(2.842170943040401e-14, "J"), "2.84e−14 J");
  assert.equal(quantity(1e-15), "1e−15");
  assert.equal(quantity(-20), "−20");
  assert.equal(quantity(1500), "1500");
  assert.equal(quantity(NaN, "J"), "— J");
  assert.equal(count(15364), "15\u202f364");
  assert.equal(seconds(1.1419538, 1 / 60), "1.142");
  assert.equal(seconds(1.1419538, 1e-5), "1.141954");
  assert.equal(speedText(1 / 8), "×1/8");
  assert.equal(speedText(4), "×4");
  assert.equal(speedText(0), "max");
});

const energy = {
  initial: 200.67, final: 174.17, work_in: 0, dissipated_impacts: 26.5, dissipated_friction: -3.6e-15,
  dissipated_damping: 0, residual: -3e-15,
};

test("the energy's story in one sentence; what was only rounded is not told", () => {
  assert.equal(energySentence({ energy, impacts: 1 }),
    "Lost 26.5 J in 1 impact, from 200.7 J to 174.2 J; the ledger closes to 3e−15 J.");
  assert.equal(energySentence({ energy: { ...energy, dissipated_friction: 2, work_in: 5 }, impacts: 3 }),
    "Lost 26.5 J in 3 impacts and 2 J to friction and took in 5 J by forces, from 200.7 J to 174.2 J; " +
    "the ledger closes to 3e−15 J.");
  assert.equal(energySentence({ energy: { ...energy, final: null, residual: null }, impacts: 1 }),
    "Its energy is more than a number holds.");
  assert.equal(energySentence({ energy: { ...energy, final: 200.67, dissipated_impacts: 0 }, impacts: 4 }),
    "Kept its energy, from 200.7 J to 200.7 J; the ledger closes to 3e−15 J.");
});

test("whether it was done", () => {
  const run = { status: "done", frames: 12, bodies: 2, steps: 3767 };
  assert.equal(runSentence(run), "Done: 12 frames of 2 bodies in 3\u202f767 steps.");
  assert.match(runSentence({ ...run, status: "diverged" }), /^The motion diverged: /);
});

test("events in words", () => {
  const impact = { kind: "impact", bodies: ["a", "b"], impulse_N_s: [0, 3, 4], approach_m_s: 2, separation_m_s: 1 };
  assert.deepEqual(eventText(impact), { who: "a · b", what: "5 N s, 2 → 1 m/s" });
  assert.deepEqual(eventText({ kind: "contact_end", bodies: ["a", "b"] }), { who: "a · b", what: "" });
  assert.deepEqual(eventText({ kind: "edit", name: "g", value: "2*t" }), { who: "g", what: "= 2*t" });
  assert.deepEqual(eventText({ kind: "restart", name: "egesp" }), { who: "egesp", what: "started again" });
});
