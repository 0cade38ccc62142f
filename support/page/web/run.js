// A recorded run, in place of the line to the program: it plays the pictures in this file.
// All values in a picture are absolute, and a whole picture has all. So a moment is the last whole
// picture and all later ones up to it.
import "places"; // first: the other modules look for elements there
import "controls";
import "graph";
import "questions";
import "readout";
import { showPicture } from "canvas";
import { isShape, objects, takeImagesFrom } from "glow";
import { keys } from "keys";
import { css, find, make, one, show, state, update } from "page";
import { setLine, sliders } from "program";

const LONGEST_STEP = 0.1; // s of a picture: a browser that was busy, or hidden, goes on from there
const FIXED = ["canvas", "texture"]; // of a shape: they never change in a run

const files = JSON.parse(one(".textures").textContent); // of the textures, by their names
const slider = one(".moment");

let pictures = [];
let current = -1; // the number of the picture on the page
let time = 0; // s, of the film
let lastDrawn = performance.now(); // ms
let isRunning = false;

const commands = {
  pause() {
    if (isRunning) jump(upTo(current));
    else if (current === pictures.length - 1) jump(0);
    setRunning(!isRunning);
  },
  step: () => isRunning || jump(Math.max(current, from(current + 1))),
  restart: () => jump(0),
};
// A saved run has no controls, and nothing that one can do before its pictures are there.
for (const key of ["h", "n", "?"]) delete keys[key];
keys.ArrowLeft = () => isRunning || !pictures.length || jump(upTo(current - 1));
setLine({ send: ([name]) => pictures.length && commands[name]?.(), isOpen: () => true });
show("ended", message => one("[data-text=error]").textContent = message ?? "");
takeImagesFrom(makeTexture);
load();

async function load() {
  try {
    if (!css("--back")) throw new Error("its styles are missing");
    pictures = await unpack(one(".run").textContent);
    for (const { state } of pictures)
      if (state.view) state.view.finger = 0; // nobody drags a bob: a finger on it turns the camera
    jump(0);
  } catch ({ message }) { // the browser is too old, or a site forbids a part of the file
    const advice = "Open the file in another browser, or from your disk.";
    one(".instead").textContent = `This run does not play here: ${message}. ${advice}`;
    document.documentElement.classList.remove("opened");
    return;
  }
  slider.max = pictures.at(-1).time;
  slider.hidden = false;
  const isCalm = matchMedia("(prefers-reduced-motion)").matches;
  setRunning(!isCalm && !state.question); // else you read the question first
  requestAnimationFrame(play);
}

async function unpack(text) {
  const stream = contentOf(text).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Response(stream).json();
}

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

// A page gets its numbers ten times a second: only a picture with them is right in all.
function upTo(last) {
  return pictures.findLastIndex(({ state }, i) => i <= last && state.motion);
}

function from(first) {
  return pictures.findIndex(({ state }, i) => i >= first && state.motion);
}

function setRunning(isOn) {
  isRunning = isOn;
  Object.assign(state, { running: isOn, paused: !isOn });
  update("running");
  update("paused");
}

function play(now) {
  const place = sliders.get("moment");
  sliders.clear();
  if (place !== undefined) {
    setRunning(false);
    jump(upTo(pictures.findLastIndex(picture => picture.time <= place)));
  }
  if (isRunning) {
    time += Math.min((now - lastDrawn) / 1000, LONGEST_STEP);
    go(pictures.findLastIndex(picture => picture.time <= time));
    if (current === pictures.length - 1) setRunning(false);
  }
  lastDrawn = now;
  requestAnimationFrame(play);
}

function jump(number) {
  go(Math.max(number, 0));
  time = pictures[current].time;
}

// Go to the picture with this number.
function go(number) {
  if (number === current) return;
  let first = pictures.findLastIndex((picture, i) => picture.whole && i <= number);
  if (number > current) first = Math.max(first, current + 1);
  const some = pictures.slice(first, number + 1);
  if (some[0].whole) hideAll();
  showPicture({
    cmds: some.flatMap(picture => picture.cmds.flatMap(again)),
    attrs: some.flatMap(picture => picture.attrs),
    state: Object.assign({}, ...some.map(picture => picture.state)),
  });
  current = number;
  slider.value = pictures[number].time;
  slider.setAttribute("aria-valuetext", `t ${state.motion?.t}`.trim());
  for (const answer of find(".questions button")) answer.disabled = true;
}

// What was made later must not be seen; a whole picture shows again what is there.
function hideAll() {
  for (const shape of objects.filter(isShape)) shape.visible = false;
}

// A shape that is there already gets the values with which it was made.
function again({ cmd, idx, ...values }) {
  const object = objects[idx];
  if (!object) return [{ cmd, idx, ...values }]; // VPython's handler changes what it gets
  if (!isShape(object)) return [];
  const names = Object.keys(values).filter(name => !FIXED.includes(name));
  return ["visible", ...names].map(name => ({ idx, [name]: values[name] ?? true }));
}
