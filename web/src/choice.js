// The body that the reader chose: by a click in the picture or from the list. Its curves are plotted, its box is drawn.

export class Choice extends EventTarget {
  constructor(body) {
    super();
    this.body = body;
  }

  choose(body) {
    if (body === this.body) return;
    this.body = body;
    this.dispatchEvent(new Event("change"));
  }
}

/** The first body that moves, or the first. */
export const firstMoving = (bodies) => Math.max(0, bodies.findIndex((body) => body.motion === "dynamic"));
