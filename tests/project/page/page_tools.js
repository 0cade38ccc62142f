// What the tests do and look at in a page, by the names of these functions. All that the modules
// export which these tests need is global there, too.
import * as glow from "glow";
import * as page from "page";
import * as program from "program";
import { resetView } from "camera";
import { present } from "present";

const { bobs, kindOf, scene, vec } = glow;
const { find, make, one, state } = page;
const { send, set } = program;

// --- the picture -------------------------------------------------------------------------------

const positions = () => bobs().map(({ pos }) => [pos.x, pos.y]);

const visible = kind => scene().objects.filter(shape => kindOf(shape) === kind);

const texts = () => glow.objects.filter(o => kindOf(o) === "label" && o.visible).map(o => o.text);

// Return whether the bobs are elsewhere a third of a second later.
async function moves() {
  const before = String(positions());
  await new Promise(resolve => setTimeout(resolve, 333));
  return String(positions()) !== before;
}

// Return where a point of the plane of swing is seen: pixels in the window.
function pixel([x, y]) {
  const { forward, up, center, range, fov } = scene();
  const ahead = forward.norm();
  const sideways = ahead.cross(up).norm();
  const upwards = sideways.cross(ahead);
  const arm = vec(x, y, 0).sub(center);
  const distance = range / Math.tan(fov / 2);
  const canvas = one(".canvas").getBoundingClientRect();
  const half = Math.min(canvas.width, canvas.height) / 2;
  const pixels = half / range * distance / (distance + arm.dot(ahead));
  return [
    canvas.x + canvas.width / 2 + pixels * arm.dot(sideways),
    canvas.y + canvas.height / 2 - pixels * arm.dot(upwards),
  ];
}

const cursor = () => getComputedStyle(one(".canvas canvas:last-of-type")).cursor;

// Return how light the picture is at these places: of each one, the parts of its color together.
function lights(places) {
  scene().__renderer.render(0);
  const { width, height } = one(".canvas canvas");
  const pen = make("canvas", { width, height }).getContext("2d", { willReadFrequently: true });
  pen.drawImage(one(".canvas canvas"), 0, 0);
  return places.map(([x, y]) => {
    const [red, green, blue] = pen.getImageData(x, y, 1, 1).data;
    return red + green + blue;
  });
}

// --- the state and the controls ----------------------------------------------------------------

let first; // the controls as the page has opened, but without Ask
let ticket; // of the last command with which the page is put back

// Put the settings back to those with which the page opens, pause, and restart the cradle.
function putBack() {
  first ??= { ...state.controls, ask: { value: false } };
  const isOwn = name => name === "speed" || first[name].kind !== "Slider";
  for (const name of Object.keys(first).filter(isOwn)) set(name, first[name].value);
  set("experiment", "My cradle"); // once more: as the program has started, and it runs
  send("pause");
  if (one("#sound").checked) one("#sound").click();
  for (const open of find("details[open]")) open.open = false;
  for (const popover of find("[popover]")) popover.hidePopover();
  if (document.documentElement.matches(".presenting")) present();
  one("#small").disabled = false;
  /** @type {any} */ (document.activeElement).blur();
  resetView();
  scene().visible = false;
  ticket = Math.random();
  send("save_csv", ticket);
}

// Return whether the program has done all this: it has answered the last command. What the page
// shows can look the same before it.
const isBack = () => state.saved_csv?.ticket === ticket && !state.error;

// Return whether a film has been played to its end. The time of a picture is the slider's value.
function isOver() {
  const { valueAsNumber, max } = one(".moment");
  return valueAsNumber > max - 0.01 && !state.running;
}

Object.assign(window, glow, page, program, {
  cursor, isBack, isOver, lights, moves, pixel, positions,
  putBack, texts, visible,
});
