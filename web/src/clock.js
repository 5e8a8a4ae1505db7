// The one time that the whole page shows: the player, the cursors of the plots, the mark in the list of events.
// Who wants to show another moment asks the clock, and hears of it from the clock like everybody else.
//
// Events: "time" when the moment changed, "state" when it began or ceased to play or its speed or range changed.

export const SPEEDS = [1 / 8, 1 / 4, 1 / 2, 1, 2, 4, 8];

const READ_EVERY_MS = 120;  // numbers and rows that change faster cannot be read

/** Whether what is read rather than looked at is due: always while the clock stands, now and then while it plays. */
export class Readable {
  #clock;
  #before_ms = -Infinity;

  constructor(clock) {
    this.#clock = clock;
  }

  due(now_ms = performance.now()) {
    if (this.#clock.playing && now_ms - this.#before_ms < READ_EVERY_MS) return false;
    this.#before_ms = now_ms;
    return true;
  }
}

export class Clock extends EventTarget {
  time_s;
  playing = false;
  speed = 1;

  constructor(start_s, end_s) {
    super();
    this.start_s = this.time_s = start_s;
    this.end_s = end_s;
  }

  goTo(time_s) {
    const moment_s = Math.min(this.end_s, Math.max(this.start_s, time_s));
    if (moment_s === this.time_s) return;
    this.time_s = moment_s;
    this.dispatchEvent(new Event("time"));
  }

  /** From the start again, if it stood at the end. */
  play() {
    if (this.time_s >= this.end_s) this.goTo(this.start_s);
    this.#set("playing", true);
  }

  pause() {
    this.#set("playing", false);
  }

  setSpeed(speed) {
    this.#set("speed", speed);
  }

  /** The next of SPEEDS, or the one before. */
  changeSpeed(by) {
    const now = SPEEDS.findIndex((speed) => speed >= this.speed);
    this.setSpeed(SPEEDS[Math.min(SPEEDS.length - 1, Math.max(0, now + by))]);
  }

  /** While it plays: the moment that is shown after so long in front of the screen. */
  advance(elapsed_s) {
    if (!this.playing) return;
    this.goTo(this.time_s + elapsed_s * this.speed);
    if (this.time_s >= this.end_s) this.pause();
  }

  /** A live run knows more of itself with every frame. */
  setRange(start_s, end_s) {
    this.start_s = start_s;
    this.#set("end_s", end_s);
  }

  #set(field, value) {
    if (this[field] === value) return;
    this[field] = value;
    this.dispatchEvent(new Event("state"));
  }
}
