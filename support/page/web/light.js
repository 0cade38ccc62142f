// The light on the page: how pale the shades are, how bobs stand out from the page, and their
// shadows on the base.
import { dark } from "colors";
import { bobs, cylinder, isSphere, kindOf, objects, scene, textures, vec } from "glow";
import { state } from "page";

// On a pale page, the edges of bobs must be dark, on a dark page light; their middle is bright.
const PALE = { ambient: 0.26, lamps: [0.9, 0.2] };
const DARK = { ambient: 0.62, lamps: [0.55, 0.2] };
const DARKEST = 0.54; // a bob with less light than this is lightened on a dark page
// Of a shadow: the radius of each layer, in radii of the bob, and its shade.
const LAYERS = [[1.3, 0.9], [1.1, 0.8], [0.9, 0.68], [0.7, 0.58]];
const LAYER = 1e-4; // m: the height of a layer
const GHOSTLY = { bob: 0.4, cord: 0.7 }; // how much a ghost differs from the page

const paints = new WeakMap(); // of a shape: its color in the program, and that on the page
const shadows = [];

// With each message: in the same picture as the bobs.
export function light() {
  paintShapes();
  if (shadows.length) castShadows();
}

// The first picture has no shadows: so it comes sooner.
export function endPicture() {
  if (!shadows.length) castShadows();
}

export function shine() {
  const { ambient, lamps } = dark.matches ? DARK : PALE;
  scene().ambient = grey(ambient);
  lamps.forEach((brightness, i) => scene().lights[i].color = grey(brightness));
}

// Bobs get a color that can be seen on the page. What cannot be picked looks transparent: ghosts,
// and the arrows of a hit, which fade. VPython's own transparency would distort the whole picture:
// it draws it in 640 x 400 pixels, and stretches it.
export function paintShapes() {
  for (const shape of objects) {
    if (!shape?.visible || !(isSphere(shape) || shape.pickable === false)) continue;
    const paint = paints.get(shape);
    const ownColor = paint?.pageColor.equals(shape.color) ? paint.ownColor : vec(shape.color);
    const pageColor = onPage(shape, ownColor);
    paints.set(shape, { ownColor, pageColor });
    if (!pageColor.equals(shape.color)) shape.color = pageColor;
  }
}

function onPage(shape, color) {
  const parts = { sphere: GHOSTLY.bob, cylinder: GHOSTLY.cord, arrow: state.view.fade };
  if (shape.pickable === false) return mixed(scene().background, color, parts[kindOf(shape)]);
  const missing = Math.max(0, DARKEST - luma(color));
  return dark.matches ? mixed(color, grey(1), missing) : color;
}

const mixed = (one, other, part) => one.multiply(1 - part).add(other.multiply(part));
const grey = part => vec(part, part, part);
const luma = ({ x, y, z }) => 0.3 * x + 0.59 * y + 0.11 * z;

// Soft shadows: a few discs of darker wood, one upon the other.
function castShadows() {
  const places = bobs();
  while (shadows.length < places.length * LAYERS.length) {
    const [, shade] = LAYERS[shadows.length % LAYERS.length];
    const looks = { color: grey(shade), texture: textures.wood };
    shadows.push(cylinder({ canvas: scene(), pickable: false, ...looks }));
  }
  shadows.forEach((shadow, i) => {
    const bob = places[Math.floor(i / LAYERS.length)];
    const { left, right, height } = state.view.base;
    shadow.visible = !!bob && left < bob.pos.x && bob.pos.x < right;
    if (!bob) return;
    const layer = i % LAYERS.length;
    shadow.radius = LAYERS[layer][0] * bob.radius;
    shadow.pos = vec(bob.pos.x, height, 0);
    shadow.axis = vec(0, LAYER * (1 + layer), 0);
  });
}
