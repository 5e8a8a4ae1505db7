// The page of a run that goes on, in a browser; the test is the server.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { template } from "../template.mjs";
import { launch, open } from "./browser.mjs";

const HOST = "http://127.0.0.1:9";
const html = template().replace("<html", "<html data-live").replace("<!--ANIMADO-RUN-->", "");
let browser;
before(async () => (browser = await launch()));
after(() => browser?.close());

const hello = {
  type: "hello", version: "0.1.0", scene: "scenes/ball.animado", scene_text: "object ball\n", start_s: 0, end_s: 1,
  step_s: 0.1, frames: 11, names: [{ name: "g", text: "-9.81" }, { name: "wind", text: "0" }],
  modules: ["interexpserv", "egesp", "fred", "colisao", "controle"],
  bodies: [{ name: "ball", motion: "dynamic", mass_kg: 1, color: [0.8, 0.4, 0.2],
             shape: { kind: "sphere", radius_m: 0.5 } }],
};
const frame = (k) => ({ type: "frame", frame: k, time_s: k / 10, position: [0, 3 - k / 10, 0], rotation: [1, 0, 0, 0],
                        facts: { kinetic_J: k, potential_J: 10 - k, elastic_J: 0, work_in_J: 0,
                                 dissipated_impacts_J: 0, dissipated_friction_J: 0, dissipated_damping_J: 0,
                                 residual_J: 0, contacts: 0, step_s: 0.01 } });

/** @returns the page, and its server: `heard` what the page said, `say` to it, `next` waits for a kind of message */
async function session() {
  const server = { heard: [], waiting: [] };
  server.next = (type) => new Promise((resolve) => {
    const said = server.heard.find((message) => message.type === type);
    if (said) resolve(said);
    else server.waiting.push({ type, resolve });
  });
  const prepare = async (page) => {
    await page.route(`${HOST}/**`, (route) => route.fulfill({ contentType: "text/html", body: html }));
    await page.routeWebSocket(/\/live\?/, (socket) => {
      server.address = socket.url();
      server.say = (message) => socket.send(JSON.stringify(message));
      server.leave = () => socket.close();
      socket.onMessage((text) => {
        const message = JSON.parse(text);
        server.heard.push(message);
        for (const { resolve } of server.waiting.filter(({ type }) => type === message.type)) resolve(message);
      });
      server.say(hello);
      server.say({ type: "pace", paused: false, speed: 1 });
    });
  };
  const page = await open(browser, { prepare, address: `${HOST}/?token=secret` });
  return { page, server };
}

const at = (page, time_s) => page.waitForFunction((t) => Math.abs(window.animado.time_s() - t) < 1e-9, time_s);
const text = (page, id, pattern) =>
  page.waitForFunction(([id, source]) => new RegExp(source).test(document.getElementById(id)?.textContent),
    [id, pattern.source]);

test("frames move the bodies, and plots, events and logs grow", async () => {
  const { page, server } = await session();
  assert.equal(server.address, "ws://127.0.0.1:9/live?token=secret");
  for (let k = 0; k <= 5; ++k) server.say(frame(k));
  server.say({ type: "event", kind: "impact", time_s: 0.45, bodies: ["ball", "floor"], point_m: [0, 0, 0],
               normal: [0, 1, 0], impulse_N_s: [0, 2, 0], approach_m_s: 2, separation_m_s: 1 });
  server.say({ type: "log", module: "egesp", lines: Array.from({ length: 900 }, (_, i) => `line ${i}`) });
  await at(page, 0.5);
  await text(page, "live-status", /frame 6 of 11, running, ×1/);
  await text(page, "event-list", /impact.*ball · floor/);
  await text(page, "plot-energy", /kinetic 5/);
  await text(page, "live-logs", /line 899/);
  assert.equal(await page.locator(".log").count(), 5);
  assert.ok((await page.locator(".log span").count()) <= 300, "old lines go");
  await page.waitForFunction(() => window.animado.pictures() > 0);
  assert.deepEqual(page.errors, []);
});

test("a page that comes late knows how far the run is", async () => {
  const { page, server } = await session();
  for (const k of [7, 8]) server.say(frame(k));
  await at(page, 0.8);
  await text(page, "live-status", /frame 9 of 11/);
  assert.deepEqual(page.errors, []);
});

test("buttons steer the run; who looks at the past stays there until now is asked for", async () => {
  const { page, server } = await session();
  for (let k = 0; k <= 3; ++k) server.say(frame(k));
  await at(page, 0.3);
  await page.keyboard.press(" ");
  await server.next("pause");
  server.say({ type: "pace", paused: true, speed: 1 });
  await text(page, "live-status", /paused/);
  await page.locator("#live-step").click();
  await server.next("step");
  await page.keyboard.press("[");
  assert.equal((await server.next("speed")).value, 0.5);
  await page.keyboard.press("ArrowLeft");
  await at(page, 0.2);
  server.say(frame(4));
  await text(page, "live-status", /frame 5/);
  await at(page, 0.2);
  await page.locator("#live-now").click();
  await at(page, 0.4);
  assert.deepEqual(page.errors, []);
});

test("an expression is checked as it is typed, and applied", async () => {
  const { page, server } = await session();
  await page.clock.install();
  await page.locator("#live-name").selectOption("wind");
  await page.locator("#live-text").fill("2*");
  const check = await server.next("check");
  assert.deepEqual(check, { type: "check", name: "wind", text: "2*" });
  server.say({ ...check, type: "checked", error: { message: "something is missing\n  2*\n    ^", where: "column 3",
                                                   remedy: "write a number after *" } });
  await text(page, "live-answer", /something is missing[^]*\^[^]*column 3[^]*write a number/);
  assert.ok(await page.locator("#live-apply").isDisabled());
  await page.locator("#live-text").fill("2*t");
  server.say({ type: "checked", name: "wind", text: "2*t", error: null });
  await page.locator("#live-apply").click();
  assert.deepEqual(await server.next("edit"), { type: "edit", name: "wind", text: "2*t" });
  const checks = () => server.heard.filter(({ type, text }) => type === "check" && text === "2*t").length;
  const before = checks();  // none, unless this machine was too slow to click in time
  server.say({ type: "edited", name: "wind", text: "2*t", time_s: 0.4 });
  await text(page, "live-answer", /From 0.4 s on, wind = 2\*t/);
  await page.clock.runFor(1000);
  assert.equal(checks(), before);
});

test("a run that ends says its hash, and can be played; a lost one is told", async () => {
  const { page, server } = await session();
  for (let k = 0; k <= 3; ++k) server.say(frame(k));
  await at(page, 0.3);
  server.say({ type: "end", status: "done", state_hash: "72af357d4dfef055" });
  await text(page, "live-status", /done.*72af357d4dfef055/);
  server.leave();
  await page.keyboard.press("Home");
  await at(page, 0);
  await page.keyboard.press(" ");
  await at(page, 0.3);

  const other = await session();
  other.server.say(frame(0));
  await other.server.leave();
  await text(other.page, "live-status", /Connection lost/);
});
