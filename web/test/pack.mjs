// Payloads as `animado report` writes them (web/README.md), for tests and to look at the page without the program.

import { gzipSync } from "node:zlib";

const TYPES = { f32: Float32Array, f64: Float64Array, u16: Uint16Array, i16: Int16Array };

/**
 * @param {object} header without `arrays`
 * @param {Record<string, {type: string, values: ArrayLike<number>, low?: number[], high?: number[]}>} arrays
 * @returns {Buffer} before it is zipped
 */
export function pack(header, arrays) {
  const places = {};
  const blocks = [];
  let offset = 0;
  for (const [name, { type, values, ...range }] of Object.entries(arrays)) {
    const numbers = TYPES[type].from(values);
    places[name] = { type, offset, count: numbers.length, ...range };
    const room = Math.ceil(numbers.byteLength / 8) * 8;
    const block = Buffer.alloc(room);
    block.set(new Uint8Array(numbers.buffer));
    blocks.push(block);
    offset += room;
  }
  const text = Buffer.from(JSON.stringify({ ...header, arrays: places }));
  const padded = Buffer.alloc(Math.ceil(text.length / 8) * 8, " ");
  padded.set(text);
  const length = Buffer.alloc(4);
  length.writeUInt32LE(padded.length);
  return Buffer.concat([length, padded, ...blocks]);
}

export const encode = (packed) => gzipSync(packed).toString("base64");

/** Rows of three numbers a body a frame in 16 bits, each body's axis over its own range. */
export function quantized(bodies) {
  const values = [], low = [], high = [];
  for (const rows of bodies) {
    const lows = [0, 1, 2].map((axis) => Math.min(...rows.map((row) => row[axis])));
    const highs = [0, 1, 2].map((axis) => Math.max(...rows.map((row) => row[axis])));
    low.push(...lows);
    high.push(...highs);
    for (const row of rows) {
      row.forEach((value, axis) => {
        const span = highs[axis] - lows[axis];
        values.push(span ? Math.round(((value - lows[axis]) / span) * 65535) : 0);
      });
    }
  }
  return { type: "u16", values, low, high };
}

export const turns = (bodies) =>
  ({ type: "i16", values: bodies.flatMap((rows) => rows.flatMap((row) => row.map((q) => Math.round(q * 32767)))) });
