// The cradle on paper, as it is now: a copy of its canvas. A browser that hides the pixels of
// canvases would make stripes of an image.
import { drawNow, layers, scene, vec } from "glow";
import { drawGraph } from "graph";
import { make, one } from "page";

addEventListener("beforeprint", () => {
  if (scene()) one(".picture").replaceChildren(paperPicture());
  document.documentElement.classList.add("on-paper");
  one(".plot").replaceChildren(); // Chromium prints nothing of what flot draws on old canvases
  drawGraph();
});
addEventListener("afterprint", () => {
  document.documentElement.classList.remove("on-paper");
  requestAnimationFrame(drawGraph); // the page is not yet as wide as it was
});

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
