// An event in words. Kinds are told apart by sign and name; their colour only helps.

import { quantity } from "./format.js";

export const KINDS = {
  impact: { sign: "◆", name: "impact" },
  contact_begin: { sign: "▼", name: "contact begins" },
  contact_end: { sign: "△", name: "contact ends" },
  edit: { sign: "✎", name: "edit" },
  restart: { sign: "↻", name: "restart" },
};

/** Who met whom, how fast and how hard; or what was set. @returns {{who: string, what: string}} */
export function eventText(event) {
  const who = (event.bodies ?? []).join(" · ");
  switch (event.kind) {
    case "impact":
      return { who, what: [impulseText(event), speedsText(event)].filter(Boolean).join(", ") };
    case "edit":
      return { who: event.name ?? who, what: event.value ? `= ${event.value}` : "" };
    case "restart":
      return { who: event.name ?? who, what: "started again" };
    default:
      return { who, what: "" };
  }
}

const impulseText = ({ impulse_N_s: impulse }) => impulse && quantity(Math.hypot(...impulse), "N s");

function speedsText({ approach_m_s: before, separation_m_s: after }) {
  if (before === undefined || after === undefined) return "";
  return `${quantity(before)} → ${quantity(after, "m/s")}`;
}
