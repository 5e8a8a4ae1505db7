// What the transport's buttons do while a run goes on: they steer the run itself. Who scrubs into the past looks at
// the past until "now" is asked for.

import { byId } from "./dom.js";
import { SPEEDS } from "./clock.js";
import { count, speedText } from "./format.js";

export class LiveRun {
  at_now = true;
  running = true;
  speed = 1;
  #clock;
  #send;
  #going = false;

  /** @param {import("./transport.js").Playback} playback for the past */
  constructor(clock, playback, send, changed) {
    this.#clock = clock;
    this.playback = playback;
    this.#send = send;
    clock.addEventListener("time", () => {
      if (this.#going || !this.at_now) return;
      this.at_now = false;
      changed();
    });
    byId("live-step").addEventListener("click", () => this.#step());
    byId("live-now").addEventListener("click", () => {
      this.#toNow();
      changed();
    });
  }

  toggle() {
    this.#send({ type: this.running ? "pause" : "resume" });
  }

  changeSpeed(by) {
    const speeds = [...SPEEDS, 0];  // beyond the fastest: as fast as it goes
    const now = this.speed === 0 ? SPEEDS.length : speeds.findIndex((speed) => speed >= this.speed);
    this.#send({ type: "speed", value: speeds[Math.min(speeds.length - 1, Math.max(0, now + by))] });
  }

  /** A frame on: of what was seen, or, at its end, of the run itself, which then stands. */
  step(by) {
    if (by > 0 && this.at_now) this.#step();
    else this.playback.step(by);
  }

  #step() {
    this.#toNow();
    this.#send({ type: "step" });
  }

  pace({ paused, speed }) {
    this.running = !paused;
    this.speed = speed;
  }

  /** There are frames from one time to another. */
  grown(start_s, end_s) {
    this.#clock.setRange(start_s, end_s);
    if (this.at_now) this.#toNow();
  }

  #toNow() {
    this.#going = true;
    this.at_now = true;
    this.#clock.goTo(this.#clock.end_s);
    this.#going = false;
  }

  text(frames, of) {
    const pace = this.running ? `running, ${speedText(this.speed)}` : "paused";
    return `Live: frame ${count(frames)} of ${count(of)}, ${pace}`;
  }

  end() {
    this.at_now = true;
    byId("live-step").disabled = true;
    byId("live-now").hidden = true;
  }
}
