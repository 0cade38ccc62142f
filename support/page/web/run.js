// A recorded run, in place of the line to the program: it plays the pictures in this file.
// All values in a picture are absolute, and a whole picture has all. So a moment is the last whole
// picture and all later ones up to it, merged.
const LONGEST = 0.1; // s from one picture of the browser to the next: it may sleep in between
const FIXED = ["canvas", "texture"]; // of a shape: they never change in a run

const files = JSON.parse(one(".textures").textContent); // of the textures, by VPython's names
const made = new Map(); // by the number of a shape: the first picture with it
const wanted = new Map(); // the place of the slider
const isOpen = () => true;
const slider = one(".moment");

let pictures = [];
let shown = -1; // the number of the picture that is shown
let time = 0; // s, of the film
let lastDrawn = performance.now(); // ms
let isRunning = false;

addEventListener("DOMContentLoaded", load); // all scripts are there

async function load() {
  for (const name in textures) textures[name] = files[textures[name]] ?? textures[name];
  for (const key of ["n", "h", "?"]) delete keys[key];
  keys.ArrowLeft = () => send("back");
  try {
    pictures = await unpack(one(".run").textContent);
  } catch {
    one(".unheard").textContent = "This browser is too old for this file: open it in another one.";
    return;
  }
  pictures.forEach(({ cmds }, number) => {
    for (const { cmd, idx } of cmds) if (cmd && !made.has(idx)) made.set(idx, number);
  });
  slider.max = pictures.length - 1;
  slider.hidden = false;
  jump(0);
  const isCalm = matchMedia("(prefers-reduced-motion)").matches;
  setRunning(!isCalm && !state.question); // else you read the question first
  requestAnimationFrame(play);
}

async function unpack(text) {
  const bytes = Uint8Array.from(atob(text), letter => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  return JSON.parse(await new Response(stream).text(), (_, value) => files[value] ?? value);
}

const commands = {
  pause() {
    if (!isRunning && shown === pictures.length - 1) jump(0);
    setRunning(!isRunning);
  },
  step: () => isRunning || jump(shown + 1),
  back: () => isRunning || jump(shown - 1),
  restart: () => jump(0),
};

shows.ended = message => one("[data-text=error]").textContent = message ?? "";

function send(name) {
  commands[name]?.();
}

function setRunning(isOn) {
  isRunning = isOn;
  Object.assign(state, { running: isOn, paused: !isOn });
  update("running");
  update("paused");
}

function play(now) {
  const [, place] = wanted.get("moment") ?? [];
  wanted.clear();
  if (place !== undefined) {
    setRunning(false);
    jump(place);
  }
  if (isRunning) {
    time += Math.min((now - lastDrawn) / 1000, LONGEST);
    show(pictures.findLastIndex(picture => picture.time <= time));
    if (shown === pictures.length - 1) setRunning(false);
  }
  lastDrawn = now;
  requestAnimationFrame(play);
}

function jump(number) {
  show(Math.min(Math.max(number, 0), pictures.length - 1));
  time = pictures[shown].time;
}

function show(number) {
  if (number === shown) return;
  const whole = pictures.findLastIndex((picture, i) => picture.whole && i <= number);
  const first = number > shown ? Math.max(shown + 1, whole) : whole;
  showPicture(merged(pictures.slice(first, number + 1)));
  for (const [idx, maker] of made)
    if (maker > number && glowObjs[idx]) glowObjs[idx].visible = false;
  shown = number;
  slider.value = number;
  slider.setAttribute("aria-valuetext", `t ${state.motion.t}`);
  for (const answer of find(".asked button")) answer.disabled = true;
}

// Return pictures that follow each other as one: the last change of each attribute.
function merged(following) {
  const making = new Map();
  const attributes = new Map();
  const changes = {};
  for (const { cmds, attrs, state: values } of following) {
    for (const cmd of cmds.flatMap(again)) putLast(making, `${cmd.idx} ${Object.keys(cmd)}`, cmd);
    for (const text of attrs) putLast(attributes, text.match(/^[^m]\d+./)?.[0] ?? text, text);
    Object.assign(changes, values);
  }
  return { cmds: [...making.values()], attrs: [...attributes.values()], state: changes };
}

// A shape that is there already gets the values with which it was made. VPython's handler changes
// what it gets: so these are copies.
function again({ cmd, idx, ...values }) {
  const object = glowObjs[idx];
  if (!object) return [{ cmd, idx, ...values }];
  if (object.pickable === undefined) return []; // the canvas, or a light
  const names = Object.keys(values).filter(name => !FIXED.includes(name));
  return ["visible", ...names].map(name => ({ idx, [name]: values[name] ?? true }));
}

function putLast(map, key, value) {
  map.delete(key);
  map.set(key, value);
}
