// A recorded run, in place of the line to the program: it plays the pictures in this file.
// All values in a picture are absolute, and the first one has all. So a moment is all pictures up to
// it.
import "controls";
import "graph";
import "hits";
import "keys";
import "questions";
import "readout";
import "unknown";
import { showPicture } from "canvas";
import { isShape, objects, takeImagesFrom } from "glow";
import { make, one, show, state, update } from "page";
import { setLine, sliders } from "program";

const LONGEST_STEP = 0.1; // s of a picture: a browser that was busy, or hidden, goes on from there
const SLOWLY = 0.1; // times real time
const FIXED = ["canvas", "texture"]; // of a shape: they never change in a run

const files = JSON.parse(one(".textures").textContent); // of the textures, by their names
const slider = one(".moment");

show("ended", message => one("[data-text=error]").textContent = message ?? "");
takeImagesFrom(makeTexture);
const run = contentOf(one(".run").textContent).stream().pipeThrough(new DecompressionStream("gzip"));
const pictures = await new Response(run).json();
const last = pictures.length - 1;

let current = -1; // the number of the picture on the page
let time = 0; // s, of the film
let lastDrawn = 0; // ms
let speed = 1; // times real time

const states = pictures.map(({ state }) => state.question?.state);
const question = pictures.findLast(({ state }) => state.question?.why)?.state.question;
const asks = question && states[0] === "running"; // else the film begins later
const end = asks ? states.indexOf("explained") : Infinity; // of the first swing
const replies = { asked: null, seen: null }; // yours
let hasSeen = false; // whether you have seen the first swing

const commands = {
  pause() {
    if (stands()) return say("Choose an answer first.");
    if (state.running) jump(current);
    else if (current === last) jump(0);
    setRunning(!state.running);
  },
  step() {
    if (!state.running && !stands()) jump(current + 1);
  },
  restart() {
    replies.asked = replies.seen = null;
    hasSeen = false;
    jump(0);
    setRunning(state.running && !asks);
  },
  answer(_, number) {
    const { state: asked, answers } = state.question ?? {};
    if (!(asked in replies) || number >= answers.length) return;
    replies[asked] = number;
    swing(1);
  },
  repeat: () => swing(SLOWLY),
};
setLine(([name, ...values]) => commands[name]?.(...values));
for (const { state } of pictures) {
  delete state.question; // it is yours now
  if (state.view) state.view.finger = 0; // nobody drags a bob: a finger on it turns the camera
}
slider.max = pictures[last].time;
jump(0);
const isCalm = matchMedia("(prefers-reduced-motion)").matches;
setRunning(!isCalm && !state.unknown && !stands());
requestAnimationFrame(play);

function contentOf(letters) {
  return new Blob([Uint8Array.from(atob(letters), letter => letter.charCodeAt(0))]);
}

// A site may forbid images that are a part of the page, but not what the page draws: so a texture
// is a canvas with the picture.
function makeTexture() {
  const canvas = make("canvas");
  setTimeout(drawTexture, 0, canvas); // VPython first sets its src and onload
  return canvas;
}

async function drawTexture(canvas) {
  const picture = await createImageBitmap(contentOf(files[canvas.src]));
  Object.assign(canvas, { width: picture.width, height: picture.height });
  canvas.getContext("2d").drawImage(picture, 0, 0);
  canvas.onload();
}

function setRunning(isOn) {
  Object.assign(state, { running: isOn, paused: !isOn });
  update("running");
  update("paused");
}

function yourState() {
  if (!asks) return "explained";
  if (replies.asked === null) return "asked";
  if (!hasSeen) return "running";
  return replies.seen === null ? "seen" : "explained";
}

// Return whether the cradle waits at its release for an answer.
function stands() {
  return current === 0 && ["asked", "seen"].includes(state.question?.state);
}

function say(word) {
  state.word = word;
  update("word");
}

// Show the first swing, at this speed.
function swing(newSpeed) {
  speed = newSpeed;
  say("");
  jump(0);
  setRunning(true);
}

function play(now) {
  const place = sliders.get("moment");
  sliders.clear();
  if (place !== undefined) {
    setRunning(false);
    jump(numberAt(place));
  }
  if (state.running) {
    time += speed * Math.min((now - lastDrawn) / 1000, LONGEST_STEP);
    go(numberAt(time));
    if (current >= end) endSwing();
    if (current === last) setRunning(false);
  }
  lastDrawn = now;
  requestAnimationFrame(play);
}

function numberAt(time) {
  return pictures.findLastIndex(picture => picture.time <= time);
}

// Ask what you have seen; the cradle then stands as at the release.
function endSwing() {
  speed = 1;
  hasSeen = true;
  if (replies.seen !== null) return;
  jump(0);
  setRunning(false);
}

// A page gets its numbers ten times a second: only a picture with them is right in all.
function jump(number) {
  const next = pictures.findIndex(({ state }, i) => i >= number && state.motion);
  go(next < 0 ? last : next);
  time = pictures[current].time;
  if (question) state.question = { ...question, state: yourState(), replies };
  update("question");
  slider.hidden = stands();
}

// Go to the picture with this number: what has changed since the one that is shown, or since the first.
function go(number) {
  if (number === current) return;
  const isLater = number > current;
  if (!isLater) hideAll();
  const some = pictures.slice(isLater ? current + 1 : 0, number + 1);
  const drawing = merged(some);
  showPicture({
    cmds: drawing.filter(change => change.idx !== undefined).flatMap(asChange),
    attrs: drawing.filter(change => change.idx === undefined),
    state: Object.assign({}, ...some.map(picture => picture.state)),
  });
  current = number;
  slider.value = pictures[number].time;
  slider.setAttribute("aria-valuetext", `t ${state.motion?.t}`);
}

// Return the last change by each key; the order matters.
function merged(some) {
  const last = new Map();
  for (const { drawing } of some)
    for (const key in drawing) {
      last.delete(key);
      last.set(key, drawing[key]);
    }
  return [...last.values()];
}

// What was made later must not be seen; the makers of what is there show it again.
function hideAll() {
  for (const shape of objects.filter(isShape)) shape.visible = false;
}

// A shape that is there already gets the values with which it was made.
function asChange({ cmd, idx, ...values }) {
  const object = objects[idx];
  if (!object) return [{ cmd, idx, ...values }]; // VPython's handler changes what it gets
  if (!isShape(object)) return [];
  const names = Object.keys(values).filter(name => !FIXED.includes(name));
  return ["visible", ...names].map(name => ({ idx, [name]: values[name] ?? true }));
}
