// The list of events: as many rows as can be seen, however many events there are. A click or Enter goes to the moment.

import { Readable } from "./clock.js";
import { element, oncePerFrame } from "./dom.js";
import { eventText, KINDS } from "./event_text.js";
import { count, seconds } from "./format.js";
import { lastBefore } from "./moments.js";
import { ROW_PX, visibleRows } from "./rows.js";

export class EventList {
  #events;
  #shown = [];  // those of the kind that is looked at
  #kind = null;
  #counts = {};
  #counted = 0;
  #active = 0;
  #clock;
  #step_s;
  #list = element("div", { id: "event-list", class: "rows", role: "listbox", tabindex: 0, "aria-label": "Events" });
  #room = element("div", { class: "room", role: "presentation" });
  #kinds = element("div", { class: "kinds", role: "group", "aria-label": "Kinds of events" });
  #redraw = oncePerFrame(() => this.#draw());

  /** @param {object[]} events in the order of time; a live run appends to them and calls refresh */
  constructor(place, events, clock, step_s) {
    this.#events = events;
    this.#clock = clock;
    this.#step_s = step_s;
    this.#list.append(this.#room);
    place.append(this.#kinds, this.#list);
    this.#list.addEventListener("scroll", this.#redraw);
    this.#list.addEventListener("keydown", (event) => this.#key(event));
    this.#list.addEventListener("click", (event) => this.#click(event));
    const readable = new Readable(clock);
    for (const kind of ["time", "state"]) clock.addEventListener(kind, () => readable.due() && this.#follow());
    new ResizeObserver(this.#redraw).observe(this.#list);
    this.refresh();
  }

  refresh() {
    for (; this.#counted < this.#events.length; ++this.#counted) {
      const { kind } = this.#events[this.#counted];
      this.#counts[kind] = (this.#counts[kind] ?? 0) + 1;
    }
    this.#shown = this.#kind ? this.#events.filter(({ kind }) => kind === this.#kind) : this.#events;
    this.#drawKinds();
    this.#follow();
  }

  #drawKinds() {
    const kinds = Object.keys(KINDS).filter((kind) => this.#counts[kind]);
    const chip = (kind, text) =>
      element("button", { type: "button", class: "chip", "aria-pressed": String(this.#kind === kind),
                          on: { click: () => this.#choose(kind) } }, text);
    const all = chip(null, `all ${count(this.#events.length)}`);
    const each = kinds.map((kind) =>
      chip(kind, `${KINDS[kind].sign} ${KINDS[kind].name} ${count(this.#counts[kind])}`));
    this.#kinds.replaceChildren(all, ...(kinds.length > 1 ? each : []));
  }

  #choose(kind) {
    this.#kind = kind;
    this.refresh();
  }

  // The mark moves with the clock, and the list with the mark, unless the reader is in the list.
  #follow() {
    const now = lastBefore(this.#shown, this.#clock.time_s);
    if (document.activeElement !== this.#list) {
      this.#active = Math.max(0, now);
      if (!this.#list.matches(":hover")) this.#reveal(this.#active);
    }
    this.#redraw();
  }

  #reveal(row) {
    const top = row * ROW_PX;
    const { scrollTop, clientHeight } = this.#list;
    if (top < scrollTop) this.#list.scrollTop = top;
    else if (top + ROW_PX > scrollTop + clientHeight) this.#list.scrollTop = top + ROW_PX - clientHeight;
  }

  #key(event) {
    const page = Math.max(1, Math.floor(this.#list.clientHeight / ROW_PX) - 1);
    const by = { ArrowDown: 1, ArrowUp: -1, PageDown: page, PageUp: -page, Home: -Infinity, End: Infinity }[event.key];
    if (event.key === "Enter") this.#go(this.#active);
    else if (by === undefined) return;
    else this.#active = Math.min(this.#shown.length - 1, Math.max(0, this.#active + by));
    event.preventDefault();
    event.stopPropagation();
    this.#reveal(this.#active);
    this.#redraw();
  }

  #click(event) {
    const row = event.target.closest("[data-row]");
    if (row) this.#go(Number(row.dataset.row));
  }

  #go(row) {
    this.#active = row;
    if (!this.#shown[row]) return;
    this.#clock.pause();
    this.#clock.goTo(this.#shown[row].time_s);
    this.#redraw();
  }

  #draw() {
    const { scrollTop, clientHeight } = this.#list;
    const { first, end } = visibleRows(scrollTop, clientHeight, this.#shown.length);
    const now = lastBefore(this.#shown, this.#clock.time_s);
    this.#room.style.height = `${this.#shown.length * ROW_PX}px`;
    const rows = this.#shown.slice(first, end).map((event, i) => this.#row(event, first + i, now));
    this.#room.replaceChildren(...rows);
    if (!this.#shown.length) this.#room.textContent = "Nothing met anything.";
    const active = rows.length && this.#active >= first && this.#active < end;
    if (active) this.#list.setAttribute("aria-activedescendant", `event-${this.#active}`);
    else this.#list.removeAttribute("aria-activedescendant");
  }

  #row(event, row, now) {
    const { sign, name } = KINDS[event.kind] ?? { sign: "·", name: event.kind };
    const { who, what } = eventText(event);
    const node = element("div", {
      id: `event-${row}`, class: `row ${event.kind}`, role: "option", "data-row": row,
      "aria-selected": String(row === this.#active), "aria-current": row === now ? "time" : null,
      "aria-posinset": row + 1, "aria-setsize": this.#shown.length,
    },
    element("span", { class: "when" }, seconds(event.time_s, this.#step_s / 100)),
    element("span", { class: "kind" }, element("span", { class: "sign", "aria-hidden": "true" }, sign),
      element("span", { class: "name" }, ` ${name}`)),
    element("span", { class: "who" }, who), element("span", { class: "what" }, what));
    node.style.top = `${row * ROW_PX}px`;
    return node;
  }
}
