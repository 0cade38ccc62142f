// A recorded run, in place of the line to the program: it plays the pictures in this file.
// All values in a picture are absolute, and a whole picture has all. So a moment is the last whole
// picture and all later ones up to it.
import "places"; // first: the other modules look for elements there
import "controls";
import "graph";
import "questions";
import "readout";
import "unknown";
import { showPicture, showYourGhosts } from "canvas";
import { isShape, objects, takeImagesFrom } from "glow";
import { keys } from "keys";
import { css, make, one, show, state, update } from "page";
import { setLine, sliders } from "program";

const LONGEST_STEP = 0.1; // s of a picture: a browser that was busy, or hidden, goes on from there
const SLOWLY = 0.1; // times real time
const FIXED = ["canvas", "texture"]; // of a shape: they never change in a run

const files = JSON.parse(one(".textures").textContent); // of the textures, by their names
const slider = one(".moment");

let pictures = [];
let current = -1; // the number of the picture on the page
let time = 0; // s, of the film
let lastDrawn = performance.now(); // ms
let isRunning = false;
let speed = 1; // times real time

let recorded; // the question as it was recorded
let asks = false; // whether it is asked here: the pictures begin before the answer
const replies = { predicted: null, seen: null }; // yours

const commands = {
  pause() {
    if (state.question?.asking) say("Choose an answer first.");
    else if (isRunning) jump(upTo(current));
    else if (current === pictures.length - 1) jump(release());
    setRunning(!isRunning);
  },
  step: () => isRunning || isWaiting() || jump(Math.max(current, from(current + 1))),
  restart() {
    replies.predicted = replies.seen = null;
    jump(0);
    showQuestion();
  },
  answer(_, number) {
    const { asking } = state.question ?? {};
    if (!asking || number >= recorded.answers.length) return;
    replies[asking] = number;
    if (asking === "predicted") again(1);
    showQuestion();
    setRunning(true);
  },
  repeat: slowly => again(slowly ? SLOWLY : 1),
};
// A saved run has no controls, and nothing that one can do before its pictures are there.
for (const key of ["h", "n", "p", "?"]) delete keys[key];
setLine({
  send: ([name, ...values]) => pictures.length && commands[name]?.(...values),
  isOpen: () => true,
});
show("ended", message => one("[data-text=error]").textContent = message ?? "");
takeImagesFrom(makeTexture);
load();

async function load() {
  try {
    if (!css("--back")) throw new Error("its styles are missing");
    pictures = await unpack(one(".run").textContent);
    for (const { state } of pictures)
      if (state.view) state.view.finger = 0; // nobody drags a bob: a finger on it turns the camera
    asks = !!pictures[0].state.question && !pictures[0].state.question.happened;
    document.documentElement.classList.toggle("asks", asks);
    jump(0);
  } catch ({ message }) { // the browser is too old, or a site forbids a part of the file
    const advice = "Open the file in another browser, or from your disk.";
    one(".instead").textContent = `This run does not play here: ${message}. ${advice}`;
    document.documentElement.classList.remove("opened");
    return;
  }
  slider.max = pictures.at(-1).time;
  const isCalm = matchMedia("(prefers-reduced-motion)").matches;
  setRunning(!isCalm && !state.unknown);
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
  isRunning = isOn && !state.question?.asking;
  Object.assign(state, { running: isRunning, paused: !isRunning });
  update("running");
  update("paused");
}

// Before you predict, nothing shows what happens.
const isWaiting = () => !pictures.length || state.question?.asking === "predicted";

// The question as it is for you. The film shows it as it was when it was recorded.
function yourQuestion() {
  if (!recorded) return recorded;
  if (!asks) return { ...recorded, asking: null };
  return { ...recorded, asking: asked(), replies: { ...replies } };
}

function asked() {
  if (replies.predicted === null) return "predicted";
  return recorded.happened && replies.seen === null ? "seen" : null;
}

function showQuestion() {
  state.question = yourQuestion();
  update("question");
  showYourGhosts();
  slider.hidden = isWaiting();
  say("");
}

function say(word) {
  state.word = word;
  update("word");
}

// Return the number of the picture of the release: a class may have thought for some time.
function release() {
  return pictures.findIndex(({ state }) => state.question && state.question.asking !== "predicted");
}

function again(newSpeed) {
  speed = newSpeed;
  jump(release());
  setRunning(true);
}

function play(now) {
  const place = sliders.get("moment");
  sliders.clear();
  if (place !== undefined) {
    setRunning(false);
    jump(upTo(pictures.findLastIndex(picture => picture.time <= place)));
  }
  if (isRunning) {
    time += speed * Math.min((now - lastDrawn) / 1000, LONGEST_STEP);
    go(pictures.findLastIndex(picture => picture.time <= time));
    if (recorded?.happened) speed = 1;
    const isLast = current === pictures.length - 1;
    if (isLast && asks && recorded && !recorded.happened) say("This run was saved before its first swing.");
    if (isLast || state.question?.asking) setRunning(false);
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
  const changes = Object.assign({}, ...some.map(picture => picture.state));
  if ("question" in changes) recorded = changes.question;
  showPicture({
    cmds: some.flatMap(picture => picture.cmds.flatMap(asChange)),
    attrs: some.flatMap(picture => picture.attrs),
    state: { ...changes, question: yourQuestion() },
  });
  current = number;
  slider.hidden = isWaiting();
  slider.value = pictures[number].time;
  slider.setAttribute("aria-valuetext", `t ${state.motion?.t}`.trim());
}

// What was made later must not be seen; a whole picture shows again what is there.
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
