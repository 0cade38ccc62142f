// The keys of the page, and the list of them.
import { resetView } from "camera";
import { make, one, state } from "page";
import { present } from "present";
import { send, set } from "program";
import { tell } from "readout";

/** What each key does: in words, and in deed. @type {Record<string, [string, () => void]>} */
const keys = {
  " ": ["pause, run", () => send("pause")],
  ArrowRight: ["one step, or the next hit", () => send("step")],
  r: ["restart", () => send("restart")],
  v: ["reset the view", resetView],
  f: ["present, and end it", present],
  n: ["next experiment", () => send("next")],
  p: ["previous experiment", () => send("previous")],
  h: ["slow hits", () => set("slow_hits", !state.controls?.slow_hits.value)],
  t: ["tell a screen reader what you would see", tell],
  "?": ["this list", () => one("#keys").togglePopover()],
};
const NAMES = { " ": "Space", ArrowRight: "→" };

for (const key in keys) {
  const name = make("th", {}, NAMES[key] ?? key.toUpperCase());
  one("#keys table").append(make("tr", {}, name, make("td", {}, keys[key][0])));
}

// A control that you reach with the Tab key keeps its own keys; one that you click does not.
let isByMouse = false;
addEventListener("pointerdown", () => isByMouse = true, true);

addEventListener("keydown", event => {
  const { target, repeat, metaKey, ctrlKey, altKey } = event;
  const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
  if (key === "Tab") isByMouse = false;
  const isTyped = target.matches("select, [type=text]");
  const isItsOwn = !isByMouse && target !== document.body && key in NAMES;
  if (metaKey || ctrlKey || altKey || isTyped || isItsOwn) return;
  const answer = "abcde".indexOf(key);
  if (answer >= 0 && state.question) send("answer", state.question.stem, answer);
  if (!keys[key]) return;
  event.preventDefault(); // no key scrolls the page
  target.blur(); // Firefox would press a button all the same
  const isHeld = repeat && key !== "ArrowRight";
  if (!isHeld) keys[key][1]();
});
