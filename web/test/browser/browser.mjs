// Debian's chromium without a screen, drawing by the processor. Where there is none, the tests are skipped and say why.

import { accessSync, constants } from "node:fs";
import { delimiter, join } from "node:path";

const SKIPPED = 77;  // what ctest takes for "skipped" (tests/web/CMakeLists.txt)
const ARGUMENTS = [
  "--headless", "--no-sandbox", "--disable-gpu", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
  "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync",
];

export async function launch() {
  const executablePath = programs("chromium")[0] ?? skip("there is no chromium: scripts/setup --web installs it");
  return await (await playwright()).chromium.launch({ executablePath, args: ARGUMENTS });
}

const programs = (name) => (process.env.PATH ?? "").split(delimiter).map((folder) => join(folder, name)).filter(runs);

function runs(file) {
  try {
    accessSync(file, constants.X_OK);
    return true;
  } catch {
    return false;
  }
}

async function playwright() {
  try {
    return await import("playwright-core");
  } catch (error) {
    if (error.code !== "ERR_MODULE_NOT_FOUND") throw error;
    return skip("playwright-core is not there: scripts/web-packages fetches it");
  }
}

function skip(reason) {
  console.log(`SKIPPED: ${reason}`);
  process.exit(SKIPPED);
}

/** A page whose errors and requests are kept, to be looked at. Motion is reduced: it does not play by itself. */
export async function open(browser, { prepare = async () => {}, address, ...options }) {
  const context = await browser.newContext({ reducedMotion: "reduce", ...options });
  const page = await context.newPage();
  page.errors = [];
  page.requests = [];
  page.on("pageerror", (error) => page.errors.push(error.message));
  page.on("console", (message) => message.type() === "error" && page.errors.push(message.text()));
  page.on("request", (request) => page.requests.push(request.url()));
  await prepare(page);
  await page.goto(address);
  await page.evaluate(() => window.animado.ready);
  return page;
}
