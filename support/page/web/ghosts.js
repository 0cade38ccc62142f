// The ghosts of all answers are in each picture; the page shows those of yours, or of a file (null).
import { kindOf, objects } from "glow";
import { state } from "page";

export const isShown = answer => answer === null || answer === state.question?.replies.predicted;

export function showGhosts() {
  const parts = objects.filter(shape => shape?.pickable === false);
  for (const kind of ["sphere", "cylinder"]) { // a ghost, and its thread
    const shapes = parts.filter(shape => kindOf(shape) === kind);
    state.view.ghosts.forEach((answer, i) => {
      if (shapes[i].visible !== isShown(answer)) shapes[i].visible = isShown(answer);
    });
  }
}
