// SPDX-License-Identifier: GPL-3.0-or-later
// The case that is open, as the server has it, and who wants to know of it.

import { ask } from "./api.js";
import { say } from "./dom.js";

export const model = { name: "", version: 0, text: "", values: null, check: null, handles: null, sketch: null };
const listeners = {};
let queue = Promise.resolve();
let pause = 0;

export function on(event, listener) {
  (listeners[event] ||= []).push(listener);
}
export function forget() {
  for (const event of Object.keys(listeners)) delete listeners[event];
}
export function tell(event) {
  for (const listener of listeners[event] || []) listener();
}

/** Takes a case as the server sent it. */
export function takeCase(answer) {
  Object.assign(model, {
    name: answer.case,
    file: answer.file,
    version: answer.version,
    text: answer.text,
    values: answer.values || null,
    unused: answer.unused || [],
    broken: answer.problem || null,
    bundled: answer.bundled,
    undo: answer.undo,
    redo: answer.redo,
  });
  tell("case");
  checkSoon();
}

export async function openCase(name) {
  Object.assign(model, { check: null, handles: null, sketch: null, wantsSketch: false, wanted: "" });
  takeCase(await ask("case", { case: name }));
}

/** Does work after all that was asked for before, also where that failed. */
export function inTurn(work) {
  const done = queue.then(work);
  queue = done.catch(() => null);
  return done;
}

/** Changes follow each other, what was typed first, each of the version that the one before has left. False where it was refused. */
export function change(question, asked = {}) {
  return inTurn(async () => {
    if (model.flush) await model.flush();
    try {
      takeCase(await ask(question, { ...asked, case: model.name, version: model.version }));
      say("");
      return true;
    } catch (error) {
      say(error.message);
      await news();
      tell("case");
      return false;
    }
  });
}

let previewed = null,
  waiting = null;

/** The numbers as they would be; while one answer is awaited only the last question waits. */
export async function preview(asked) {
  waiting = asked;
  if (previewed) return;
  while (waiting) {
    previewed = waiting;
    waiting = null;
    try {
      model.check = await ask("check", { ...previewed, case: model.name });
      tell("check");
    } catch (error) {
      say(error.message);
    }
  }
  previewed = null;
}
export const stopPreview = () => (waiting = null);

async function checkSoon() {
  clearTimeout(pause);
  const { name, version } = model;
  const isOld = () => name !== model.name || version !== model.version || previewed;
  await preview({});
  pause = setTimeout(async () => {
    if (isOld()) return;
    const [check, handles] = await Promise.all([
      ask("check", { case: name, meshes: true }),
      ask("handles", { case: name }).catch(() => null),
    ]).catch(() => [null, null]); // of a case that is gone
    if (!check || isOld()) return;
    model.check = check;
    model.handles = handles;
    tell("handles");
    tell("check");
    if (model.follows && !check.problem && !check.cannot_begin) sketch();
  }, 250);
}

export async function sketch() {
  await ask("sketch", { case: model.name });
  model.wantsSketch = true;
  model.sketch = { ...model.sketch, running: true };
  tell("sketch");
}

/** Draws the wall of a finished run into the section. */
export async function showResult(results) {
  model.sketch = { ...(await ask("outline", { results, case: model.name, wanted: model.wanted })), results, version: model.version };
  tell("sketch");
}

/** Compares the wall that is drawn with a table beside the case. */
export async function wantWall(name) {
  model.wanted = name;
  if (model.sketch && model.sketch.results) return showResult(model.sketch.results);
  model.wantsSketch = Boolean(model.sketch);
  return news();
}

/** Asks what is new: text, run, sketch. */
export async function news() {
  if (!model.name) return;
  const answer = await ask("news", {
    case: model.name,
    version: model.version,
    results: model.results || "",
    sketch: Boolean(model.wantsSketch),
    wanted: model.wanted || "",
  });
  if (answer.case === model.name && answer.version !== model.version) takeCase(answer);
  if (answer.run) {
    model.run = answer.run;
    tell("run");
  }
  if (!answer.sketch || !model.wantsSketch) return;
  if (answer.sketch.running) answer.sketch.outlines_mm = model.sketch && model.sketch.outlines_mm;
  else model.wantsSketch = false;
  model.sketch = answer.sketch;
  tell("sketch");
}
