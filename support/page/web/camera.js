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
const INK = vec(0.5, 0.5, 0.53); // of the texts
const SMALLEST = 0.875; // height of the numbers, in heights of the page's text
const LETTER = 0.55; // width of a letter, in heights

// How the texts look, by their kind; yoffset 1 is above a place, -1 below it.
const PLAIN = { color: INK, opacity: 0, border: 5 };
const STYLES = {
  number: { ...PLAIN, yoffset: 1 },
  dial: { ...PLAIN, yoffset: 0 },
  bob: { opacity: 0.7, border: 4, yoffset: -1 },
  name: { opacity: 0.7, border: 6, yoffset: 1 },
};

let home; // the center and the range with which the whole cradle fills the canvas
let fitted; // the points for which it does
let written = 0; // the range (m) for which the texts are written
const labels = []; // VPython's, for the texts

export function follow(points) {
  const isNew = fitted !== JSON.stringify(points);
  fitted = JSON.stringify(points);
  if (isNew) fit();
  else writeTexts(); // the camera stays as you turned it
}

// Point the camera at the middle of the view's points, just far enough away to show them all.
// The shorter side of the canvas shows 2 range (m) of the plane through the center. The camera is
// at the distance d = range / tan(fov / 2). A point at the distance x from the axis of view, and z
// nearer to the camera than the center, appears in that plane at x d / (d - z). So range * side /
// shorter side must be at least x d / (d - z).
export function fit() {
  const { width, height, fov, up } = scene();
  const forward = scene().forward.norm();
  const sideways = forward.cross(up).norm();
  const upwards = sideways.cross(forward);
  const points = state.view.points.map(point => vec(...point));
  let center = vec(0, 0, 0);
  for (const direction of [forward, sideways, upwards]) {
    const places = points.map(point => point.dot(direction));
    const middle = (Math.min(...places) + Math.max(...places)) / 2;
    center = center.add(direction.multiply(middle));
  }
  const shorter = Math.min(width, height);
  let range = 0;
  for (const point of points) {
    const arm = point.sub(center);
    const x = Math.abs(arm.dot(sideways)) * shorter / width;
    const y = Math.abs(arm.dot(upwards)) * shorter / height;
    range = Math.max(range, Math.max(x, y) - arm.dot(forward) * Math.tan(fov / 2));
  }
  home = { center, range: MARGIN * range };
  Object.assign(scene(), home);
  writeTexts();
}

// Look in a direction; without one, in that of the start.
export function look(direction) {
  scene().forward = vec(...direction ?? FORWARD);
}

export function resetView() {
  look();
  scene().up = vec(0, 1, 0);
  fit();
}
one(".view").addEventListener("click", resetView);

// The camera never looks at the base from below, stays upright, and comes back if it sees nothing.
export function limit() {
  const { forward, up, center, range } = scene();
  const away = center.sub(home.center);
  const allowed = Math.min(Math.max(range, NEAREST * home.range), FARTHEST * home.range);
  if (forward.y > 0) scene().forward = vec(forward.x, 0, forward.z);
  if (up.y !== 1) scene().up = vec(0, 1, 0);
  if (allowed !== range) scene().range = allowed;
  if (away.mag > 1.001 * home.range)
    scene().center = home.center.add(away.norm().multiply(home.range));
  const turn = forward.norm().sub(vec(...FORWARD).norm()).mag;
  const way = Math.max(Math.abs(allowed - home.range), away.mag);
  one(".view").hidden = turn <= MOVED && way <= MOVED * home.range;
  if (written !== allowed) writeTexts(); // you have zoomed
}

// Write the numbers of the pendula above as many axles as they fit, and the labels.
function writeTexts() {
  const { numbers, top, text_height } = state.view;
  const { width, height, range } = scene();
  written = range;
  const pageSize = parseFloat(getComputedStyle(document.documentElement).fontSize) * devicePixelRatio;
  const size = Math.max(SMALLEST * pageSize, text_height * height);
  const pixel = 2 * range / Math.min(width, height); // m
  const span = (numbers.at(-1).x - numbers[0].x) / pixel;
  const apart = span / (numbers.length - 1) || Infinity; // pixels from axle to axle
  const widest = size * widthOf(numbers.at(-1).text);
  const step = [1, 5, 10, 50].find(step => step * apart >= widest) ?? Infinity;
  const fitting = numbers.filter((_, i) => i === 0 || (i + 1) % step === 0);
  const above = ({ x, text }) => ({ pos: vec(x, top, 0), text, height: size, ...STYLES.number });
  const inside = ({ x, y, text, kind }) => {
    const height = kind === "bob" ? Math.min(size, apart / widthOf(text)) : size;
    const colors = kind === "dial" ? {} : { color: colorOf("--ink"), background: colorOf("--paper") };
    return { pos: vec(x, y, 0), text, height, ...colors, ...STYLES[kind] };
  };
  const shown = state.view.labels.filter(({ answer }) => isShown(answer));
  showLabels([...fitting.map(above), ...shown.map(inside)]);
}

// Return the width of a text with a gap, in heights of its letters.
function widthOf(text) {
  const lengths = text.split("\n").map(line => line.length);
  return LETTER * (1 + Math.max(...lengths));
}

function showLabels(texts) { // labels that are not needed wait, out of sight
  while (labels.length < texts.length)
    labels.push(label({ canvas: scene(), box: false, line: false, font: "sans-serif" }));
  labels.forEach((label, i) => Object.assign(label, texts[i], { visible: i < texts.length }));
}
