// The picture of the motion. It draws when something changed and rests otherwise; while the clock plays, it is what
// makes the clock go.

import { BasicShadowMap, Color, PCFShadowMap, Raycaster, Scene, Vector2, WebGLRenderer } from "three";
import { Bodies } from "./bodies.js";
import { BoundingBoxes } from "./bounding_boxes.js";
import { motionBounds, reachRadius } from "./bounds.js";
import { Camera } from "./camera.js";
import { graphics } from "./graphics.js";
import { Impulses } from "./impulses.js";
import { pose } from "./interpolate.js";
import { bracket } from "./moments.js";
import { Sharpness } from "./sharpness.js";
import { Stage } from "./stage.js";
import { colorOf } from "./theme.js";
import { Trails } from "./trails.js";

const IMPULSE_SEEN_S = 0.4;  // in front of the screen, at any speed
const ARROW_RADII = 4;       // the longest arrow, in radii of the largest body
const CLICK_PX = 4;          // a pointer that moved farther was turning the camera
const SLOWEST_S = 0.25;      // a page that was hidden does not leap forward when it is back

export class Player {
  show = { trails: true, boxes: false, impulses: true, follow: false };
  drawn = 0;  // pictures so far
  #renderer;
  #scene = new Scene();
  #sharpness;
  #run;
  #clock;
  #choice;
  #poses;
  #waiting = 0;
  #before_ms = 0;
  #moved = true;
  #largest_m;

  /**
   * @param {HTMLCanvasElement} canvas
   * @param {{bodies: object[], motion: object, events: object[]}} run
   * @param {import("./choice.js").Choice} choice the body that the reader looks at
   */
  constructor(canvas, run, clock, choice) {
    this.graphics = graphics(run.bodies.length);
    this.#sharpness = new Sharpness(this.graphics.moving);
    this.#renderer = new WebGLRenderer({ canvas, antialias: this.graphics.antialias });
    this.#renderer.shadowMap.enabled = true;
    this.#renderer.shadowMap.type = this.graphics.soft ? PCFShadowMap : BasicShadowMap;
    this.#renderer.shadowMap.autoUpdate = false;
    this.#run = run;
    this.#clock = clock;
    this.#choice = choice;
    this.#largest_m = Math.max(...run.bodies.map(({ shape }) => reachRadius(shape)));
    this.#poses = new Float32Array(7 * run.bodies.length);
    this.camera = new Camera(canvas, () => this.invalidate());
    this.stage = new Stage(run.bodies, run.motion, this.graphics.shadow_px);
    this.bodies = new Bodies(run.bodies, this.graphics);
    this.boxes = new BoundingBoxes(run.bodies);
    this.trails = new Trails(run.bodies, run.motion);
    this.impulses = new Impulses(run.events, this.graphics.impulses);
    this.#scene.add(this.stage, this.bodies, this.boxes, this.trails, this.impulses);
    this.#listen(canvas);
  }

  #listen(canvas) {
    for (const kind of ["time", "state"]) this.#clock.addEventListener(kind, () => this.changed());
    this.#choice.addEventListener("change", () => this.changed());
    new ResizeObserver(() => this.#resize(canvas)).observe(canvas.parentElement);
    let down = null;
    canvas.addEventListener("pointerdown", (event) => (down = event));
    canvas.addEventListener("pointerup", (event) => {
      const moved_px = down ? Math.hypot(event.clientX - down.clientX, event.clientY - down.clientY) : Infinity;
      if (moved_px <= CLICK_PX) this.#pick(canvas, event);
    });
  }

  #resize(canvas) {
    const { clientWidth: width, clientHeight: height } = canvas.parentElement;
    if (!width || !height) return;
    this.#renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    if (!this.camera.touched) this.fit();
    this.invalidate();
  }

  #pick(canvas, event) {
    const box = canvas.getBoundingClientRect();
    const x = ((event.clientX - box.left) / box.width) * 2 - 1;
    const y = 1 - ((event.clientY - box.top) / box.height) * 2;
    const ray = new Raycaster();
    ray.setFromCamera(new Vector2(x, y), this.camera);
    const body = this.bodies.pick(ray, this.#poses);
    if (body !== null) this.#choice.choose(body);
  }

  /** The whole motion in view. */
  fit() {
    if (!this.#run.motion.frames) return;
    const box = motionBounds(this.#run.bodies, this.#run.motion);
    this.camera.fit(box);
    this.stage.fit(box);
    this.paint();
  }

  /** A live run goes where nobody could know: the view widens with it, unless the reader has turned it. */
  refitIfNeeded() {
    if (this.camera.touched || this.show.follow) return;
    const { low, high } = motionBounds(this.#run.bodies, this.#run.motion);
    if (Math.hypot(...high.map((value, i) => value - low[i])) / 2 > 1.05 * this.camera.radius_m) this.fit();
  }

  /** Takes the page's colours anew. */
  paint() {
    this.stage.paint(this.#scene, 5 * this.camera.radius_m, 22 * this.camera.radius_m);
    this.boxes.material.color = new Color(colorOf("--accent"));
    this.impulses.material.color = new Color(colorOf("--impulse"));
    this.changed();
  }

  /** Bodies are elsewhere: their shadows too. */
  changed() {
    this.#moved = true;
    this.invalidate();
  }

  invalidate() {
    this.#waiting ||= requestAnimationFrame((now_ms) => this.#frame(now_ms));
  }

  #frame(now_ms) {
    this.#waiting = 0;
    if (this.#clock.playing) {
      const elapsed_s = this.#before_ms ? (now_ms - this.#before_ms) / 1000 : 0;
      if (elapsed_s > 0) this.#sharpness.tell(1000 * elapsed_s);
      this.#before_ms = now_ms;
      this.#clock.advance(Math.min(SLOWEST_S, elapsed_s));
      this.changed();
    } else {
      this.#before_ms = 0;
    }
    this.#draw();
  }

  #draw() {
    if (!this.#run.motion.frames) return;
    if (this.#moved) this.#place();
    this.#sharpen(this.#clock.playing ? this.#sharpness.ratio : this.graphics.sharpest);
    const hurried = this.#clock.playing && this.graphics.hurries;
    this.stage.showShadows(!hurried);
    this.bodies.hurry(hurried);
    this.#renderer.shadowMap.needsUpdate = this.#moved && !hurried;
    this.#moved = false;
    this.#renderer.render(this.#scene, this.camera);
    ++this.drawn;
  }

  #sharpen(wanted) {
    const ratio = Math.min(wanted, devicePixelRatio);
    if (ratio !== this.#renderer.getPixelRatio()) this.#renderer.setPixelRatio(ratio);
  }

  #place() {
    const { bodies, motion } = this.#run;
    const now = bracket(motion.times_s, this.#clock.time_s);
    for (let body = 0; body < bodies.length; ++body) pose(motion, body, now, this.#poses, 7 * body);
    this.bodies.show(this.#poses);
    this.camera.follow(this.show.follow ? this.#choice.body : null, this.#poses);
    this.boxes.show(this.#poses, this.show.boxes ? bodies.keys() : [this.#choice.body]);
    this.trails.visible = this.show.trails;
    if (this.show.trails) this.trails.show(now.frame, this.#poses, this.#choice.body);
    this.impulses.visible = this.show.impulses;
    if (this.show.impulses) {
      const longest_m = Math.min(0.6 * this.camera.radius_m, ARROW_RADII * this.#largest_m);
      this.impulses.show(this.#clock.time_s, IMPULSE_SEEN_S * this.#clock.speed, longest_m);
    }
  }
}
