// The scene as it was written, with the numbers of its lines, comments set back.

import { element } from "./dom.js";

export function sceneText(place, text) {
  const lines = text.replace(/\n$/, "").split("\n");
  place.append(element("ol", {}, ...lines.map((line) =>
    element("li", { class: /^\s*#(?!#{4}\s*\S)/.test(line) ? "comment" : null }, element("code", {}, line || " ")))));
}
