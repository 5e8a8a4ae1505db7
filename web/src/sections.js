// Which sections of the page there are for this run, and the links to them.

import { byId, element } from "./dom.js";

/** @param {string[]} ids those that have something to show, in their order */
export function sections(ids) {
  for (const id of ids) {
    byId(id).hidden = false;
    const title = byId(id).querySelector("h2").textContent;
    byId("contents").append(element("a", { href: `#${id}` }, title));
  }
}
