// How finely the picture is drawn while it plays: as finely as leaves it smooth. Pixels are what can be had for less
// without anything missing from the picture.

const PICTURES = 12;         // are timed before it changes
const SLOW_MS = 27;          // a picture; 30 a second have 33
const QUICK_MS = 20;         // so that one step finer does not become slow again
const STEP = 0.8;            // of the pixels along a side
const COARSEST = 0.6;        // likewise, of the finest

export class Sharpness {
  ratio;
  #finest;
  #count = 0;
  #sum_ms = 0;

  /** @param {number} finest screen pixels a CSS pixel */
  constructor(finest) {
    this.ratio = this.#finest = finest;
  }

  /** @param {number} took_ms from one picture to the next, while it plays */
  tell(took_ms) {
    this.#sum_ms += took_ms;
    if (++this.#count < PICTURES) return;
    const mean_ms = this.#sum_ms / this.#count;
    this.#count = this.#sum_ms = 0;
    if (mean_ms > SLOW_MS) this.ratio = Math.max(this.ratio * STEP, this.#finest * COARSEST);
    if (mean_ms < QUICK_MS) this.ratio = Math.min(this.ratio / STEP, this.#finest);
  }
}
