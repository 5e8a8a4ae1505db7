// The buttons under the picture, and the slider: a face of the clock, or of the live run.

import { Readable } from "./clock.js";
import { byId } from "./dom.js";
import { seconds, speedText } from "./format.js";
import { bracket } from "./moments.js";

const PLAY = "M3 1.5 L14 8 L3 14.5 Z";
const PAUSE = "M3 2 H6.5 V14 H3 Z M9.5 2 H13 V14 H9.5 Z";

/** What the buttons do to a run that is over; live.js offers the same for one that goes on. */
export class Playback {
  constructor(clock, motion) {
    this.clock = clock;
    this.motion = motion;
  }
  get running() { return this.clock.playing; }
  get speed() { return this.clock.speed; }
  toggle() { this.clock.playing ? this.clock.pause() : this.clock.play(); }
  changeSpeed(by) { this.clock.changeSpeed(by); }

  /** To a frame before or after, exactly. */
  step(by) {
    const { clock, motion } = this;
    clock.pause();
    const { frame, fraction } = bracket(motion.times_s, clock.time_s);
    const next = by > 0 ? frame + 1 : fraction > 0 ? frame : frame - 1;
    clock.goTo(motion.times_s[Math.min(motion.frames - 1, Math.max(0, next))]);
  }
}

/**
 * @param {() => Playback} driver who obeys the buttons now
 * @param {number} step_s between frames: how many digits a time needs
 * @returns {() => void} to call when the driver's state changed
 */
export function transport(clock, driver, step_s) {
  const scrub = byId("scrub");
  const path = byId("play").querySelector("path");
  byId("play").addEventListener("click", () => driver().toggle());
  byId("slower").addEventListener("click", () => driver().changeSpeed(-1));
  byId("faster").addEventListener("click", () => driver().changeSpeed(1));
  scrub.addEventListener("input", () => {
    const time_s = Number(scrub.value);
    clock.pause();
    clock.goTo(time_s);
  });
  const readable = new Readable(clock);
  const tellTime = () => {
    scrub.value = clock.time_s;
    if (!readable.due()) return;
    const text = `${seconds(clock.time_s, step_s)} s`;
    byId("time").textContent = text;
    scrub.setAttribute("aria-valuetext", text);
  };
  const tellState = () => {
    const { running, speed } = driver();
    [scrub.min, scrub.max] = [clock.start_s, clock.end_s];
    path.setAttribute("d", running ? PAUSE : PLAY);
    byId("play").setAttribute("aria-label", running ? "Pause" : "Play");
    byId("speed").textContent = speedText(speed);
    tellTime();
  };
  clock.addEventListener("time", tellTime);
  clock.addEventListener("state", tellState);
  tellState();
  return tellState;
}
