// Numbers as people read them. Files hold every digit; a page holds those that tell something.

const MINUS = "−";

/** Four significant digits; powers of ten only where they are shorter. `quantity(2.84e-14, "J")` is "2.84e−14 J". */
export function quantity(value, unit = "") {
  const text = Number.isFinite(value) ? digits(value) : "—";
  return unit ? `${text} ${unit}` : text;
}

function digits(value) {
  if (value === 0) return "0";
  const size = Math.abs(value);
  const text = size < 1e-3 || size >= 1e6 ? value.toExponential(2) : String(Number(value.toPrecision(4)));
  return text.replace(/\.?0+e/, "e").replace("e+", "e").replaceAll("-", MINUS);
}

/** 15364 is "15 364": thin spaces, which no language reads as a decimal point. */
export const count = (value) => String(value).replace(/\B(?=(\d{3})+$)/g, "\u202f");

/** "1 impact", "2 impacts" */
export const plural = (value, noun) => `${count(value)} ${noun}${value === 1 ? "" : "s"}`;

/** Seconds with as many decimals as tell neighbouring frames apart. */
export const seconds = (time_s, step_s) => time_s.toFixed(decimals(step_s)).replace("-", MINUS);

const decimals = (step_s) => Math.min(9, Math.max(3, Math.ceil(-Math.log10(step_s || 1e-3)) + 1));

/** ×1/8, ×1, ×8; 0 is the run as fast as it goes. */
export function speedText(speed) {
  if (speed === 0) return "max";
  return speed < 1 ? `×1/${Math.round(1 / speed)}` : `×${quantity(speed)}`;
}
