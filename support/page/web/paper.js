// The cradle on paper, as it is now; on the sheet of an experiment, as it was before its release.
// It is a canvas: a browser that hides the pixels of canvases would make stripes of an image.
import { bobs, drawNow, layers, scene, vec } from "glow";
import { drawGraph } from "graph";
import { make, one, state } from "page";

let keptName; // the name of the experiment of which the picture before the release is kept
let before = "";

addEventListener("beforeprint", () => {
  const place = one(state.question ? ".sketch" : ".picture");
  if (scene()) place.replaceChildren(state.question ? pictureBefore() : paperPicture());
  document.documentElement.classList.add("on-paper");
  one(".plot").replaceChildren(); // Chromium prints nothing of what flot draws on old canvases
  drawGraph();
});
addEventListener("afterprint", () => {
  document.documentElement.classList.remove("on-paper");
  requestAnimationFrame(drawGraph); // the page is not yet as wide as it was
});

export function keepPicture() {
  const { asking, name } = state.question ?? {};
  if (!asking || name === keptName || !bobs().every(bob => bob.ready)) return;
  keptName = name;
  before = paperPicture();
}

// Return the picture before the release of the present experiment, if it was drawn.
const pictureBefore = () => keptName === state.question.name ? before : "";

// Return a copy of the cradle on white, and of its texts, which are on a second canvas.
function paperPicture() {
  const { width, height, background } = scene();
  const paper = make("canvas", { width, height });
  const pen = paper.getContext("2d");
  drawOn(vec(1, 1, 1));
  for (const layer of layers()) pen.drawImage(layer, 0, 0);
  drawOn(background);
  return paper;
}

function drawOn(background) {
  scene().background = background;
  drawNow();
}
