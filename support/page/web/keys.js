// The keys of the page.
import { resetView } from "camera";
import { one, state } from "page";
import { present } from "present";
import { send, set } from "program";
import { tell } from "readout";

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

// Return whether an element has a use of its own for a key.
function takes(element, key) {
  if (element.matches("select, [type=text]")) return true;
  if (key === " ") return element.matches("button, summary, input:not([type=range])");
  return key === "ArrowRight" && element.matches("[type=range]");
}

// Return what answers a question with this letter, if there is a question.
function answerWith(letter) {
  const number = ["a", "b", "c", "d", "e"].indexOf(letter);
  if (number >= 0 && state.question) return () => send("answer", state.question.key, number);
}

addEventListener("keydown", event => {
  const isPresenting = document.documentElement.classList.contains("presenting");
  if (event.key === "Escape" && isPresenting) { // without full screen
    if (!one("#gallery").matches(":popover-open")) present(); // else it only closes the pictures
    return;
  }
  if (event.metaKey || event.ctrlKey || event.altKey || takes(event.target, event.key)) return;
  const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
  const act = keys[key] ?? answerWith(key);
  if (!act) return;
  event.preventDefault(); // no key scrolls the page
  const isHeld = event.repeat && key !== "ArrowRight";
  if (!isHeld) act();
});

// A control that you reach with the Tab key keeps its own keys; one that you click gives them back.
let isByMouse = false;
addEventListener("pointerdown", () => isByMouse = true, true);
addEventListener("keydown", () => isByMouse = false, true);
addEventListener("click", ({ target }) => {
  if (!target.matches("select, [type=text]")) giveKeysBack();
});
addEventListener("change", giveKeysBack);

function giveKeysBack() {
  if (isByMouse) one(":focus")?.blur();
}
