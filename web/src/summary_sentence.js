// A run in sentences that a person reads: was it done, where did the energy go, do the numbers add up.

import { count, plural, quantity } from "./format.js";

const STATUS = { done: "Done", interrupted: "Interrupted", diverged: "The motion diverged" };
const NOTHING = 1e-12;  // of the energy at hand: what is less was not lost but rounded

/** @param {object} summary as in summary.json */
export function runSentence({ status, frames, bodies, steps }) {
  return `${STATUS[status] ?? status}: ${plural(frames, "frame")} of ${many(bodies)} in ${plural(steps, "step")}.`;
}

const many = (bodies) => (bodies === 1 ? "1 body" : `${count(bodies)} bodies`);

/** @param {object} summary as in summary.json */
export function energySentence({ energy, impacts }) {
  const { initial, final, work_in: work, residual } = energy;
  if (residual === null) return "Its energy is more than a number holds.";  // JSON has no infinity
  const parts = [
    [energy.dissipated_impacts, `in ${plural(impacts, "impact")}`],
    [energy.dissipated_friction, "to friction"],
    [energy.dissipated_damping, "to damping"],
  ];
  const scale = Math.max(Math.abs(initial), Math.abs(final), Math.abs(work), ...parts.map(([value]) => value));
  const matters = (value) => Math.abs(value) > NOTHING * scale;
  const lost = parts.filter(([value]) => matters(value)).map(([value, cause]) => `${quantity(value, "J")} ${cause}`);
  const story = [
    lost.length ? `lost ${list(lost)}` : "",
    matters(work) ? `${work > 0 ? "took in" : "gave away"} ${quantity(Math.abs(work), "J")} by forces` : "",
  ].filter(Boolean);
  const what = story.length ? capital(list(story)) : "Kept its energy";
  return `${what}, from ${quantity(initial, "J")} to ${quantity(final, "J")}; ` +
    `the ledger closes to ${quantity(Math.abs(residual), "J")}.`;
}

const list = (items) =>
  items.length < 2 ? items.join("") : `${items.slice(0, -1).join(", ")} and ${items[items.length - 1]}`;

const capital = (text) => text[0].toUpperCase() + text.slice(1);
