// What is plotted: the columns of frames.csv under the names that people use for them, and the chosen body's motion.

const AXES = ["x", "y", "z"];

/** @typedef {{id: string, title: string, unit: string, lines: {label: string, values: ArrayLike<number>}[]}} Plot */

/** @param {Record<string, ArrayLike<number>>} facts @returns {Plot[]} those of the whole scene */
export function scenePlots(facts) {
  const plots = [
    { id: "energy", title: "Energy", unit: "J", lines: energies(facts) },
    { id: "residual", title: "Residual of the energy ledger", unit: "J", lines: [line("residual", facts.residual_J)] },
    { id: "momentum", title: "Momentum", unit: "kg m/s", lines: vector(facts, "p", "_kg_m_s") },
    { id: "angular-momentum", title: "Angular momentum", unit: "kg m²/s", lines: vector(facts, "l", "_kg_m2_s") },
    { id: "contacts", title: "Contact points", unit: "", lines: [line("points", facts.contacts)] },
    { id: "step", title: "Length of a step", unit: "ms", lines: [line("step", steps_ms(facts.step_s))] },
  ];
  return plots.filter((plot) => plot.lines.every(({ values }) => values));
}

function energies(facts) {
  const kinds = ["kinetic", "potential", "elastic"].map((kind) => line(kind, facts[`${kind}_J`]));
  const lost = ["impacts", "friction", "damping"].map((cause) => facts[`dissipated_${cause}_J`]);
  const rest = [line("total", sum(kinds.map(({ values }) => values))), line("lost", sum(lost)),
                line("work in", facts.work_in_J)];
  // A kind that is not in this scene would be a line along zero.
  return [...kinds, ...rest].filter(({ label, values }) => label === "total" || !values || isThere(values));
}

/** @param {string} name of the body @returns {Plot[]} */
export function bodyPlots(motion, body, name) {
  const position = series(motion, (frame, out) => motion.position(body, frame, out));
  const velocity = series(motion, (frame, out) => motion.velocity(body, frame, out));
  const speed = velocity[0].map((_, frame) => Math.hypot(...velocity.map((values) => values[frame])));
  return [
    { id: "position", title: `Position of ${name}`, unit: "m", lines: AXES.map((axis, i) => line(axis, position[i])) },
    { id: "velocity", title: `Velocity of ${name}`, unit: "m/s",
      lines: [...AXES.map((axis, i) => line(axis, velocity[i])), line("speed", speed)] },
  ];
}

const line = (label, values) => ({ label, values });

const vector = (facts, letter, unit) => AXES.map((axis) => line(axis, facts[`${letter}${axis}${unit}`]));

// Before the first frame there was no step: a gap.
const steps_ms = (steps_s) => steps_s && Array.from(steps_s, (step_s) => (step_s > 0 ? 1000 * step_s : null));

const isThere = (values) => values.some((value) => Math.abs(value) > 1e-12);

function sum(columns) {
  if (!columns.every(Boolean)) return undefined;
  return Float64Array.from(columns[0], (_, frame) => columns.reduce((total, column) => total + column[frame], 0));
}

function series(motion, read) {
  const out = [0, 0, 0];
  const columns = AXES.map(() => new Float64Array(motion.frames));
  for (let frame = 0; frame < motion.frames; ++frame) {
    read(frame, out);
    for (let i = 0; i < 3; ++i) columns[i][frame] = out[i];
  }
  return columns;
}
