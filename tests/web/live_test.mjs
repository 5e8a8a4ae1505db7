// A run that is watched in a browser, paused, edited, robbed of a service and left to end; and then made again from its
// results, to the same bits. The page is the program's own, served by `animado run --live`.

import assert from "node:assert/strict";
import { spawn, spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { ANIMADO, difference, linesOf, open, picture, pixels, withBrowser } from "./browser.mjs";

const SCENE = `
object ball
shape sphere(radius=0.5)
mass 1
velocity (1, 0, 0)
force (-4*ball.position.x, 0, 0)
object floor
shape plane(normal=(0, 1, 0), offset=-1)
motion static
time
start 0
end 60
step 0.05
`;

/** `animado run --live`, from its start until the address of its page is there. */
function watchedRun(folder) {
  writeFileSync(join(folder, "spring.animado"), SCENE);
  const run = spawn(ANIMADO, ["run", "spring.animado", "--live", "--out", "watched"], { cwd: folder });
  const ended = new Promise((resolve) => run.on("close", resolve));
  return new Promise((resolve, reject) => {
    let said = "";
    run.stderr.on("data", (text) => {
      said += text;
      const address = /http:\/\/127\.0\.0\.1:\d+\/\?token=[0-9a-f]{32}/.exec(said);
      if (address) resolve({ address: address[0], pid: run.pid, ended, said: () => said });
    });
    ended.then(() => reject(new Error(`the run ended early: ${said}`)));
  });
}

function killService(parent, name) {
  const children = readFileSync(`/proc/${parent}/task/${parent}/children`, "utf8").trim().split(" ");
  const child = children.find((pid) => readFileSync(`/proc/${pid}/comm`, "utf8").trim() === name);
  process.kill(Number(child), "SIGKILL");
}

const time = (page) => page.evaluate(() => window.animado.time_s());
const until = (page, time_s) => page.waitForFunction((t) => window.animado.time_s() > t, time_s);

async function edit(page, name, text) {
  await page.locator("#live-name").selectOption(name);
  await page.locator("#live-text").fill(text);
}

await withBrowser(async (browser) => {
  const folder = mkdtempSync(join(tmpdir(), "animado-live-"));
  try {
    const run = await watchedRun(folder);
    const { page, said, asked } = await open(browser, run.address);

    // Bodies move, and the picture with them.
    await until(page, 0.1);
    const canvas = page.locator("#player");
    const before = await picture(canvas, "live-early");
    await until(page, 1);
    const later = await picture(canvas, "live-later");
    assert.ok(difference(await pixels(browser, before), await pixels(browser, later)) > 0.001, "nothing moved");

    // What the supervisor writes of this comes before the edit in a file that is read as it grows.
    killService(run.pid, "egesp");
    await until(page, await time(page) + 0.1);

    // Pause, and a single step.
    const says = (id, pattern) => page.waitForFunction(([id, source]) =>
      new RegExp(source).test(document.getElementById(id).textContent), [id, pattern.source]);
    await page.locator("#play").click();
    await says("live-status", /paused/);
    const paused = await time(page);
    await page.locator("#live-step").click();
    await until(page, paused);

    // What is typed is checked; an edit that makes sense acts.
    await edit(page, "ball.force", "(0, wind, 0)");
    await says("live-answer", /wind/);
    await edit(page, "ball.force", "(0, 3*sin(t), 1)");
    await says("live-answer", /^$/);
    await page.locator("#live-apply").click();
    await page.locator("#play").click();
    await says("live-answer", /From .* on/);
    await picture(page, "live-edited", { fullPage: true });
    await page.locator("#live-status").click();  // out of the form: keys steer the run again
    for (let faster = 0; faster < 12; ++faster) await page.keyboard.press("]");

    assert.equal(await run.ended, 0, run.said());
    await says("live-status", /State hash [0-9a-f]{16}/);
    await picture(page, "live-ended", { fullPage: true });
    const ownSocket = (url) => url.startsWith(run.address.replace("http", "ws").replace("/?", "/live?"));
    assert.deepEqual(asked.filter((url) => !ownSocket(url)), []);
    assert.deepEqual(said, []);

    // The edit was written down, changed the motion, and is made again.
    const events = linesOf(join(folder, "watched/events.jsonl")).map((line) => JSON.parse(line));
    const ofKind = (kind) => events.filter((event) => event.kind === kind);
    assert.equal(ofKind("restart").length, 1);
    assert.deepEqual(ofKind("edit").map(({ name, value }) => [name, value]),
      [["ball.force", "(0, 3*sin(t), 1)"]]);
    const hash = (results) => JSON.parse(readFileSync(join(folder, results, "summary.json"))).state_hash;
    const animado = (...words) => assert.equal(spawnSync(ANIMADO, words, { cwd: folder }).status, 0);
    animado("run", "--replay", "watched", "--no-pictures");
    assert.equal(hash("watched-replay"), hash("watched"));
    animado("run", "spring.animado", "--out", "unedited", "--no-pictures");
    assert.notEqual(hash("unedited"), hash("watched"));
  } finally {
    rmSync(folder, { recursive: true });
  }
});
