// report.html of a scene, opened from the disk as a reader opens it.
//
//   node tests/web/report_test.mjs SCENE     for example colisao

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { ANIMADO, SOURCE, colours, difference, linesOf, open, picture, pixels, withBrowser } from "./browser.mjs";

const FEWEST_COLOURS = 20;      // a picture with light and shadow has hundreds, a blank one has one
const LEAST_DIFFERENCE = 0.001;  // of the pixels, when bodies are elsewhere

const scene = process.argv[2];
const results = join(mkdtempSync(join(tmpdir(), "animado-web-")), scene);
try {
  execFileSync(ANIMADO, ["run", join(SOURCE, `scenes/${scene}.animado`), "--in-process", "--quiet", "--out", results]);
  await withBrowser(check);
} finally {
  rmSync(join(results, ".."), { recursive: true });
}

async function check(browser) {
  const { page, said, asked } = await open(browser, pathToFileURL(join(results, "report.html")).href);
  await motion(browser, page);
  await plots(page);
  await events(page);
  await texts(page);
  await looks(page);
  assert.deepEqual(said, [], "the console stays empty");
  assert.deepEqual(asked, [], "the page asks the network for nothing");
}

async function motion(browser, page) {
  const canvas = page.locator("#player");
  const [start_s, end_s] = await page.locator("#scrub").evaluate((slider) => [Number(slider.min), Number(slider.max)]);
  const at = async (part) => {
    await scrub(page, start_s + part * (end_s - start_s));
    return await pixels(browser, await picture(canvas, `${scene}-${part}`));
  };
  const [first, later] = [await at(0), await at(0.6)];
  assert.ok(colours(first) >= FEWEST_COLOURS, `the picture has ${colours(first)} colours`);
  assert.ok(difference(first, later) >= LEAST_DIFFERENCE, "the picture follows the slider");
}

// As a hand does it; and until the picture of that moment is drawn.
async function scrub(page, time_s) {
  const before = await page.evaluate(() => window.animado.pictures());
  await page.locator("#scrub").evaluate((slider, value) => {
    slider.value = value;
    slider.dispatchEvent(new Event("input", { bubbles: true }));
  }, time_s);
  const shown_s = await page.evaluate(() => window.animado.time_s());
  assert.ok(Math.abs(shown_s - time_s) < 1e-6 + 1e-3 * Math.abs(time_s), `the slider was put to ${time_s}, not ${shown_s}`);
  if (before === 0) await page.waitForFunction(() => window.animado.pictures() > 0);
  await drawn(page);
}

// What changed is drawn at the next frame; the one after it comes when that is done.
async function drawn(page) {
  await page.evaluate(() => new Promise((seen) => requestAnimationFrame(() => requestAnimationFrame(seen))));
}

// Lines are coloured, axes and letters are grey.
async function plots(page) {
  const drawn = await page.locator(".plot").evaluateAll((all) => all.map((plot) => {
    const canvas = plot.querySelector(".area canvas");
    const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
    let coloured = 0;
    for (let at = 0; at < data.length; at += 4) {
      const spread = Math.max(data[at], data[at + 1], data[at + 2]) - Math.min(data[at], data[at + 1], data[at + 2]);
      if (data[at + 3] > 128 && spread > 60) ++coloured;
    }
    return { id: plot.id, coloured };
  }));
  assert.ok(drawn.length >= 5, `there are ${drawn.length} plots`);
  for (const { id, coloured } of drawn) assert.ok(coloured > 50, `${id} has a line: ${coloured} coloured pixels`);
}

async function events(page) {
  const written = linesOf(join(results, "events.jsonl")).map((line) => JSON.parse(line));
  assert.ok(written.length > 0, "something happens in this scene");
  await page.evaluate(() => window.animado.goTo(-Infinity));
  await page.locator("#event-list [data-row='0']").click();
  assert.equal(await page.evaluate(() => window.animado.time_s()), written[0].time_s, "a click goes to the moment");
  await page.evaluate(() => window.animado.goTo(-Infinity));
  const first_px = await cursor(page, () => true);
  await page.locator("#event-list [data-row='0']").click();
  await cursor(page, (px) => px > first_px + 1);
}

// Where the time is in the plot of the energy, as soon as it is where it should be: plots out of sight are not drawn.
async function cursor(page, is_there) {
  const line = page.locator("#plot-energy .cursor");
  await page.locator("#plot-energy").scrollIntoViewIfNeeded();
  let px = NaN;
  for (let frame = 0; frame < 100; ++frame) {
    await drawn(page);
    px = await line.evaluate((node) => node.getBoundingClientRect().left);
    if (is_there(px)) return px;
  }
  assert.fail(`the plots' cursor goes with the time, but is at ${px} px`);
}

async function texts(page) {
  const shown = (id) => page.locator(id).innerText();
  const summary = JSON.parse(readFileSync(join(results, "summary.json"), "utf8"));
  assert.ok((await shown("#summary")).includes(summary.state_hash), "the state's hash is there");
  const last = linesOf(join(SOURCE, `scenes/${scene}.animado`)).at(-1).trim();
  assert.ok((await shown("#scene-text")).includes(last), "the scene's text is there to its last line");
  assert.ok(await page.locator("#sequence svg").count() > 0, "the traffic is drawn");
  for (const module of ["interexpserv", "egesp", "fred", "colisao", "controle"]) {
    assert.ok((await page.locator("#sequence svg").textContent()).includes(module), `${module} has its lifeline`);
  }
}

async function looks(page) {
  await page.evaluate(() => window.animado.goTo(1));
  for (const colorScheme of ["light", "dark"]) {
    await page.emulateMedia({ colorScheme });
    await picture(page, `${scene}-${colorScheme}`, { fullPage: true });
  }
  await page.setViewportSize({ width: 360, height: 740 });
  const width = await page.evaluate(() => document.documentElement.scrollWidth);
  assert.ok(width <= 360, `a telephone shows the page without sideways scrolling: ${width} px wide`);
  await picture(page, `${scene}-phone`, { fullPage: true });
}
