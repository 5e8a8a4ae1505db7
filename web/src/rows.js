// Which rows of a long list can be seen.

export const ROW_PX = 30;
const SPARE = 4;  // rows above and below, so that a quick scroll does not show a gap

/** @returns {{first: number, end: number}} end is one past the last */
export function visibleRows(scroll_px, height_px, rows) {
  const first = Math.max(0, Math.floor(scroll_px / ROW_PX) - SPARE);
  const end = Math.min(rows, Math.ceil((scroll_px + height_px) / ROW_PX) + SPARE);
  return { first, end: Math.max(first, end) };
}
