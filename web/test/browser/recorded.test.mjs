// The page of a run that is over, in a browser.

import assert from "node:assert/strict";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";
import { many, page as pageOf, paper } from "../sample.mjs";
import { address as empty_page } from "../template.mjs";
import { launch, open } from "./browser.mjs";

const directory = mkdtempSync(join(tmpdir(), "animado-page-"));
let browser;
before(async () => (browser = await launch()));
after(async () => {
  await browser?.close();
  rmSync(directory, { recursive: true });
});

function written(name, text) {
  const file = join(directory, name);
  writeFileSync(file, text);
  return pathToFileURL(file).href;
}

const time_s = (page) => page.evaluate(() => window.animado.time_s());

async function pressed(page, key, expected_s) {
  await page.keyboard.press(key);
  assert.ok(Math.abs((await time_s(page)) - expected_s) < 1e-9, `${key} goes to ${expected_s} s`);
}

test("the paper's run: from disk, without a request, drawn, at every part", async () => {
  const address = written("paper.html", pageOf(paper()));
  const page = await open(browser, { address });
  assert.deepEqual(page.requests, [address]);
  assert.equal(await page.title(), "colisao · ANIMADO");
  await page.waitForFunction(() => window.animado.pictures() > 0);
  const colors = await page.evaluate(async () => {
    const canvas = document.getElementById("player");
    window.animado.goTo(1);
    await new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)));
    window.animado.goTo(1.2);
    return new Promise((resolve) => requestAnimationFrame(() => {
      const copy = Object.assign(document.createElement("canvas"), { width: 64, height: 64 }).getContext("2d");
      copy.drawImage(canvas, 0, 0, 64, 64);
      resolve(new Set(new Uint32Array(copy.getImageData(0, 0, 64, 64).data.buffer)).size);
    }));
  });
  assert.ok(colors > 20, `a picture has more than ${colors} colours`);
  assert.match(await page.locator("#energy-sentence").textContent(), /in 1 impact.*the ledger closes to/);
  assert.equal(await page.locator(".plot").count(), 8);
  assert.equal(await page.locator("#sequence .request").count(), 12 + 1, "an arrow a message, and its head");
  assert.equal(await page.locator("#scene-text li").count(), 13);
  assert.match(await page.locator("#summary").textContent(), /state hash72af357d4dfef055/);
  assert.deepEqual(page.errors, []);
});

test("nothing is drawn while nothing changes", async () => {
  const page = await open(browser, { address: written("paper.html", pageOf(paper())) });
  const more = await page.evaluate(async () => {
    const frames = async (n) => { while (n-- > 0) await new Promise((resolve) => requestAnimationFrame(resolve)); };
    await frames(10);
    const before = window.animado.pictures();
    await frames(20);
    return window.animado.pictures() - before;
  });
  assert.equal(more, 0);
});

test("keys, the slider, a plot and an event move the one time", async () => {
  const page = await open(browser, { address: written("paper.html", pageOf(paper())) });
  await pressed(page, "End", 3.3);
  await pressed(page, "ArrowLeft", 3);
  await pressed(page, "Home", 0);
  await pressed(page, "ArrowRight", 0.3);
  await page.locator("#plot-energy .u-over").click({ position: { x: 1, y: 30 } });
  assert.ok((await time_s(page)) < 0.1, "a click at the left of a plot goes to the start");
  await page.locator("#event-list").focus();
  await page.keyboard.press("Enter");
  assert.ok(Math.abs((await time_s(page)) - 1.142) < 1e-9, "Enter in the list goes to the event");
  assert.equal(await page.locator("#time").textContent(), "1.142 s");
  await page.keyboard.press("b");
  assert.equal(await page.locator("#boxes").getAttribute("aria-pressed"), "true");
  await page.keyboard.press("]");
  assert.equal(await page.locator("#speed").textContent(), "×2");
  await page.locator("#play").click();
  await page.waitForFunction(() => window.animado.time_s() > 1.3);
  await page.keyboard.press("?");
  assert.ok(await page.locator("#help").isVisible());
  assert.deepEqual(page.errors, []);
});

test("a thousand bodies and ten thousand events: few rows, and nothing wider than a phone", async () => {
  const address = written("many.html", pageOf(many(1000, 60)));
  const page = await open(browser, { address, viewport: { width: 360, height: 740 } });
  await page.evaluate(() => window.animado.goTo(0.5));
  assert.ok((await page.locator(".row").count()) < 40);
  const wide = await page.evaluate(() => document.documentElement.scrollWidth);
  assert.ok(wide <= 360, `the page is ${wide} px wide`);
  assert.deepEqual(page.errors, []);
});

test("a page without a run says so", async () => {
  const page = await open(browser, { address: empty_page });
  assert.match(await page.locator("#notice").textContent(), /carries no run/);
  assert.equal(await page.locator("#page").isVisible(), false);
});
