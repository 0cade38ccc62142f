// VPython's canvas in this tab: its size, its color, its name, and the loss of the graphics driver.
// It has a camera (camera.js), and it can be touched (mouse.js).
import { fit, follow, limit, resetView } from "camera";
import { canDraw, canvasElement, clearBackground, draw, scene } from "glow";
import { castShadows, endPicture } from "light";
import { fitMarks } from "marks";
import { listen } from "mouse";
import { notice, one, show, state, update } from "page";
import { inWords } from "readout";

let hasBegun = false;

if (!canDraw) notice("no-webgl");

// Show what a message changes: in VPython's drawing, and in the state.
export function showPicture({ drawing, state: changes }) {
  if (canDraw) draw(drawing);
  Object.assign(state, changes);
  for (const name in changes) update(/** @type {any} */ (name));
  if (!hasBegun) return;
  fitMarks();
  castShadows();
}

show("view", view => { // the first one comes with the canvas
  if (!canDraw) return;
  if (!hasBegun) begin();
  follow(view.points);
});

function begin() {
  hasBegun = true;
  const element = canvasElement();
  resetView();
  listen();
  // The first picture waits for the bobs and their textures: one without them would only delay it.
  Object.assign(scene(), { waitfor_textures: true, userpan: false });
  scene().bind("textures", () => scene().waitfor_textures = !scene().objects.length);
  scene().bind("draw_complete", endPicture);
  element.addEventListener("webglcontextlost", stopDrawing);
  element.addEventListener("webglcontextrestored", () => location.reload());
  clearBackground();
  resize();
  setInterval(describe, 1000);
  requestAnimationFrame(watch);
}

// Before each picture: no event tells of all that changes the pixels of the canvas.
function watch() {
  resize();
  limit();
  fitMarks();
  requestAnimationFrame(watch);
}

function resize() { // the canvas fills its part of the window, in the pixels of the display
  const { clientWidth, clientHeight } = one(".canvas");
  const width = Math.round(clientWidth * devicePixelRatio);
  const height = Math.round(clientHeight * devicePixelRatio);
  const isSame = width === scene().width && height === scene().height;
  if (!width || !height || isSame) return;
  Object.assign(scene(), { width, height });
  fit();
}

// The canvas, in words; at most once a second, or a screen reader would never end.
function describe() {
  one(".canvas").ariaLabel = `${document.title}: ${inWords()}`;
}

// The driver was restarted, or the machine slept: all that the graphics card had is gone.
// VPython cannot send it again.
function stopDrawing(event) {
  event.preventDefault(); // or the browser would not restore it
  scene().visible = false; // or VPython would show alerts
  one(".lost").hidden = false;
}
