// The page: the state that the program sends, and what shows it.
// The other scripts add to `shows`: for the name of a value in the state, what shows this value.
const state = {};
const shows = {};

const find = selector => [...document.querySelectorAll(selector)];
const one = selector => document.querySelector(selector);
const css = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

// Make an element; texts in parts are never HTML.
function make(kind, attributes = {}, ...parts) {
  const element = Object.assign(document.createElement(kind), attributes);
  element.append(...parts);
  return element;
}

// Keep this in history.state, for this page after a reload, or when Back shows it again.
const remember = part => history.replaceState({ ...history.state, ...part }, "");

const canDraw = !!document.createElement("canvas").getContext("webgl2");
if (!canDraw) notice("no-webgl");

function update(name) {
  shows[name]?.(state[name]);
  showText(name);
  showControl(name);
}

// Show what a message changes: in VPython's drawing, and in the state.
function showPicture({ state: changes, ...drawing }) {
  if (canDraw) handler(decode(drawing)); // VPython's
  Object.assign(state, changes);
  for (const name in changes) update(name);
  if (home) light();
}

function showText(name) {
  const lines = [state[name] ?? ""].flat();
  for (const element of find(`[data-text="${name}"]`)) element.textContent = lines.join("\n");
}

// Fill a place of the page with the template of this id.
function fill(place, id) {
  one(place).replaceChildren(one(`#${id}`).content.cloneNode(true));
  for (const name in state) showText(name);
}

// Say what ends the use of the page.
function notice(id) {
  one(".silence").replaceChildren();
  fill(".notice", id);
  one(".notice").classList.add(id);
  for (const part of find(".canvas, .graph, .panel > :not(.messages, .head)")) part.inert = true;
}

function readoutRow([name, text]) { // its second line is a caption
  const [number, ...captions] = text.split("\n");
  const cell = make("td", {}, `${number} `, ...captions.map(caption => make("small", {}, caption)));
  return make("tr", { className: name }, make("th", { scope: "row" }, name), cell);
}

shows.ended = message => {
  if (message !== null) finish("ended");
};
shows.running = running => {
  one("[data-do=pause]").textContent = running ? "Pause" : "Run";
  for (const button of find("[data-do=step], [data-do=tick]")) button.disabled = running;
};
shows.paused = isPaused => {
  const sign = one(".paused");
  if (isPaused && sign.hidden) tell(); // not again after a cut of the line
  sign.hidden = !isPaused;
};
shows.mistakes = mistakes => {
  one("ul.failed").replaceChildren(...mistakes.map(mistake => make("li", {}, mistake)));
};
shows.motion = motion => one(".readout").replaceChildren(...Object.entries(motion).map(readoutRow));
shows.impacts = lines => one(".series").replaceChildren(...lines.map(impact));
shows.bars = chart => {
  const parts = chart ? [make("h2", {}, chart.title), ...chart.bars.map(makeBar)] : [];
  one(".momenta").replaceChildren(...parts);
};
shows.hit = hit => {
  const place = one(".hit-part");
  place.replaceChildren();
  if (!hit) return;
  place.append(make("strong", {}, hit.title));
  place.append(...hit.lines.map(line => make("span", {}, line)));
  place.append(make("small", {}, hit.caption));
};

// A bar to the left or to the right of a line, which stands for 0.
function makeBar({ name, text, color, part, zero }) {
  const bar = make("i");
  const width = 100 * Math.abs(part) * (1 - zero);
  const left = 100 * zero - (part < 0 ? width : 0);
  Object.assign(bar.style, { left: `${left}%`, width: `${width}%`, background: legible(color) });
  const track = make("span", { className: "track" }, bar);
  track.style.backgroundPosition = `${100 * zero}%`;
  return make("div", {}, make("span", {}, name), track, make("output", {}, text));
}

// A line of the impacts breaks only between two words.
function impact(line) {
  const words = line.split(" ").flatMap(word => [make("span", {}, ...wordOrDots(word)), " "]);
  return make("div", {}, ...words);
}

// A word; of a chain, 1-2-3, its numbers for a screen reader, and a dot in the color of each bob.
// The dot has the bob's number, if another bob has the same color.
function wordOrDots(word) {
  const isChain = /^\d+(-|\.{3})/.test(word); // a long line may end after its first number
  if (!isChain) return [word];
  const numbers = make("span", { className: "unseen" }, word);
  const dots = make("span", { className: "dots", title: word, ariaHidden: true });
  word.split("-").forEach((number, place) => {
    const color = state.colors[number - 1]; // undefined for what is no whole number
    if (place) dots.append("-");
    const isTwice = state.colors.indexOf(color) !== state.colors.lastIndexOf(color);
    const dot = make("i", { style: `background: ${color}` }, isTwice ? number : "");
    dots.append(color ? dot : "...");
  });
  return [numbers, dots];
}

for (const fold of find(".fold")) fold.addEventListener("toggle", () => {
  if (fold.open) fold.scrollIntoView({ block: "nearest" });
});

function present() {
  const root = document.documentElement;
  const isPresenting = root.classList.toggle("presenting");
  if (isPresenting) root.requestFullscreen?.().catch(() => {});
  else if (document.fullscreenElement) document.exitFullscreen();
}
addEventListener("fullscreenchange", () => {
  document.documentElement.classList.toggle("presenting", !!document.fullscreenElement);
});
