// The page: a run that it carries, or one that goes on.

import "uplot/dist/uPlot.min.css";
import "./theme.css";
import { Choice, firstMoving } from "./choice.js";
import { Clock } from "./clock.js";
import { byId } from "./dom.js";
import { EventList } from "./event_list.js";
import { keyboard } from "./keyboard.js";
import { live } from "./live.js";
import { Player } from "./player.js";
import { Plots } from "./plots.js";
import { RecordedMotion } from "./recorded_motion.js";
import { sceneText } from "./scene_text.js";
import { sections } from "./sections.js";
import { sequence } from "./sequence.js";
import { summaryTables } from "./summary.js";
import { energySentence, runSentence } from "./summary_sentence.js";
import { themeSwitch } from "./theme.js";
import { toolbar } from "./toolbar.js";
import { Playback, transport } from "./transport.js";
import { PayloadError, unpack } from "./unpack.js";

const is_live = document.documentElement.dataset.live !== undefined;

/** What tests and bookmarklets may use. */
window.animado = {
  ready: (is_live ? live(show) : recorded()).catch(tell),
  goTo: () => {},
  time_s: () => NaN,
  pictures: () => 0,
};

async function recorded() {
  const run = await unpack(byId("run").textContent);
  byId("run").textContent = "";  // megabytes that are not needed any more
  const { header } = run;
  const motion = new RecordedMotion(run);
  const page = show({ ...header, motion, step_s: header.frames > 1 ? motion.times_s[1] - motion.times_s[0] : 1 });
  byId("energy-sentence").textContent = `${runSentence(header.summary)} ${energySentence(header.summary)}`;
  sequence(byId("sequence"), header.traffic);
  summaryTables(byId("summary"), header);
  sections(["plots", "events", "traffic", "scene", "numbers"]);
  if (!matchMedia("(prefers-reduced-motion: reduce)").matches) page.clock.play();
}

/**
 * Everything that shows a run.
 * @param {{scene: string, scene_text: string, bodies: object[], events: object[], motion: object, step_s: number}} run
 */
function show(run) {
  const { times_s } = run.motion;
  const name = run.scene.replace(/^.*\//, "").replace(/\.[^.]*$/, "");
  document.title = `${name} · ANIMADO`;
  byId("name").textContent = name;
  const clock = new Clock(times_s[0] ?? run.start_s, times_s[times_s.length - 1] ?? run.start_s);
  const choice = new Choice(firstMoving(run.bodies));
  const page = { clock, driver: new Playback(clock, run.motion) };
  page.player = picture(run, clock, choice);
  page.plots = new Plots(byId("plot-grid"), run, clock, choice, page.player?.graphics.sparing ?? false);
  page.events = new EventList(byId("event-box"), run.events, clock, run.step_s);
  page.tell = transport(clock, () => page.driver, run.step_s);
  sceneText(byId("scene-text"), run.scene_text);
  themeSwitch(byId("theme"), () => {
    page.player?.paint();
    page.plots.paint();
  });
  keyboard(keys(page, page.player ? toolbar(page.player, run.bodies, choice) : () => {}));
  Object.assign(window.animado, {
    goTo: (time_s) => { clock.pause(); clock.goTo(time_s); },
    time_s: () => clock.time_s,
    pictures: () => page.player?.drawn ?? 0,
  });
  byId("page").hidden = false;
  return page;
}

const FEW = 12;  // bodies whose trails do not hide them

function picture(run, clock, choice) {
  try {
    const player = new Player(byId("player"), run, clock, choice);
    player.show.trails = run.bodies.length <= FEW;
    return player;
  } catch (error) {
    console.warn(error);
    byId("no-picture").hidden = false;  // the rest of the page does not need WebGL
    return null;
  }
}

const keys = (page, toggle) => ({
  " ": () => page.driver.toggle(),
  ArrowLeft: () => page.driver.step(-1),
  ArrowRight: () => page.driver.step(1),
  Home: () => window.animado.goTo(page.clock.start_s),
  End: () => window.animado.goTo(page.clock.end_s),
  "[": () => page.driver.changeSpeed(-1),
  "]": () => page.driver.changeSpeed(1),
  f: () => toggle("follow"),
  t: () => toggle("trails"),
  b: () => toggle("boxes"),
  i: () => toggle("impulses"),
  c: () => page.player?.fit(),
});

function tell(error) {
  byId("notice").textContent = error instanceof PayloadError
    ? error.message
    : `This page failed: ${error.message}. Please report it with the browser's name and version.`;
  byId("notice").hidden = false;
  if (!(error instanceof PayloadError)) throw error;
}
