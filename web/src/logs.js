// The logs of the modules, a column each, as they come. The newest lines are kept.

import { element, oncePerFrame } from "./dom.js";

const KEPT = 300;
const NEAR_PX = 24;  // a column that is scrolled to its end stays there

export class Logs {
  #columns = new Map();
  #draw = oncePerFrame(() => this.#flush());

  constructor(place, modules) {
    for (const module of modules) {
      const lines = element("pre", { class: "log", tabindex: 0, role: "log", "aria-label": `Log of ${module}`,
                                     "aria-live": "off" });
      this.#columns.set(module, { lines, waiting: [] });
      place.append(element("section", {}, element("h3", {}, module), lines));
    }
  }

  add(module, lines) {
    const column = this.#columns.get(module);
    if (!column) return;
    column.waiting.push(...lines.slice(-KEPT));
    if (column.waiting.length > KEPT) column.waiting.splice(0, column.waiting.length - KEPT);
    this.#draw();
  }

  #flush() {
    for (const column of this.#columns.values()) {
      if (!column.waiting.length) continue;
      const { lines } = column;
      const at_end = lines.scrollHeight - lines.scrollTop - lines.clientHeight < NEAR_PX;
      lines.append(...column.waiting.map((line) => element("span", { class: tone(line) }, `${short(line)}\n`)));
      column.waiting = [];
      while (lines.childNodes.length > KEPT) lines.firstChild.remove();
      if (at_end) lines.scrollTop = lines.scrollHeight;
    }
  }
}

// A column has no room for the day, and stands for its module.
const short = (line) => line.replace(/^\d+-\d+-\d+T(\S+\.\d{3})\d*Z \w+ \w+ /, "$1 ");
const tone = (line) => (/ (warning|error|critical) /.test(line) ? "loud" : null);
