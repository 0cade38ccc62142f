// The keys, and which element has them.
import { resetView } from "camera";
import { one, state } from "page";
import { present } from "present";
import { send, set } from "program";
import { tell } from "readout";

const SLOWEST = 1000; // ms between the two halves of a double click

/** @type {Record<string, () => void>} */
export const keys = {
  " ": () => send("pause"),
  ArrowRight: () => send("step"),
  r: () => send("restart"),
  n: () => send("next"),
  p: () => send("previous"),
  f: () => present(),
  v: () => resetView(),
  h: () => set("slow_hits", !state.controls.slow_hits.value),
  t: () => tell(),
  "?": () => one("#keys").togglePopover(),
};

// Return what a key means: what you type or, on an alphabet without such letters, the key's place.
function keyOf({ key, code }) {
  if (key.length > 1) return key;
  const isForeign = key > "~";
  return (isForeign ? code.replace(/^(Key|Digit)/, "") : key).toLowerCase();
}

// Return the digit of a key: as typed, or that of its place, where a digit needs Shift.
function digitOf(key, code) {
  if (/^[1-9]$/.test(key)) return +key;
  return +(code.match(/^Digit([1-9])$/)?.[1] ?? 0);
}

addEventListener("keydown", event => {
  const isPresenting = document.documentElement.classList.contains("presenting");
  if (event.key === "Escape" && isPresenting) { // without full screen
    if (!one("#gallery").matches(":popover-open")) present(); // else it only closes the pictures
    return;
  }
  const isShortcut = event.metaKey || event.ctrlKey || event.altKey;
  const isHeld = event.repeat && event.key !== "ArrowRight";
  const key = keyOf(event);
  const isLetter = key.length === 1 && key !== " "; // a control needs the other keys itself
  const isTyping = event.target.matches?.("select, [type=text]"); // a letter finds a choice there
  const isForUs = event.target === document.body || (isLetter && !isTyping);
  if (isShortcut || !isForUs) return;
  if (isHeld) {
    if (key in keys) event.preventDefault();
    return;
  }
  const digit = digitOf(key, event.code);
  const isAsking = state.question?.asking; // a stray digit must not end the question
  const answer = ["a", "b", "c", "d", "e"].indexOf(key);
  if (key in keys) keys[key]();
  else if (digit && !isAsking && state.controls) // a saved run has none
    set("lifted", Math.min(digit, state.controls.lifted.max));
  else if (answer >= 0 && state.question) send("answer", state.question.key, answer);
  else return;
  event.preventDefault(); // no key scrolls the page
});

// A control that you reach with the Tab key keeps the keys; one that you click does not.
let byMouse = false;
let pressed; // the control that you have clicked last
let place; // where it was then; nothing once the mouse has left it
let pressedAt = 0; // ms
let isStray = false;

const isAt = ({ left, right, top, bottom }, { clientX, clientY }) =>
  left <= clientX && clientX <= right && top <= clientY && clientY <= bottom;

// The second half of a slow double click can meet another control, which has come below the mouse
// since the first half: this click does nothing.
addEventListener("pointerdown", event => {
  const control = event.target.closest?.("label, button, summary, select");
  const isSoon = event.timeStamp - pressedAt < SLOWEST;
  const isAgain = byMouse && isSoon && place && isAt(place, event);
  isStray = isAgain && control?.textContent !== pressed.textContent;
  byMouse = true;
  pressed = control;
  pressedAt = event.timeStamp;
  place = control?.getBoundingClientRect();
}, true);
addEventListener("pointermove", event => {
  if (place && !isAt(place, event)) place = null;
}, true);
addEventListener("keydown", () => byMouse = false, true);
addEventListener("click", event => {
  if (!byMouse || !isStray) return;
  event.preventDefault();
  event.stopPropagation();
}, true);
addEventListener("click", ({ target }) => { // a click on a menu only opens it
  if (target.tagName !== "SELECT") giveKeysBack(target);
});
addEventListener("change", ({ target }) => {
  if (target.tagName === "SELECT") giveKeysBack(target);
});

function giveKeysBack(target) {
  if (byMouse && target.type !== "text") one(":focus")?.blur();
}
