// Where the arrows of a sequence diagram go: a row for each request and each reply, in the order of time.

// controle in the middle: it is who asks, and most arrows are then short.
export const MODULES = ["interexpserv", "fred", "controle", "egesp", "colisao"];

/** @typedef {{at_us: number, took_us: number, from: string, to: string, method: string}} Message */
/** @typedef {{kind: "request"|"reply", at_us: number, from: string, to: string, text: string, message: number}} Row */

/**
 * @param {Message[]} messages
 * @returns {{rows: Row[], busy: {module: string, first: number, last: number, depth: number}[]}} busy: from which row
 * to which a module is at work for a request
 */
export function layout(messages) {
  const rows = messages.flatMap(({ at_us, took_us, from, to, method }, message) => [
    { kind: "request", at_us, from, to, text: method, message },
    { kind: "reply", at_us: at_us + took_us, from: to, to: from, text: `${took_us.toFixed(1)} µs`, message },
  ]);
  // At equal times what was asked later is answered earlier, and nothing is answered before it is asked.
  rows.sort((a, b) => a.at_us - b.at_us || order(a) - order(b));
  const asked = new Map();
  const open = {};
  const busy = [];
  rows.forEach(({ kind, message }, row) => {
    const module = messages[message].to;
    if (kind === "request") {
      open[module] = (open[module] ?? 0) + 1;
      asked.set(message, { row, depth: open[module] - 1 });
      return;
    }
    --open[module];
    const { row: first, depth } = asked.get(message) ?? { row, depth: 0 };
    busy.push({ module, first, last: row, depth });
  });
  return { rows, busy };
}

const order = ({ kind, message }) => (kind === "request" ? message : 1e9 - message);
