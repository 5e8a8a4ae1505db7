// A run that goes on, through the WebSocket of `animado run --live`: JSON messages, listed in web/README.md.

import { byId } from "./dom.js";
import { EditForm } from "./edit_form.js";
import { LiveMotion } from "./live_motion.js";
import { LiveRun } from "./live_run.js";
import { Logs } from "./logs.js";
import { sections } from "./sections.js";

const REFRESH_MS = 250;  // plots are drawn anew four times a second, however fast the frames come

/** @param {(run: object) => object} show what main.js makes of a run; resolves once the run has said what it is */
export function live(show) {
  const scheme = location.protocol === "https:" ? "wss" : "ws";
  const token = new URLSearchParams(location.search).get("token") ?? "";
  const socket = new WebSocket(`${scheme}://${location.host}/live?token=${encodeURIComponent(token)}`);
  const status = (text) => (byId("live-status").textContent = text);
  byId("live").hidden = false;
  status("Connecting…");
  return new Promise((resolve) => {
    let session = null;
    socket.addEventListener("message", ({ data }) => {
      const message = JSON.parse(data);
      if (message.type === "hello") {
        session = new Session(socket, message, show, status);
        resolve();
      } else {
        session?.take(message);
      }
    });
    socket.addEventListener("close", () => {
      if (session) session.lost();
      else status("No connection. Is the run still there? Start it with `animado run --live` and open its address.");
      byId("live").classList.toggle("lost", !session?.ended);
      resolve();
    });
  });
}

class Session {
  ended = false;
  #run;
  #page;
  #logs;
  #form;
  #driver;
  #status;
  #fresh = false;
  #frames = 0;  // of the run: a page that comes late, or stays long, holds fewer
  #timer;

  constructor(socket, hello, show, status) {
    const send = (message) => socket.readyState === WebSocket.OPEN && socket.send(JSON.stringify(message));
    this.#status = status;
    this.#run = { ...hello, motion: new LiveMotion(hello.bodies), events: [] };
    this.#page = show(this.#run);
    this.#driver = new LiveRun(this.#page.clock, this.#page.driver, send, () => this.#tell());
    this.#page.driver = this.#driver;
    this.#logs = new Logs(byId("live-logs"), hello.modules);
    this.#form = new EditForm(hello.names, send);
    this.#timer = setInterval(() => this.#refresh(), REFRESH_MS);
    sections(["plots", "events", "logs", "scene"]);
    this.#tell();
  }

  take(message) {
    switch (message.type) {
      case "frame":
        return this.#frame(message);
      case "event":
        this.#fresh = true;
        return void this.#run.events.push(message);
      case "log":
        return this.#logs.add(message.module, message.lines);
      case "pace":
        this.#driver.pace(message);
        return this.#tell();
      case "checked":
      case "edited":
      case "refused":
        return this.#form.answer(message);
      case "end":
        return this.#end(message);
    }
  }

  #frame(message) {
    const { motion } = this.#run;
    const first = !motion.frames;
    motion.push(message);
    this.#frames = message.frame + 1;
    this.#fresh = true;
    this.#driver.grown(motion.times_s[0], message.time_s);
    if (first) {
      this.#page.player?.fit();
      this.#refresh();
    } else {
      this.#page.player?.changed();
    }
  }

  #refresh() {
    if (!this.#fresh) return;
    this.#fresh = false;
    this.#page.plots.refresh();
    this.#page.events.refresh();
    this.#page.player?.refitIfNeeded();
    this.#tell();
  }

  #tell() {
    this.#page.tell();
    byId("live-now").hidden = this.#driver.at_now;
    if (!this.ended) this.#status(this.#driver.text(this.#frames, this.#run.frames));
  }

  #end({ status, state_hash: hash }) {
    this.ended = true;
    this.#stop();
    this.#status(`Run ${status}. State hash ${hash}.`);
  }

  lost() {
    if (this.ended) return;
    this.#stop();
    this.#status("Connection lost: the run ended or was stopped. What was seen until here can still be played; " +
      "load the page again to connect.");
  }

  // From here on the page plays what it has seen.
  #stop() {
    clearInterval(this.#timer);
    this.#refresh();
    this.#driver.end();
    this.#form.disable();
    this.#page.driver = this.#driver.playback;
    this.#page.tell();
  }
}
