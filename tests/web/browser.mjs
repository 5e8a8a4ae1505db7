// A page in Debian's Chromium, with an ear on all that it says and asks for: what every test of a page that the program
// wrote needs.

import { mkdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { launch } from "../../web/test/browser/browser.mjs";

export const SOURCE = new URL("../../", import.meta.url).pathname;
export const BUILD = process.env.ANIMADO_BUILD_DIR ?? join(SOURCE, "build/release");
export const ANIMADO = join(BUILD, "bin/animado");
export const PICTURES = join(BUILD, "web/pictures");

/** A browser for the life of `use`. */
export async function withBrowser(use) {
  const browser = await launch();
  try {
    return await use(browser);
  } finally {
    await browser.close();
  }
}

// Said of a picture that the processor drew, whatever the page.
const OF_THE_BROWSER = /GL Driver Message .* GPU stall due to ReadPixels/;

/**
 * Opens a page and listens. `said` gathers what it wrote to the console and its uncaught errors, `asked` every request
 * but the first, for the page itself: of a page that is well both stay empty.
 */
export async function open(browser, url, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 900 }, ...options });
  const page = await context.newPage();
  const said = [], asked = [];
  page.on("console", (message) => {
    if (!OF_THE_BROWSER.test(message.text())) said.push(`${message.type()}: ${message.text()}`);
  });
  page.on("pageerror", (error) => said.push(`uncaught: ${error}`));
  page.on("request", (request) => {
    const inside = /^(data|blob):/.test(request.url());
    if (request.url() !== url && !inside) asked.push(request.url());
  });
  await page.goto(url);
  await page.evaluate(() => window.animado.ready);
  return { page, said, asked, close: () => context.close() };
}

/** A picture of an element or of the page, kept under its name for whoever wants to look. */
export async function picture(what, name, options = {}) {
  mkdirSync(PICTURES, { recursive: true });
  return await what.screenshot({ path: join(PICTURES, `${name}.png`), ...options });
}

/** The pixels of PNG pictures of one size, unpacked by the browser: red, green, blue, alpha, row by row. */
export async function pixels(browser, png) {
  const page = await browser.newPage();
  const numbers = await page.evaluate(async (base64) => {
    const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    const bitmap = await createImageBitmap(new Blob([bytes], { type: "image/png" }));
    const pen = new OffscreenCanvas(bitmap.width, bitmap.height).getContext("2d");
    pen.drawImage(bitmap, 0, 0);
    let text = "";
    for (const value of pen.getImageData(0, 0, bitmap.width, bitmap.height).data) text += String.fromCharCode(value);
    return btoa(text);
  }, png.toString("base64"));
  await page.close();
  return Buffer.from(numbers, "base64");
}

/** How many colours there are, each told by its upper five bits a channel. */
export function colours(picture) {
  const seen = new Set();
  for (let at = 0; at < picture.length; at += 4) {
    seen.add(((picture[at] >> 3) << 10) | ((picture[at + 1] >> 3) << 5) | (picture[at + 2] >> 3));
  }
  return seen.size;
}

/** The share of pixels that differ so much that a person sees it. */
export function difference(one, other) {
  const SEEN = 24;  // of 255, over all channels
  let count = 0;
  for (let at = 0; at < one.length; at += 4) {
    const by = [0, 1, 2].reduce((sum, c) => sum + Math.abs(one[at + c] - other[at + c]), 0);
    if (by > SEEN) ++count;
  }
  return count / (one.length / 4);
}

export const linesOf = (file) => readFileSync(file, "utf8").split("\n").filter((line) => line);
