// Pages to look at: two bodies as in the paper's example, or a thousand that bounce.
//
//   npm run build && node test/sample.mjs paper >paper.html && node test/sample.mjs many >many.html

import { encode, pack, quantized, turns } from "./pack.mjs";
import { template } from "./template.mjs";

const GRAVITY_M_S2 = 9.81;

/** @param {{bodies: object[], frames: number, step_s: number, at: (body: number, time_s: number) => object}} motion */
function payload({ name, text, bodies, frames, step_s, at, events, traffic = null }) {
  const times_s = Array.from({ length: frames }, (_, frame) => frame * step_s);
  const rows = bodies.map((body, i) => {
    body.frames = body.motion === "static" ? 1 : frames;
    return times_s.slice(0, body.frames).map((time_s) => at(i, time_s));
  });
  const column = (key) => rows.map((body) => body.map((state) => state[key]));
  const energies = times_s.map((_, frame) => energy(bodies, rows, frame));
  const first = energies[0].kinetic + energies[0].potential;
  const lost = energies.map(({ kinetic, potential }) => first - kinetic - potential);
  const momentum = (axis) => times_s.map((_, frame) =>
    bodies.reduce((sum, body, i) => sum + (body.mass_kg ?? 0) * (rows[i][frame] ?? rows[i][0]).velocity[axis], 0));
  const fact = (values) => ({ type: "f64", values });
  const zero = times_s.map(() => 0);
  const summary = {
    scene: `scenes/${name}.animado`, scene_hash: "6205388beef770e3", version: "0.1.0", status: "done", frames,
    bodies: bodies.length, steps: 40 * frames, impacts: events.filter(({ kind }) => kind === "impact").length,
    energy: { initial: first, final: first - lost.at(-1), work_in: 0, dissipated_impacts: lost.at(-1),
              dissipated_friction: 0, dissipated_damping: 0, residual: 2.8e-14 },
    momentum: { initial: { linear: [0, 0.19, 0], angular: [30, 20, 20] },
                final: { linear: [0, 0.19, 0], angular: [30, 20, 20] } },
    state_hash: "72af357d4dfef055", wall_time_s: 0.0855,
    time_per_module: { colisao: 0.0086, egesp: 0.0196, fred: 0.0226, interexpserv: 0.0002, controle: 0.0345 },
    messages_per_module: { colisao: 3776, egesp: 15364, fred: 15364, interexpserv: 14 },
  };
  const header = { format: 1, version: "0.1.0", scene: summary.scene, scene_text: text, summary, bodies, events, frames,
                   traffic };
  return pack(header, {
    time_s: { type: "f64", values: times_s },
    position: quantized(column("position")), rotation: turns(column("rotation")),
    velocity: quantized(column("velocity")), angular_velocity: quantized(column("spin")),
    "facts.step_s": fact(times_s.map((t) => (t ? step_s / 40 : 0))),
    "facts.contacts": fact(times_s.map((_, i) => i % 3)),
    "facts.kinetic_J": fact(energies.map((e) => e.kinetic)), "facts.potential_J": fact(energies.map((e) => e.potential)),
    "facts.elastic_J": fact(zero), "facts.work_in_J": fact(zero), "facts.dissipated_impacts_J": fact(lost),
    "facts.dissipated_friction_J": fact(zero), "facts.dissipated_damping_J": fact(zero),
    "facts.residual_J": fact(times_s.map((_, i) => 1e-15 * Math.sin(i))),
    "facts.px_kg_m_s": fact(momentum(0)), "facts.py_kg_m_s": fact(momentum(1)), "facts.pz_kg_m_s": fact(momentum(2)),
    "facts.lx_kg_m2_s": fact(zero.map(() => 30)), "facts.ly_kg_m2_s": fact(zero.map(() => 20)),
    "facts.lz_kg_m2_s": fact(zero.map(() => 20)),
  });
}

function energy(bodies, rows, frame) {
  let kinetic = 0, potential = 0;
  bodies.forEach(({ mass_kg: mass = 0 }, i) => {
    const { position, velocity } = rows[i][frame] ?? rows[i][0];
    kinetic += (mass / 2) * velocity.reduce((sum, v) => sum + v * v, 0);
    potential += mass * GRAVITY_M_S2 * position[1];
  });
  return { kinetic, potential };
}

const turn = ([x, y, z], angle) => {
  const length = Math.hypot(x, y, z) || 1;
  return [Math.cos(angle / 2), ...[x, y, z].map((v) => (v / length) * Math.sin(angle / 2))];
};

