// The run that the page carries: base64 of a gzip stream of a header (JSON) and arrays (web/README.md).

/** Thrown when there is no run in the page, or one that this page cannot read: what happened and what to do. */
export class PayloadError extends Error {}

const REMEDY = "Write the report again with the `animado` that made this run.";
const ARRAY_OF = { f32: Float32Array, f64: Float64Array, u16: Uint16Array, i16: Int16Array };

/** @param {string} base64 @returns {Promise<{header: object, arrays: Record<string, ArrayLike<number>>}>} */
export async function unpack(base64) {
  const text = base64.trim();
  // A page that nothing was put into still holds the comment that stands for it.
  if (!text || text.startsWith("<!")) throw new PayloadError("This page carries no run. Write a report with `animado report`.");
  let bytes;
  try {
    bytes = await gunzip(decodeBase64(text));
  } catch {
    throw new PayloadError(`The run in this page is damaged: it does not unpack. ${REMEDY}`);
  }
  return parse(bytes);
}

function decodeBase64(text) {
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

async function gunzip(bytes) {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  return await new Response(stream).arrayBuffer();
}

/** @param {ArrayBuffer} buffer what was zipped */
export function parse(buffer) {
  const header_bytes = buffer.byteLength < 4 ? -1 : new DataView(buffer).getUint32(0, true);
  const start = 4 + header_bytes;
  if (header_bytes < 0 || start > buffer.byteLength) {
    throw new PayloadError(`The run in this page is cut short. ${REMEDY}`);
  }
  const header = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 4, header_bytes)));
  if (header.format !== 1) {
    throw new PayloadError(`This page reads runs of format 1; this one has ${header.format}. ${REMEDY}`);
  }
  const arrays = {};
  for (const [name, place] of Object.entries(header.arrays)) arrays[name] = view(buffer, start, name, place);
  return { header, arrays };
}

// Copied, not viewed in place: four bytes of length before the header leave nothing aligned to eight.
function view(buffer, start, name, { type, offset, count }) {
  const Numbers = ARRAY_OF[type];
  if (!Numbers) throw new PayloadError(`The array ${name} is of an unknown type, ${type}. ${REMEDY}`);
  const first = start + offset;
  const last = first + count * Numbers.BYTES_PER_ELEMENT;
  if (last > buffer.byteLength) throw new PayloadError(`The array ${name} is cut short. ${REMEDY}`);
  return new Numbers(buffer.slice(first, last));
}
