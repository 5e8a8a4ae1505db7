// The run's numbers: what summary.json holds, as a table.

import { element } from "./dom.js";
import { count, quantity } from "./format.js";

const LEDGER = [
  ["initial", "at the start"], ["work_in", "work of forces"], ["dissipated_impacts", "lost in impacts"],
  ["dissipated_friction", "lost to friction"], ["dissipated_damping", "lost to damping"], ["final", "at the end"],
  ["residual", "residual"],
];

/** @param {object} header of the payload */
export function summaryTables(place, { version, scene, summary }) {
  const vector = ([x, y, z], unit) => `(${quantity(x)}, ${quantity(y)}, ${quantity(z)}) ${unit}`;
  const { momentum } = summary;
  place.append(
    table("Run", [
      ["scene", scene], ["version", summary.version ?? version], ["status", summary.status],
      ["frames", count(summary.frames)], ["bodies", count(summary.bodies)], ["steps", count(summary.steps)],
      ["impacts", count(summary.impacts)], ["wall time", quantity(summary.wall_time_s, "s")],
      ["scene hash", summary.scene_hash], ["state hash", summary.state_hash],
    ]),
    table("Energy", LEDGER.map(([key, text]) => [text, quantity(summary.energy[key], "J")])),
    table("Momentum", [
      ["linear, at the start", vector(momentum.initial.linear, "kg m/s")],
      ["linear, at the end", vector(momentum.final.linear, "kg m/s")],
      ["angular, at the start", vector(momentum.initial.angular, "kg m²/s")],
      ["angular, at the end", vector(momentum.final.angular, "kg m²/s")],
    ]),
    table("Modules", modules(summary)));
}

function modules({ time_per_module: times_s = {}, messages_per_module: messages = {} }) {
  const names = [...new Set([...Object.keys(times_s), ...Object.keys(messages)])];
  return names.map((name) => [
    name,
    [times_s[name] === undefined ? "" : quantity(times_s[name], "s"),
     messages[name] === undefined ? "" : `${count(messages[name])} messages`].filter(Boolean).join(", "),
  ]);
}

const table = (caption, rows) =>
  element("table", {}, element("caption", {}, caption), element("tbody", {},
    ...rows.map(([name, value]) =>
      element("tr", {}, element("th", { scope: "row" }, name), element("td", {}, value ?? "")))));
