// The page: its websocket, the state that the program sends, and the commands that it gets.
// The other scripts add to `shows`: for the name of a value in the state, what shows this value.
const state = {}, shows = {};
const find = selector => [...document.querySelectorAll(selector)];
const one = selector => document.querySelector(selector);
const css = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
const make = (kind, attributes = {}, ...parts) => { // an element; texts in parts are never HTML
  const element = Object.assign(document.createElement(kind), attributes);
  element.append(...parts);
  return element;
};

const canDraw = !!document.createElement("canvas").getContext("webgl2");
const address = new URL(`ws${location.search}`, location.href); // relative to the page, whatever stands before it
address.protocol = address.protocol.replace("http", "ws");
address.searchParams.set("page", Math.random()); // the program knows the page again when its line was cut
const QUIET = 4, LONGEST = 10, FIRST = 60; // looks without a word: to say so, to connect again, for the first message
let socket, retry, has = 0, unseen = 0, seen = 0, nextWord = 0; // has: the number of the last message
let silence = 0, delay = 0, isHeard = true, isDone = false;
const wanted = new Map(); // the last command of each slider that you move

const isOpen = () => socket?.readyState === WebSocket.OPEN;
const tell = (...command) => { // a late drag would be wrong, but a bob that is let go must not stay in the air
  if (isOpen() && (isHeard || command[0] === "let go")) socket.send(JSON.stringify(command));
};

addEventListener("DOMContentLoaded", () => { // all scripts are there
  connect();
  setInterval(look, 1000);
  requestAnimationFrame(countPictures);
});

function connect() { // the program sends what is later than the last message
  if (isDone) return;
  clearTimeout(retry);
  socket?.close();
  address.searchParams.set("has", has);
  const line = socket = new WebSocket(address);
  line.onmessage = event => line === socket && take(event);
  line.onclose = () => line === socket && lose();
}

function lose() {
  if (isDone) return;
  isHeard = false;
  silence = 0;
  wanted.clear();
  clearTimeout(retry);
  retry = setTimeout(connect, delay);
  delay = Math.min(delay + 1000, 5000);
  explain();
}

async function explain() { // why the websocket has closed; a proxy may answer in the program's place
  const answer = await fetch(`alive${location.search}`).then(answer => answer.text(), () => "");
  if (answer.includes("ends with a key")) finish("ended"); // another start has another key
  else if (answer === "alive" && !isHeard) fill(".unheard", "no-websocket");
}

function look() { // each second, but seldom in a tab that nobody sees: so it counts looks, not time
  if (isDone) return;
  silence++;
  if (silence > QUIET) isHeard = false;
  if (silence > (isOpen() && !has ? FIRST : LONGEST)) lose();
  if (!isHeard && !one(".unheard").firstChild) fill(".unheard", "unheard");
}

const hurry = () => isOpen() || connect();
addEventListener("online", hurry);
addEventListener("visibilitychange", hurry);

function hear() {
  silence = 0;
  delay = 0;
  if (isHeard) return;
  isHeard = true;
  one(".unheard").replaceChildren();
  for (const name in state) if (name !== "sound") update(name); // a control may show what was not sent
}

function take(event) {
  hear();
  if (!event.data) return; // only a sign of life
  unseen++;
  const { number, state: changes, ...drawing } = JSON.parse(event.data);
  has = number;
  if (canDraw) handler(decode(drawing)); // VPython's
  Object.assign(state, changes);
  for (const name in changes) update(name);
}

// For each picture that the browser has drawn, the program may send one message more. Few words are quicker than many.
function countPictures(now) {
  if (unseen > seen) seen++;
  if (isOpen() && (seen > 2 || (seen || wanted.size) && now > nextWord)) {
    socket.send("seen ".repeat(seen));
    for (const command of wanted.values()) tell(...command); // each one restarts the cradle
    wanted.clear();
    [unseen, seen, nextWord] = [unseen - seen, 0, now + 45];
  }
  requestAnimationFrame(countPictures);
}

// A browser that keeps the page for Back would keep the websocket open.
addEventListener("pagehide", () => {
  isDone = true;
  navigator.sendBeacon(`goodbye${address.search}`); // not by the websocket: what is on its way here can take it back
  socket?.close();
});
addEventListener("pageshow", event => {
  if (!event.persisted || one(".notice").firstChild) return;
  isDone = false;
  connect();
});

function fill(place, id) {
  one(place).replaceChildren(one(`#${id}`).content.cloneNode(true));
  for (const name in state) show(name);
}

function notice(id) {
  one(".unheard").replaceChildren();
  fill(".notice", id);
  one(".notice").classList.add(id);
  for (const part of find(".canvas, .graph, .panel > :not(.messages)")) part.inert = true;
}
if (!canDraw) notice("no-webgl");

function finish(id) {
  isDone = true;
  notice(id);
}

function update(name) {
  shows[name]?.(state[name]);
  show(name);
}

function show(name) {
  for (const element of find(`[data-text="${name}"]`)) element.textContent = [state[name] ?? ""].flat().join("\n");
  for (const box of find(`[type=checkbox][name="${name}"]`)) box.checked = state[name];
  for (const menu of find("select")) {
    const isNew = name === `${menu.name}s`; // experiments has the choices of experiment
    if (isNew) menu.replaceChildren(...state[name].map(choice => new Option(choice, choice)));
    if (isNew || name === menu.name && !menu.matches(":active")) menu.value = state[menu.name] ?? "";
  }
}

