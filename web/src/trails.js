// Where bodies have been: a line from the first frame to now.

import { BufferAttribute, BufferGeometry, Color, Group, Line, LineBasicMaterial } from "three";

const MANY = 40;  // more lines than that are a tangle: only the chosen body has one

export class Trails extends Group {
  #bodies;
  #motion;
  #lines = new Map();

  constructor(bodies, motion) {
    super();
    this.#bodies = bodies;
    this.#motion = motion;
  }

  /** @param {number} frame the last one that was; the line ends there, and at the body itself */
  show(frame, poses, chosen) {
    const moving = this.#bodies.map((_, body) => body).filter((body) => this.#motion.moves(body));
    const drawn = new Set(moving.length <= MANY ? moving : moving.filter((body) => body === chosen));
    for (const [body, line] of this.#lines) line.visible = drawn.has(body);
    for (const body of drawn) this.#extend(this.#line(body), body, frame, poses);
  }

  #line(body) {
    const room = this.#motion.frames + 1;
    let line = this.#lines.get(body);
    if (line && line.userData.room >= room) return line;
    line?.geometry.dispose();
    line ??= this.#newLine(body);
    const points = new Float32Array(3 * 2 * room);  // twice: the next frames of a live run find room
    line.geometry = new BufferGeometry().setAttribute("position", new BufferAttribute(points, 3));
    line.userData = { room: 2 * room, filled: 0, first_s: this.#motion.times_s[0] };
    return line;
  }

  #newLine(body) {
    const color = new Color().setRGB(...this.#bodies[body].color, "srgb");
    const line = new Line(undefined, new LineBasicMaterial({ color, transparent: true, opacity: 0.75 }));
    line.frustumCulled = false;
    this.#lines.set(body, line);
    this.add(line);
    return line;
  }

  #extend(line, body, frame, poses) {
    const points = line.geometry.attributes.position;
    const known = line.userData;
    if (known.first_s !== this.#motion.times_s[0]) known.filled = 0;  // a live run forgot its first frames
    known.first_s = this.#motion.times_s[0];
    const place = [0, 0, 0];
    for (let i = known.filled; i <= frame; ++i) {
      this.#motion.position(body, i, place);
      points.array.set(place, 3 * i);
    }
    points.array.set(poses.subarray(7 * body, 7 * body + 3), 3 * (frame + 1));
    known.filled = frame + 1;  // the point after it is the body's own place, and is overwritten
    points.needsUpdate = true;
    line.geometry.setDrawRange(0, frame + 2);
  }
}
