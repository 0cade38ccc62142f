// The shadows of the bobs: the page paints them on the board upon the base. VPython has none.
import { bobs, imageOf, kindOf, objects, paint, textures } from "glow";
import { make } from "page";

// A bob that is higher has a wider and paler shadow.
const DARK = 1.2; // that of a bob whose middle is one radius above the board; the most is 1
const WIDE = 1.25; // the radius of a shadow, for the radius of its bob and its height
const ASIDE = 0.15; // how far it is on the right, in heights: the light is on the left

// On what becomes the board.
const pen = make("canvas", { width: 512, height: 64 }).getContext("2d", { willReadFrequently: true });
const soft = pen.createRadialGradient(0, 0, 0, 0, 0, 1); // from the middle to the edge
soft.addColorStop(0, "#000");
soft.addColorStop(0.4, "#0005");
soft.addColorStop(1, "#0000");
pen.fillStyle = soft;

let wood; // an image
let isThere = false;

// The first picture has no shadows: so it comes sooner.
export function endPicture() {
  wood ??= imageOf(textures.wood, () => {
    isThere = true;
    castShadows();
  });
}

// With each message: in the same picture as the bobs.
export function castShadows() {
  if (!isThere) return;
  const { width, height } = pen.canvas;
  const board = objects.find(shape => kindOf(shape) === "box" && !shape.pickable);
  pen.resetTransform();
  pen.globalAlpha = 1;
  pen.drawImage(wood, 0, 0, width, height);
  for (const { pos, radius } of bobs()) {
    const { x, y } = pos.sub(board.pos);
    pen.setTransform(width / board.size.x, 0, 0, height / board.size.z, width / 2, height / 2);
    pen.translate(x + ASIDE * y, 0);
    const wide = WIDE * (radius + y);
    pen.scale(wide, wide);
    pen.globalAlpha = Math.min(1, DARK * radius / y);
    pen.fillRect(-1, -1, 2, 2);
  }
  paint(board, pen.canvas);
}