// A slider shows its value with a unit; value is a number, or [number, the largest one].
function showSlider(slider, value, text) {
  const [number, most] = [value].flat();
  slider.max = most ?? slider.max;
  if (!slider.matches(":active")) slider.value = number;
  slider.nextElementSibling.value = text;
  slider.setAttribute("aria-valuetext", text);
}

shows.ended = words => words !== null && finish("ended");
shows.running = running => {
  one("[data-do=pause]").textContent = running ? "Pause" : "Run";
  for (const button of find("[data-do=step], [data-do=tick]")) button.disabled = running;
};
shows.speed = speed => showSlider(one("#speed"), speed, `${speed.toFixed(1)}x`);
shows.lifted = lifted => showSlider(one("#lifted"), lifted, `${lifted[0]} of ${lifted[1]}`);
let lifts; // the names and ends of the sliders that are there
shows.angles = angles => {
  if (lifts === JSON.stringify(angles)) return;
  lifts = JSON.stringify(angles);
  for (const old of find(".lift")) old.remove();
  angles.forEach(([name, min, max], number) => one(".after-lifts").before(
    make("label", { className: "lift", htmlFor: `lift-${number}` }, name),
    make("input", { className: "lift", type: "range", id: `lift-${number}`, min, max }),
    make("output", { className: "lift" })));
};
shows.lifts = lifts => lifts.forEach((lift, number) => showSlider(one(`#lift-${number}`), lift, `${Number(lift.toPrecision(4))}°`));
shows.mistakes = mistakes => one("ul.failed").replaceChildren(...mistakes.map(mistake => make("li", {}, mistake)));
shows.motion = motion => one(".readout").replaceChildren(...Object.entries(motion).map(([name, text]) =>
  make("tr", {}, make("th", { scope: "row" }, name), make("td", {}, text))));
shows.impacts = lines => one(".trains").replaceChildren(...lines.map(line => // a line breaks only between two words
  make("div", {}, ...line.split(" ").flatMap(word => [make("span", {}, word), " "]))));
shows["has rule"] = has => one("[name=separating]").disabled = !has;
shows.hit = hit => one(".hit-part").replaceChildren(...hit ? [make("strong", {}, hit.title),
  ...hit.lines.map(line => make("span", {}, line)), make("small", {}, hit.note)] : []);

addEventListener("click", event => {
  const button = event.target.closest?.("button");
  if (button?.dataset.do) tell(button.dataset.do);
  if (button?.matches(".present")) present();
});
addEventListener("input", ({ target }) => {
  const command = target.name ? [target.name] : ["lift", +target.id.slice(5)];
  if (target.type === "range") wanted.set(target.id, [...command, +target.value]);
});
addEventListener("change", ({ target }) => {
  if (target.name && target.type !== "range") tell(target.name, target.type === "checkbox" ? target.checked : target.value);
});
one(".fold").addEventListener("toggle", event => event.target.open && event.target.scrollIntoView({ block: "nearest" }));

function present() {
  if (document.documentElement.classList.toggle("presenting")) document.documentElement.requestFullscreen?.().catch(() => {});
  else if (document.fullscreenElement) document.exitFullscreen();
}
addEventListener("fullscreenchange", () => document.documentElement.classList.toggle("presenting", !!document.fullscreenElement));

// What you type counts; on an alphabet that has no such letter, the key's place does.
const keys = {
  " ": () => tell("pause"), ArrowRight: () => tell("step"), r: () => tell("restart"), n: () => tell("next"), f: present,
  v: () => resetView(), h: () => tell("slow hits", !state["slow hits"]), "?": () => one("#keys").togglePopover(),
};
addEventListener("keydown", event => {
  if (event.key === "Escape" && document.documentElement.classList.contains("presenting")) return present(); // without full screen
  const isForUs = event.target === document.body && !event.metaKey && !event.ctrlKey && !event.altKey;
  if (!isForUs || event.repeat && event.key !== "ArrowRight") return;
  const key = event.key.length === 1 && event.key > "~" ? event.code.replace(/^(Key|Digit)/, "").toLowerCase() : event.key;
  const letter = key.length === 1 ? key.toLowerCase() : key, answer = [..."abcde"].indexOf(letter);
  const digit = /^[1-9]$/.test(letter) ? letter : event.code.match(/^Digit([1-9])$/)?.[1];
  if (letter in keys) keys[letter]();
  else if (digit) tell("lifted", Math.min(+digit, state.lifted[1]));
  else if (answer >= 0 && state.question) tell("answer", state.question.key, answer);
  else return;
  event.preventDefault(); // no key scrolls the page
});

// A control that you reach with the Tab key keeps the keys; one that you use with the mouse does not.
let byMouse = false;
addEventListener("pointerdown", () => byMouse = true, true);
addEventListener("keydown", () => byMouse = false, true);
for (const [type, isSelect] of [["click", false], ["change", true]]) // a click on a menu only opens it
  addEventListener(type, ({ target }) => {
    if (byMouse && (target.tagName === "SELECT") === isSelect && target.type !== "text") document.activeElement.blur();
  });
