// Where a time lies among the times of frames or of events.

/** The last frame at or before a time, and how far it is on the way to the next one. */
export function bracket(times_s, time_s) {
  let low = 0;
  let high = times_s.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (times_s[middle] <= time_s) low = middle;
    else high = middle - 1;
  }
  if (low + 1 >= times_s.length) return { frame: low, fraction: 0 };
  const fraction = (time_s - times_s[low]) / (times_s[low + 1] - times_s[low]);
  return { frame: low, fraction: Math.min(1, Math.max(0, fraction)) };
}

/** The frame whose time is nearest: what a plot shows under its cursor. */
export function nearest(times_s, time_s) {
  const { frame, fraction } = bracket(times_s, time_s);
  return fraction > 0.5 ? frame + 1 : frame;
}

/** The index of the last event at or before a time; −1 when there is none. */
export function lastBefore(events, time_s) {
  let low = -1;
  let high = events.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (events[middle].time_s <= time_s) low = middle;
    else high = middle - 1;
  }
  return low;
}
