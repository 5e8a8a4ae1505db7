// The plots under one cursor.

import { Readable } from "./clock.js";
import { oncePerFrame } from "./dom.js";
import { Plot } from "./plot.js";
import { bodyPlots, scenePlots } from "./series.js";

export class Plots {
  #run;
  #clock;
  #choice;
  #sparing;
  #plots = new Map();
  #place;
  #values;
  #seen = new Set();
  #watch;

  /** @param {boolean} sparing while it plays the cursor moves only as often as its values are read anew */
  constructor(place, run, clock, choice, sparing) {
    this.#place = place;
    this.#run = run;
    this.#clock = clock;
    this.#choice = choice;
    this.#sparing = sparing;
    this.#values = new Readable(clock);
    const update = oncePerFrame(() => this.#showTime());
    this.#watch = new IntersectionObserver((entries) => {
      for (const { target, isIntersecting } of entries) this.#seen[isIntersecting ? "add" : "delete"](target);
      update();
    });
    for (const kind of ["time", "state"]) clock.addEventListener(kind, update);
    choice.addEventListener("change", () => this.refresh());
    this.refresh();
  }

  /** Reads the run again: another body was chosen, or a live run has grown. */
  refresh() {
    const { motion, bodies } = this.#run;
    if (!motion.frames) return;
    const body = this.#choice.body;
    const wanted = [...scenePlots(motion.facts), ...bodyPlots(motion, body, bodies[body].name)];
    for (const data of wanted) this.#plot(data.id).setData(motion.times_s, data);
    this.#showTime();
  }

  #plot(id) {
    if (!this.#plots.has(id)) {
      const plot = new Plot(id, this.#clock);
      this.#plots.set(id, plot);
      this.#place.append(plot.node);
      this.#watch.observe(plot.node);
    }
    return this.#plots.get(id);
  }

  /** Takes the page's colours anew. */
  paint() {
    for (const plot of this.#plots.values()) plot.draw();
    this.#showTime();
  }

  #showTime() {
    const with_values = this.#values.due();
    if (this.#sparing && !with_values) return;
    for (const plot of this.#plots.values()) {
      if (this.#seen.has(plot.node)) plot.showTime(this.#clock.time_s, with_values);
    }
  }
}
