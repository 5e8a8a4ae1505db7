// Between two frames: positions on a straight line, rotations on the shortest arc (slerp).

const from = new Float64Array(4);
const to = new Float64Array(4);

/** A body's pose at a bracket as seven numbers from out[at] on: x, y, z, then the quaternion's w, x, y, z. */
export function pose(motion, body, { frame, fraction }, out, at) {
  motion.position(body, frame, from);
  const moves = fraction > 0 && motion.moves(body);
  if (moves) motion.position(body, frame + 1, to);
  for (let i = 0; i < 3; ++i) out[at + i] = moves ? from[i] + fraction * (to[i] - from[i]) : from[i];
  motion.rotation(body, frame, from);
  if (moves) {
    motion.rotation(body, frame + 1, to);
    slerp(from, to, fraction, from);
  }
  for (let i = 0; i < 4; ++i) out[at + 3 + i] = from[i];
}

/** Unit quaternions a and b; the result is a unit quaternion, and may be one of them. */
export function slerp(a, b, fraction, out) {
  let cosine = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
  const side = cosine < 0 ? -1 : 1;  // q and −q turn alike: take the nearer
  cosine *= side;
  const angle = Math.acos(Math.min(1, cosine));
  const keep = angle ? Math.sin((1 - fraction) * angle) : 1 - fraction;
  const take = (angle ? Math.sin(fraction * angle) : fraction) * side;
  for (let i = 0; i < 4; ++i) out[i] = keep * a[i] + take * b[i];
  return normalize(out);
}

export function normalize(q) {
  const length = Math.hypot(q[0], q[1], q[2], q[3]) || 1;
  for (let i = 0; i < 4; ++i) q[i] /= length;
  return q;
}
