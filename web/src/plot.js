// One plot: uPlot draws axes and lines; the cursor and the values beside the names are the page's own, because they
// show the clock's time whether a pointer is there or not.

import uPlot from "uplot";
import { element } from "./dom.js";
import { quantity } from "./format.js";
import { nearest } from "./moments.js";
import { colorOf } from "./theme.js";

const HEIGHT_PX = 150;
// Lines are told apart by dashes too.
const DASHES = [[], [7, 4], [2, 3], [10, 3, 2, 3], [4, 4], [1, 4]];
const COLORS = ["--series-1", "--series-2", "--series-3", "--series-4", "--series-5", "--series-6"];

export class Plot {
  #times_s = [];
  #lines = [];
  #chart = null;
  #cursor = element("div", { class: "cursor" });
  #legend = element("span", { class: "legend" });
  #title = element("h3");
  #area = element("div", { class: "area" });
  #values = [];

  /** @param {import("./clock.js").Clock} clock */
  constructor(id, clock) {
    this.node = element("figure", { id: `plot-${id}`, class: "plot" },
      element("figcaption", {}, this.#title, this.#legend), this.#area);
    new ResizeObserver(() => this.#resize()).observe(this.#area);
    this.#listen(clock);
  }

  // A mouse moves the player while it passes over a plot of a clock that stands; a click or a finger always.
  #listen(clock) {
    const go = (event) => {
      const box = this.#chart.over.getBoundingClientRect();
      clock.goTo(this.#chart.posToVal(event.clientX - box.left, "x"));
    };
    const inside = (event) => this.#chart?.over.contains(event.target);
    this.#area.addEventListener("pointerdown", (event) => {
      if (!inside(event)) return;
      clock.pause();
      go(event);
    });
    this.#area.addEventListener("pointermove", (event) => {
      if (inside(event) && !clock.playing && (event.buttons || event.pointerType === "mouse")) go(event);
    });
  }

  /** @param {import("./series.js").Plot} plot */
  setData(times_s, { title, unit, lines }) {
    const same = this.#lines.length === lines.length && this.#lines.every((l, i) => l.label === lines[i].label);
    this.#times_s = times_s;
    this.#lines = lines;
    this.unit = unit;
    this.#title.textContent = unit ? `${title} [${unit}]` : title;
    if (same && this.#chart) this.#chart.setData(this.#data());
    else this.draw();
  }

  #data() {
    return [this.#times_s, ...this.#lines.map(({ values }) => values)];
  }

  /** From nothing: at first, and when colours changed. */
  draw() {
    this.#chart?.destroy();
    this.#legend.replaceChildren(...this.#lines.map((line, i) => this.#name(line, i)));
    this.#values = [...this.#legend.querySelectorAll("output")];
    const axis = { stroke: colorOf("--muted"), font: "11px system-ui, sans-serif", ticks: { show: false },
                   grid: { stroke: colorOf("--line"), width: 1 } };
    this.#chart = new uPlot({
      width: this.#area.clientWidth || 320, height: HEIGHT_PX, padding: [6, 8, 0, 0],
      legend: { show: false }, cursor: { show: false }, scales: { x: { time: false }, y: { range } },
      axes: [{ ...axis, size: 24, space: 60, values: texts }, { ...axis, size: 58, space: 28, values: texts }],
      series: [{}, ...this.#lines.map((line, i) => ({
        stroke: colorOf(COLORS[i % COLORS.length]), width: 1.6, dash: DASHES[i % DASHES.length],
        points: { show: false } }))],
    }, this.#data(), this.#area);
    this.#chart.over.append(this.#cursor);
  }

  #name({ label }, i) {
    const swatch = element("canvas", { width: 36, height: 8, class: "swatch", "aria-hidden": "true" });
    const pen = swatch.getContext("2d");
    pen.strokeStyle = colorOf(COLORS[i % COLORS.length]);
    pen.lineWidth = 3;
    pen.setLineDash(DASHES[i % DASHES.length].map((length) => 2 * length));
    pen.moveTo(0, 4);
    pen.lineTo(36, 4);
    pen.stroke();
    return element("span", {}, swatch, `${label} `, element("output"));
  }

  #resize() {
    const width = this.#area.clientWidth;
    if (this.#chart && width && width !== this.#chart.width) this.#chart.setSize({ width, height: HEIGHT_PX });
  }

  /** Puts the cursor at a time; the values too, unless there is a hurry. */
  showTime(time_s, with_values) {
    if (!this.#chart || !this.#times_s.length) return;
    this.#cursor.style.transform = `translateX(${this.#chart.valToPos(time_s, "x")}px)`;
    if (!with_values) return;
    const frame = nearest(this.#times_s, time_s);
    this.#lines.forEach(({ values }, i) => (this.#values[i].textContent = quantity(values[frame])));
  }
}

// A line of zeros lies at the bottom; everything else as uPlot thinks best.
const range = (chart, low, high) => (low === 0 && high === 0 ? [0, 1] : uPlot.rangeNum(low, high, 0.1, true));

const texts = (chart, splits) => splits.map((value) => quantity(value));
