// Choose a name of the running scene and give it another expression. What is wrong with it is said as it is typed.

import { byId, element } from "./dom.js";
import { quantity } from "./format.js";

const TYPING_MS = 150;

export class EditForm {
  #texts;
  #send;
  #name = byId("live-name");
  #text = byId("live-text");
  #apply = byId("live-apply");
  #answer = byId("live-answer");
  #timer = 0;

  /** @param {{name: string, text: string}[]} names */
  constructor(names, send) {
    this.#texts = new Map(names.map(({ name, text }) => [name, text]));
    this.#send = send;
    this.#name.replaceChildren(...names.map(({ name }) => element("option", {}, name)));
    this.#name.addEventListener("change", () => this.#take());
    this.#text.addEventListener("input", () => this.#checkSoon());
    byId("live-edit").addEventListener("submit", (event) => {
      event.preventDefault();
      clearTimeout(this.#timer);  // it is checked on its way; a check of its own would be answered after it acts
      this.#send({ type: "edit", ...this.#typed() });
    });
    this.#take();
  }

  #take() {
    this.#text.value = this.#texts.get(this.#name.value) ?? "";
    this.#say("", true);
  }

  #typed() {
    return { name: this.#name.value, text: this.#text.value };
  }

  #checkSoon() {
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.#send({ type: "check", ...this.#typed() }), TYPING_MS);
  }

  /** @param {object} message "checked", "edited" or "refused" */
  answer(message) {
    const { type, name, text, error } = message;
    if (type === "edited") {
      this.#texts.set(name, text);
      return this.#say(`From ${quantity(message.time_s, "s")} on, ${name} = ${text}`, true);
    }
    const typed = this.#typed();
    if (type === "checked" && (name !== typed.name || text !== typed.text)) return;  // of what is not there any more
    if (!error) return this.#say("", true);
    this.#say([error.message, error.where, error.remedy].filter(Boolean).join("\n"), false);
  }

  #say(text, good) {
    this.#answer.textContent = text;
    this.#answer.classList.toggle("bad", !good);
    this.#text.setAttribute("aria-invalid", String(!good));
    this.#apply.disabled = !good;
  }

  disable() {
    for (const field of [this.#name, this.#text, this.#apply]) field.disabled = true;
  }
}
