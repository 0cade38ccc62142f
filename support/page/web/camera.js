// The camera of this tab: it shows the whole cradle, and does not lose it when you turn and zoom.
// And the texts in its picture: the numbers above the axles, and the labels.
import { colorOf } from "colors";
import { isShown } from "ghosts";
import { label, scene, vec } from "glow";
import { one, state } from "page";

const FORWARD = [0, -0.2, -1]; // the camera looks a little from above
const MARGIN = 1.04; // the view is larger than the cradle by this factor
const NEAREST = 0.1; // of the range with which the whole cradle fills the canvas
const FARTHEST = 3;
const MOVED = 1e-3; // the least part of the range, or turn (rad), by which a camera has moved
const TEXT = 1 / 30; // height of the numbers, in heights of the canvas
const SMALLEST = 0.875; // the same, at least, in heights of the page's text
const LETTER = 0.55; // width of a letter, in heights

// How the texts look, by their kind; yoffset 1 is above a place, -1 below it.
const PLAIN = { color: "--pale", opacity: 0, border: 5 };
const ON_PAPER = { color: "--ink", opacity: 0.7, border: 5 };
const STYLES = {
  number: { ...PLAIN, yoffset: 1 },
  dial: { ...PLAIN, yoffset: 0 },
  bob: { ...ON_PAPER, yoffset: -1 },
  name: { ...ON_PAPER, yoffset: 1 },
};

let home; // the range (m) with which the whole cradle fills the canvas
let fitted; // the points for which it does
let written = 0; // the range (m) for which the texts are written
const drawn = []; // VPython's labels

export function follow(points) {
  if (fitted === String(points)) return writeTexts(); // the camera stays as you turned it
  fitted = String(points);
  fit();
}

// Point the camera at the view's center, just far enough away to show all its points.
// The shorter side of the canvas shows 2 range (m) of the plane through the center. The camera is
// at the distance d = range / tan(fov / 2). A point at the distance x from the axis of view, and z
// nearer to the camera than the center, appears in that plane at x d / (d - z). So range * side /
// shorter side must be at least x d / (d - z).
export function fit() {
  const { width, height, fov, up } = scene();
  const forward = scene().forward.norm();
  const sideways = forward.cross(up).norm();
  const upwards = sideways.cross(forward);
  const center = vec(...state.view.center);
  const shorter = Math.min(width, height);
  let range = 0;
  for (const point of state.view.points) {
    const arm = vec(...point).sub(center);
    const x = Math.abs(arm.dot(sideways)) * shorter / width;
    const y = Math.abs(arm.dot(upwards)) * shorter / height;
    range = Math.max(range, Math.max(x, y) - arm.dot(forward) * Math.tan(fov / 2));
  }
  home = MARGIN * range;
  Object.assign(scene(), { center, range: home });
  writeTexts();
}

// Look in the direction of the start.
export function look() {
  scene().forward = vec(...FORWARD);
}

export function resetView() {
  look();
  fit();
}
one(".view").addEventListener("click", resetView);

// The camera never looks at the base from below, stays upright, and is neither too near nor too far.
export function limit() {
  const { forward, up, range } = scene();
  const allowed = Math.min(Math.max(range, NEAREST * home), FARTHEST * home);
  if (forward.y > 0) scene().forward = vec(forward.x, 0, forward.z);
  if (up.y !== 1) scene().up = vec(0, 1, 0);
  if (allowed !== range) scene().range = allowed;
  const turn = forward.diff_angle(vec(...FORWARD));
  one(".view").hidden = turn <= MOVED && Math.abs(allowed - home) <= MOVED * home;
  if (written !== allowed) writeTexts(); // you have zoomed
}

// Write the labels, and the numbers of the pendula above as many axles as they fit.
function writeTexts() {
  const { numbers, labels } = state.view;
  const { width, height, range } = scene();
  written = range;
  const pageSize = parseFloat(getComputedStyle(document.documentElement).fontSize) * devicePixelRatio;
  const size = Math.max(SMALLEST * pageSize, TEXT * height);
  const pixel = 2 * range / Math.min(width, height); // m
  const span = (numbers.at(-1).x - numbers[0].x) / pixel;
  const apart = span / (numbers.length - 1) || Infinity; // pixels from axle to axle
  const widest = size * widthOf(numbers.at(-1).text);
  const step = [1, 5, 10, 50].find(step => step * apart >= widest) ?? Infinity;
  const above = numbers.filter((_, i) => i === 0 || (i + 1) % step === 0);
  const shown = labels.filter(({ answer }) => isShown(answer));
  const texts = above.concat(shown).map(({ x, y, text, kind }) => ({
    ...STYLES[kind],
    pos: vec(x, y, 0),
    text,
    height: kind === "bob" ? Math.min(size, apart / widthOf(text)) : size,
    color: colorOf(STYLES[kind].color),
    background: colorOf("--paper"),
  }));
  while (drawn.length < texts.length)
    drawn.push(label({ canvas: scene(), box: false, line: false, font: "sans-serif" }));
  // Labels that are not needed wait, out of sight.
  drawn.forEach((label, i) => Object.assign(label, texts[i], { visible: i < texts.length }));
}

// Return the width of a text with a gap, in heights of its letters.
function widthOf(text) {
  const lengths = text.split("\n").map(line => line.length);
  return LETTER * (1 + Math.max(...lengths));
}