export function paper() {
  const hit_s = 1.142;
  const ball = { name: "esfera", motion: "dynamic", mass_kg: 2, color: [0.85, 0.42, 0.25],
                 shape: { kind: "sphere", radius_m: 1 } };
  const cube = { name: "cubo", motion: "dynamic", mass_kg: 1.7, color: [0.26, 0.5, 0.72],
                 shape: { kind: "box", size_m: [1, 1, 1] } };
  const at = (i, t) => {
    const after = Math.max(0, t - hit_s);
    const [y, speed, kick] = i === 0 ? [3, -0.5, 3.5] : [0, 0.7, -4.1];
    return { position: [0, y + speed * t + kick * after, (i ? -1 : 1) * 0.9 * after],
             velocity: [0, speed + (after && kick), after && (i ? -0.9 : 0.9)],
             rotation: i === 0 ? turn([1, 1, 1], 8.66 * t) : turn([1, 0, 0], 10 * t), spin: [5, 5, 5] };
  };
  const events = [{ time_s: hit_s, kind: "impact", bodies: ["esfera", "cubo"], point_m: [0, 1.46, -0.25],
                    normal: [0, 0.968, 0.25], impulse_N_s: [0, 6.06, 1.57], approach_m_s: 5.24, separation_m_s: 2.62 }];
  const text = "#####\n#          COLISAO\n#####\n\n##### CARACTERISTICAS DA ESFERA\n\nmassa                2.0\n" +
    "# a comment\nposicao inicial       (0., 3., 0.)\n\n##### TEMPO NA ANIMACAO\n\ntempo final          3.3\n";
  return payload({ name: "colisao", text, bodies: [ball, cube], frames: 12, step_s: 0.3, at, events, traffic: step() });
}

function step() {
  let now_us = 0;
  const messages = [];
  const ask = (from, to, method, took_us) => messages.push({ at_us: (now_us += 6), took_us, from, to, method });
  for (let stage = 0; stage < 4; ++stage) {
    ask("controle", "egesp", "solve_prepared", 21.4);
    now_us += 22;
    ask("controle", "fred", "stage", 13.9);
    now_us += 14;
  }
  ask("controle", "colisao", "sweep", 38.2);
  now_us += 40;
  ask("controle", "colisao", "respond", 64.9);
  ask("colisao", "egesp", "solve", 31.2);
  now_us += 60;
  ask("controle", "interexpserv", "changes", 7.4);
  return { time_s: 1.1419538200019728, step: 1327, span_us: now_us + 8, messages };
}

export function many(count = 1000, frames = 600) {
  const shapes = [
    { kind: "sphere", radius_m: 0.3 }, { kind: "box", size_m: [0.5, 0.4, 0.6] },
    { kind: "capsule", radius_m: 0.15, height_m: 0.4 }, { kind: "cylinder", radius_m: 0.25, height_m: 0.5 },
    { kind: "cone", radius_m: 0.3, height_m: 0.6 },
    { kind: "hull", vertices_m: [[0.4, 0, 0], [-0.4, 0, 0], [0, 0.4, 0], [0, -0.4, 0], [0, 0, 0.4], [0, 0, -0.4]],
      faces: [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]] },
  ];
  const side = Math.ceil(Math.sqrt(count));
  const floor = { name: "floor", motion: "static", mass_kg: null, color: [0.7, 0.7, 0.7],
                  shape: { kind: "plane", normal: [0, 1, 0], offset_m: 0 } };
  const color = (i) => [0.35 + 0.4 * ((i * 0.37) % 1), 0.4 + 0.3 * ((i * 0.61) % 1), 0.45 + 0.35 * ((i * 0.23) % 1)];
  const bodies = [floor, ...Array.from({ length: count }, (_, i) =>
    ({ name: `body_${i}`, motion: "dynamic", mass_kg: 1, color: color(i), shape: shapes[i % shapes.length] }))];
  const at = (body, t) => {
    if (body === 0) return { position: [0, 0, 0], velocity: [0, 0, 0], rotation: [1, 0, 0, 0], spin: [0, 0, 0] };
    const i = body - 1;
    const speed = 4 + 3 * ((i * 0.618) % 1);
    const fall_s = (t + ((i * 0.271) % 1)) % ((2 * speed) / GRAVITY_M_S2);
    const place = [(i % side) - side / 2, 0.4 + speed * fall_s - (GRAVITY_M_S2 / 2) * fall_s ** 2,
                   Math.floor(i / side) - side / 2];
    return { position: place, velocity: [0, speed - GRAVITY_M_S2 * fall_s, 0],
             rotation: turn([1, (i % 5) - 2, (i % 3) - 1], 2 * t), spin: [2, 0, 0] };
  };
  const step_s = 1 / 60;
  const kinds = ["impact", "contact_begin", "contact_end"];
  const events = Array.from({ length: 10000 }, (_, k) => ({
    time_s: (k / 10000) * frames * step_s, kind: kinds[k % 3], bodies: ["floor", `body_${(k * 37) % count}`],
    point_m: [((k * 37) % side) - side / 2, 0, ((k * 17) % side) - side / 2], normal: [0, 1, 0],
    ...(k % 3 ? {} : { impulse_N_s: [0, 1 + (k % 7), 0], approach_m_s: 4, separation_m_s: 3 }),
  }));
  return payload({ name: "many", text: "# a thousand bodies\n", bodies, frames, step_s, at, events });
}

/** The built page with a run in it. */
export function page(packed) {
  return template().replace("<!--ANIMADO-RUN-->", () => encode(packed));
}

const samples = { paper, many };
const wanted = process.argv[1]?.endsWith("sample.mjs") && process.argv[2];
if (wanted) {
  if (!samples[wanted]) throw new Error(`no sample is called ${wanted}: there are ${Object.keys(samples).join(", ")}`);
  process.stdout.write(page(samples[wanted]()));
}
