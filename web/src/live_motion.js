// The motion of a run that goes on: it grows by a frame at a time. It answers as RecordedMotion does; velocities are
// not sent and come from the positions.

const MEMORY_BYTES = 256e6;  // more than that and the older half is forgotten: a live window may stay open for days

export class LiveMotion {
  times_s = [];
  facts = {};
  #bodies;
  #poses = [];  // a frame: x, y, z of each body, then w, x, y, z of each
  #kept;

  /** @param {{motion: string}[]} bodies as in bodies.json */
  constructor(bodies) {
    this.#bodies = bodies;
    this.#kept = Math.max(100, Math.floor(MEMORY_BYTES / (28 * bodies.length + 200)));
  }

  get frames() {
    return this.times_s.length;
  }

  /** @param {{time_s: number, position: number[], rotation: number[], facts: object}} frame a message of the server */
  push({ time_s, position, rotation, facts }) {
    if (this.frames >= this.#kept) this.#forget(this.frames >> 1);
    this.times_s.push(time_s);
    const poses = new Float32Array(7 * this.#bodies.length);
    poses.set(position);
    poses.set(rotation, position.length);
    this.#poses.push(poses);
    for (const [name, value] of Object.entries(facts)) (this.facts[name] ??= []).push(value);
  }

  moves(body) {
    return this.#bodies[body].motion !== "static";
  }

  position(body, frame, out) {
    const poses = this.#poses[frame];
    for (let i = 0; i < 3; ++i) out[i] = poses[3 * body + i];
  }

  rotation(body, frame, out) {
    const poses = this.#poses[frame];
    for (let i = 0; i < 4; ++i) out[i] = poses[3 * this.#bodies.length + 4 * body + i];
  }

  velocity(body, frame, out) {
    const before = Math.max(0, frame - 1);
    const elapsed_s = this.times_s[frame] - this.times_s[before] || Infinity;
    for (let i = 0; i < 3; ++i) {
      out[i] = (this.#poses[frame][3 * body + i] - this.#poses[before][3 * body + i]) / elapsed_s;
    }
  }

  #forget(frames) {
    this.times_s.splice(0, frames);
    this.#poses.splice(0, frames);
    for (const values of Object.values(this.facts)) values.splice(0, frames);
  }
}
