// Keys, for the whole page but where something is typed. The help says them, and can switch them off for those whose
// speech recognition types letters.

import { byId } from "./dom.js";

/** @param {Record<string, () => void>} actions by the key's name */
export function keyboard(actions) {
  const help = byId("help");
  const all = { ...actions, "?": () => help.showModal() };
  byId("show-help").addEventListener("click", all["?"]);
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey || help.open || !byId("shortcuts").checked) return;
    const action = all[event.key];
    if (!action || isTaken(event)) return;
    event.preventDefault();
    action();
  });
}

// A field takes what is typed into it; a button takes the space bar; a list and a scroller take their arrows.
function isTaken({ target, key }) {
  if (target.matches("textarea, select, input:not([type=range])")) return true;
  if (key === " ") return target.matches("button, summary");
  return target.matches(".wide, #scene-text, .log") && /^(Arrow|Home|End)/.test(key);
}
