// The ghosts of all answers are in each picture; the page shows those of yours, or of a file (null).
// They look transparent. VPython's own transparency would distort the whole picture: it draws it in
// 640 x 400 pixels, and stretches it.
import { colorOf } from "colors";
import { kindOf, objects } from "glow";
import { state } from "page";

const PART = 0.45; // of its color that a ghost, or its thread, has; the rest is the page's

export const isShown = answer => answer === null || answer === state.question?.replies.asked;

export function showGhosts() {
  for (const kind of ["sphere", "cylinder"]) { // a ghost, and its thread
    const shapes = objects.filter(shape => shape?.pickable === false && kindOf(shape) === kind);
    state.view.ghosts.forEach((answer, i) => show(shapes[i], isShown(answer)));
  }
}

function show(shape, isVisible) {
  if (shape.visible !== isVisible) shape.visible = isVisible; // VPython draws all again
  if (shape.paleColor?.equals(shape.color)) return; // else it is a new one of the program's
  shape.paleColor = colorOf("--paper").multiply(1 - PART).add(shape.color.multiply(PART));
  shape.color = shape.paleColor;
}
