// src/clock.js

import assert from "node:assert/strict";
import { test } from "node:test";
import { Clock, Readable, SPEEDS } from "../src/clock.js";

function heard(clock) {
  const events = [];
  for (const kind of ["time", "state"]) clock.addEventListener(kind, () => events.push(kind));
  return events;
}

test("a time outside the run is its start or its end, and the same time is no news", () => {
  const clock = new Clock(1, 3);
  const events = heard(clock);
  clock.goTo(9);
  assert.equal(clock.time_s, 3);
  clock.goTo(10);
  assert.deepEqual(events, ["time"]);
  clock.goTo(-1);
  assert.equal(clock.time_s, 1);
});

test("it goes as fast as its speed says, stops at the end and begins again from the start", () => {
  const clock = new Clock(0, 1);
  clock.setSpeed(1 / 4);
  clock.play();
  clock.advance(2);
  assert.equal(clock.time_s, 0.5);
  clock.advance(2);
  assert.equal(clock.playing, false);
  assert.equal(clock.time_s, 1);
  clock.play();
  assert.equal(clock.time_s, 0);
});

test("a clock that stands does not advance", () => {
  const clock = new Clock(0, 1);
  clock.advance(0.5);
  assert.equal(clock.time_s, 0);
});

test("speeds go step by step and end at both ends", () => {
  const clock = new Clock(0, 1);
  const events = heard(clock);
  clock.changeSpeed(1);
  assert.equal(clock.speed, 2);
  for (let i = 0; i < 9; ++i) clock.changeSpeed(-1);
  assert.equal(clock.speed, SPEEDS[0]);
  assert.ok(events.every((kind) => kind === "state"));
});

test("what is read is due always while the clock stands, and now and then while it plays", () => {
  const clock = new Clock(0, 1);
  const values = new Readable(clock);
  assert.ok(values.due(1000) && values.due(1001));
  clock.play();
  assert.equal(values.due(1050), false);
  assert.equal(values.due(1200), true);
  assert.equal(values.due(1250), false);
});
