// The motion of a run that is over, in 16 bits a number: a tenth of a millimetre in a scene of seven metres.
//
// What every motion can do, recorded or live: `frames`, `times_s`, `facts` (columns of frames.csv), and per body and
// frame `position`, `rotation` and `velocity`, written into the array that is given.

import { normalize } from "./interpolate.js";

const TOP_U16 = 65535;
const TOP_I16 = 32767;

export class RecordedMotion {
  #arrays;
  #ranges;
  #first = [];  // of each body: its first frame among those of all bodies
  #moves = [];

  /** @param {{header: object, arrays: object}} run what unpack() gives */
  constructor({ header, arrays }) {
    this.frames = header.frames;
    this.times_s = arrays.time_s;
    this.#arrays = arrays;
    this.#ranges = header.arrays;
    this.facts = {};
    for (const [name, values] of Object.entries(arrays)) {
      if (name.startsWith("facts.")) this.facts[name.slice("facts.".length)] = values;
    }
    let first = 0;
    for (const body of header.bodies) {
      this.#first.push(first);
      this.#moves.push(body.frames > 1);
      first += body.frames;
    }
  }

  moves(body) {
    return this.#moves[body];
  }

  position(body, frame, out) {
    this.#vector("position", body, frame, out);
  }

  velocity(body, frame, out) {
    this.#vector("velocity", body, frame, out);
  }

  rotation(body, frame, out) {
    const row = 4 * this.#row(body, frame);
    for (let i = 0; i < 4; ++i) out[i] = this.#arrays.rotation[row + i] / TOP_I16;
    normalize(out);
  }

  #row(body, frame) {
    return this.#first[body] + (this.#moves[body] ? frame : 0);
  }

  #vector(name, body, frame, out) {
    const numbers = this.#arrays[name];
    const { low, high } = this.#ranges[name];
    const row = 3 * this.#row(body, frame);
    for (let i = 0; i < 3; ++i) {
      const at = 3 * body + i;
      out[i] = low[at] + (numbers[row + i] / TOP_U16) * (high[at] - low[at]);
    }
  }
}
