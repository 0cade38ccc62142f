// What the page decides of the program's marks: how large their letters are, and whose ghosts you see.
import { kindOf, objects, scene } from "glow";
import { state } from "page";

const TEXT = 1 / 30; // height of letters, in heights of the canvas
const SMALLEST = 0.875; // the same, at least, in heights of the page's text
const LETTER = 0.55; // width of a letter, in heights

export function fitMarks() {
  const { width, height, range } = scene();
  const pageSize = parseFloat(getComputedStyle(document.documentElement).fontSize) * devicePixelRatio;
  const size = Math.max(SMALLEST * pageSize, TEXT * height);
  const pixel = 2 * range / Math.min(width, height); // m
  for (const text of objects.filter(object => kindOf(object) === "label")) {
    const lengths = text.text.split("\n").map(line => line.length);
    const widest = LETTER * (1 + Math.max(...lengths)); // with a gap, in heights
    const room = text.space / pixel || Infinity; // marks.py
    const fitting = Math.min(size, room / widest);
    if (text.height !== fitting) text.height = fitting; // else VPython would draw all texts again
  }
  // Those of all answers are in each picture; null stands for a file.
  for (const [number, answer] of Object.entries(state.view.ghosts))
    objects[number].visible = answer === null || answer === state.question?.replies.asked;
}
