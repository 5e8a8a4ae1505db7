// How far a solid reaches: for bounding boxes, and to fit the camera and the light to what moves.

/**
 * The box along the world's axes around a solid that is turned, about the body's origin. Planes have none.
 * @param {number[]} turn its rotation matrix, row after row
 * @returns {boolean} whether there is one, written to low and high
 */
export function worldBounds(shape, turn, low, high) {
  if (shape.kind === "plane") return false;
  for (let axis = 0; axis < 3; ++axis) {
    const row = turn.slice(3 * axis, 3 * axis + 3);
    [low[axis], high[axis]] = reach(shape, row);
  }
  return true;
}

// From where to where a solid reaches along a direction that is given in its own axes.
function reach(shape, direction) {
  const lean = direction[1];
  const { radius_m: radius, height_m: height } = shape;
  const rim = radius * Math.sqrt(Math.max(0, 1 - lean * lean));
  switch (shape.kind) {
    case "sphere":
      return [-radius, radius];
    case "box": {
      const half = shape.size_m.reduce((sum, size, i) => sum + (size / 2) * Math.abs(direction[i]), 0);
      return [-half, half];
    }
    case "capsule":
      return symmetric((height / 2) * Math.abs(lean) + radius);
    case "cylinder":
      return symmetric((height / 2) * Math.abs(lean) + rim);
    case "cone":  // its apex, and the rim of its base
      return [
        Math.min(0.75 * height * lean, -0.25 * height * lean - rim),
        Math.max(0.75 * height * lean, -0.25 * height * lean + rim),
      ];
    case "hull": {
      const along = shape.vertices_m.map((v) => v[0] * direction[0] + v[1] * lean + v[2] * direction[2]);
      return [Math.min(...along), Math.max(...along)];
    }
    default:
      throw new Error(`a shape of an unknown kind: ${shape.kind}`);
  }
}

const symmetric = (half) => [-half, half];

/** The radius of a ball about the body's origin that holds the solid. */
export function reachRadius(shape) {
  const { radius_m: radius, height_m: height } = shape;
  switch (shape.kind) {
    case "sphere":
      return radius;
    case "box":
      return Math.hypot(...shape.size_m) / 2;
    case "capsule":
      return height / 2 + radius;
    case "cylinder":
      return Math.hypot(height / 2, radius);
    case "cone":
      return Math.max(0.75 * height, Math.hypot(height / 4, radius));
    case "hull":
      return Math.max(...shape.vertices_m.map((v) => Math.hypot(...v)));
    default:
      return 0;
  }
}

/** The rotation matrix of a unit quaternion w, x, y, z that starts at q[at], row after row. */
export function rotationMatrix(q, at, out) {
  const w = q[at], x = q[at + 1], y = q[at + 2], z = q[at + 3];
  out[0] = 1 - 2 * (y * y + z * z), out[1] = 2 * (x * y - w * z), out[2] = 2 * (x * z + w * y);
  out[3] = 2 * (x * y + w * z), out[4] = 1 - 2 * (x * x + z * z), out[5] = 2 * (y * z - w * x);
  out[6] = 2 * (x * z - w * y), out[7] = 2 * (y * z + w * x), out[8] = 1 - 2 * (x * x + y * y);
  return out;
}

const SAMPLES = 60;

/**
 * A box around everything that happens: the bodies that move, at some of the frames, and what stands still.
 * @returns {{low: number[], high: number[]}}
 */
export function motionBounds(bodies, motion) {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  const place = [0, 0, 0];
  bodies.forEach((body, i) => {
    if (body.shape.kind === "plane") return;
    const radius = reachRadius(body.shape);
    const samples = motion.moves(i) ? Math.min(SAMPLES, motion.frames) : 1;
    for (let sample = 0; sample < samples; ++sample) {
      motion.position(i, Math.round((sample / Math.max(1, samples - 1)) * (motion.frames - 1)), place);
      for (let axis = 0; axis < 3; ++axis) {
        low[axis] = Math.min(low[axis], place[axis] - radius);
        high[axis] = Math.max(high[axis], place[axis] + radius);
      }
    }
  });
  return low[0] <= high[0] ? { low, high } : { low: [-1, 0, -1], high: [1, 2, 1] };
}
