// A thousand bodies and six hundred frames play, drawn by the processor alone. How many pictures a second that makes is
// printed and not asked for: it depends on what else the machine does (docs/performance.md has a quiet one's figures).
//
//   node tests/web/frame_rate_test.mjs

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, statSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { BUILD, open, picture, withBrowser } from "./browser.mjs";

const LONG_ENOUGH_S = 3;
const TRIES = 3;

await withBrowser(async (browser) => {
  mkdirSync(join(BUILD, "web"), { recursive: true });
  const file = join(BUILD, "web/thousand_bodies.html");
  execFileSync(join(BUILD, "bin/sample_report"), [file, "1000", "600"]);
  const { page, said, asked } = await open(browser, pathToFileURL(file).href);
  const rates = [];
  while (rates.length < TRIES) rates.push(await page.evaluate(play, LONG_ENOUGH_S));
  await picture(page, "thousand_bodies");
  console.log(`${(statSync(file).size / 1e6).toFixed(1)} MB; pictures a second: ${rates.map((r) => r.toFixed(1)).join(", ")}`);
  assert.ok(Math.min(...rates) > 1, "it plays");
  assert.deepEqual(said, [], "the console stays empty");
  assert.deepEqual(asked, [], "the page asks the network for nothing");
});

// In the page: from the start, for so long. How many pictures were drawn a second.
async function play(long_enough_s) {
  const { animado } = window;
  const nextFrame = () => new Promise((now) => requestAnimationFrame(now));
  const button = document.getElementById("play");
  if (button.getAttribute("aria-label") === "Pause") button.click();
  animado.goTo(-Infinity);
  button.click();
  await nextFrame();
  const first = animado.pictures(), start_ms = performance.now();
  const elapsed_s = () => (performance.now() - start_ms) / 1000;
  while (elapsed_s() < long_enough_s) await nextFrame();
  return (animado.pictures() - first) / elapsed_s();
}
