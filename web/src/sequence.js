// The traffic of the five modules in one step, as a sequence diagram.

import { element, svg } from "./dom.js";
import { count, plural, quantity } from "./format.js";
import { layout, MODULES } from "./sequence_layout.js";

const LEFT_PX = 72;
const LANE_PX = 112;
const TOP_PX = 40;
const ROW_PX = 19;
const SHOWN = 200;  // messages; a crowded step has thousands, and they are more of the same

const laneOf = (module) => LEFT_PX + (Math.max(0, MODULES.indexOf(module)) + 0.5) * LANE_PX;

/** @param {{time_s: number, step: number, span_us: number, messages: object[]} | null} traffic */
export function sequence(place, traffic) {
  if (!traffic?.messages.length) {
    place.append(element("p", { class: "note" },
      "This run has no messages to show: its five parts ran as one process, or its logs are not there."));
    return;
  }
  const messages = traffic.messages.slice(0, SHOWN);
  const rest = traffic.messages.length - messages.length;
  const text = `Step ${count(traffic.step)}, at ${quantity(traffic.time_s, "s")}: ` +
    `${plural(traffic.messages.length, "message")} in ${quantity(traffic.span_us, "µs")}.`;
  place.append(element("p", { class: "note" }, rest ? `${text} The first ${SHOWN} are shown.` : text),
    element("div", { class: "wide", tabindex: 0, role: "group", "aria-label": "Sequence diagram" },
      diagram(messages, text)));
}

function diagram(messages, description) {
  const { rows, busy } = layout(messages);
  const width = LEFT_PX + MODULES.length * LANE_PX;
  const height = TOP_PX + (rows.length + 1) * ROW_PX;
  const y = (row) => TOP_PX + (row + 1) * ROW_PX;
  return svg("svg", { viewBox: `0 0 ${width} ${height}`, width, height, role: "img", "aria-label": description },
    arrowheads(),
    ...MODULES.map((module) => lifeline(module, height)),
    ...busy.map(({ module, first, last, depth }) =>
      svg("rect", { class: "busy", x: laneOf(module) - 3 + 3 * depth, width: 6,
                    y: y(first), height: Math.max(2, y(last) - y(first)) })),
    ...rows.map((row, i) => arrow(row, y(i))));
}

const arrowheads = () =>
  svg("defs", {}, ...["request", "reply"].map((kind) =>
    svg("marker", { id: `head-${kind}`, class: kind, viewBox: "0 0 8 8", refX: 7.5, refY: 4, markerWidth: 8,
                    markerHeight: 8, markerUnits: "userSpaceOnUse", orient: "auto" },
      svg("path", { d: kind === "request" ? "M0 0.5 L8 4 L0 7.5 Z" : "M1 1 L7.5 4 L1 7" }))));

function lifeline(module, height) {
  const x = laneOf(module);
  return svg("g", { class: "lifeline" },
    svg("rect", { x: x - 50, y: 8, width: 100, height: 24, rx: 4 }),
    svg("text", { x, y: 24, "text-anchor": "middle" }, module),
    svg("line", { x1: x, x2: x, y1: 32, y2: height }));
}

function arrow({ kind, at_us, from, to, text }, y) {
  const start = laneOf(from);
  const end = laneOf(to);
  const side = Math.sign(end - start);
  return svg("g", { class: kind },
    svg("text", { class: "at", x: LEFT_PX - 8, y: y + 4, "text-anchor": "end" }, `${at_us.toFixed(1)} µs`),
    svg("line", { x1: start + 4 * side, x2: end - 4 * side, y1: y, y2: y, "marker-end": `url(#head-${kind})` }),
    svg("text", { x: start + 10 * side, y: y - 4, "text-anchor": side > 0 ? "start" : "end" }, text));
}
