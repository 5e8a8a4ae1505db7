// Above the picture: which body, and what is drawn besides the bodies.

import { byId, element } from "./dom.js";

const TOGGLES = ["follow", "trails", "boxes", "impulses"];

/** @returns {(name: string) => void} to switch one on or off */
export function toolbar(player, bodies, choice) {
  const select = byId("body");
  select.append(...bodies.map(({ name }, i) => element("option", { value: i }, name)));
  const tellBody = () => (select.value = choice.body);
  select.addEventListener("change", () => choice.choose(Number(select.value)));
  choice.addEventListener("change", tellBody);
  tellBody();
  const tell = (name) => byId(name).setAttribute("aria-pressed", String(player.show[name]));
  const toggle = (name) => {
    player.show[name] = !player.show[name];
    tell(name);
    player.changed();
  };
  for (const name of TOGGLES) {
    byId(name).addEventListener("click", () => toggle(name));
    tell(name);
  }
  byId("fit").addEventListener("click", () => player.fit());
  return toggle;
}
