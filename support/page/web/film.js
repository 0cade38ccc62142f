// A film, in place of the connection to the program: it plays the pictures in this file, up to a
// question that you have not answered.
// All values in a picture are absolute. So a moment is all pictures up to it.
import { showPicture } from "canvas";
import { hideAll, takeImagesFrom } from "glow";
import { make, one, state, update } from "page";
import { setSender, sliders } from "program";

const LONGEST_STEP = 0.1; // s of a picture: a browser that was busy, or hidden, goes on from there
const SLOWLY = 0.1; // times real time

const files = JSON.parse(one(".textures").textContent); // of the textures, by their names
const slider = one(".moment");

takeImagesFrom(makeTexture);
const film = contentOf(one(".film").textContent).stream().pipeThrough(new DecompressionStream("gzip"));
const pictures = await new Response(film).json();
const last = pictures.length - 1;

let current = -1; // the number of the picture on the page
let time = 0; // s, of the film
let lastDrawn = 0; // ms
let speed = 1; // times real time

// Your answers, by the state of the question that asks for them; null is none. All pictures share
// them, so questions.js and marks.js find yours in each picture.
const replies = {};
const states = []; // of the question, in each picture: one that is no key above never waits
for (const { state: { question } } of pictures) {
  Object.assign(replies, question?.replies);
  if (question) question.replies = replies;
  states.push(question === undefined ? states.at(-1) : question?.state);
}

const commands = {
  pause() {
    jump(current < last ? current : 0);
    setRunning(!state.running);
  },
  step: () => jump(current + 1),
  restart() {
    forgetReplies();
    jump(0);
    setRunning(!state.paused);
  },
  answer(_, number) {
    if (!waits(current) || number >= state.question.answers.length) return;
    replies[states[current]] = number;
    jump(current);
    setRunning(true);
  },
  repeat() {
    jump(1 + states.findLastIndex((_, number) => number < current && isAnswered(number)));
    setRunning(true, SLOWLY);
  },
};
setSender(([name, ...values]) => commands[name]?.(...values));
slider.max = pictures[last].time;
forgetReplies();
jump(0);
setRunning(!matchMedia("(prefers-reduced-motion)").matches && !state.unknown);
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

function forgetReplies() {
  for (const state in replies) replies[state] = null;
}

// Return whether a picture waits for your answer.
function waits(number) {
  return replies[states[number]] === null;
}

function isAnswered(number) {
  return Number.isInteger(replies[states[number]]);
}

// Return the number of the first picture from this one on for which this is true, or of the last one.
function firstFrom(number, isIt) {
  const found = pictures.findIndex((_, other) => other >= number && isIt(other));
  return found < 0 ? last : found;
}

function setRunning(isOn, newSpeed = 1) {
  speed = newSpeed;
  const isWaiting = waits(current);
  Object.assign(state, { running: isOn && !isWaiting, paused: !isOn && !isWaiting });
  update("running");
  update("paused");
  document.documentElement.classList.toggle("waiting", isWaiting);
}

function play(now) {
  const place = sliders.get("moment");
  sliders.clear();
  if (place !== undefined) {
    jump(numberAt(place));
    setRunning(false);
  }
  if (state.running) {
    time = Math.max(time, pictures[current].time); // it is earlier than what follows an answer
    time += speed * Math.min((now - lastDrawn) / 1000, LONGEST_STEP);
    go(numberAt(time));
    if (waits(current) || current === last) setRunning(current < last);
  }
  lastDrawn = now;
  requestAnimationFrame(play);
}

function numberAt(time) {
  return pictures.findLastIndex(picture => picture.time <= time);
}

// A page gets its numbers ten times a second: only a picture with them is right in all.
function jump(number) {
  go(firstFrom(number, other => pictures[other].state.motion));
  time = pictures[current].time;
}

// Go to the picture with this number: what has changed since the one that is shown, or since the first.
// Leave out what you have answered, and stop at the first question that waits.
function go(number) {
  number = firstFrom(number, other => !isAnswered(other));
  number = Math.min(number, firstFrom(0, waits));
  if (number === current) return;
  const isLater = number > current;
  if (!isLater) hideAll();
  const some = pictures.slice(isLater ? current + 1 : 0, number + 1);
  showPicture({
    drawing: merged(some),
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
  return Object.fromEntries(last);
}
