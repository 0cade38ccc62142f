// The light on the page: how pale the ghosts are, and the shadows of the bobs on the base.
import { bobs, cylinder, kindOf, objects, scene, textures, vec } from "glow";
import { state } from "page";

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

// What cannot be picked looks transparent: ghosts, and the arrows of a hit, which fade. VPython's
// own transparency would distort the whole picture: it draws it in 640 x 400 pixels, and stretches
// it.
function paintShapes() {
  for (const shape of objects) {
    if (!shape?.visible || shape.pickable !== false) continue;
    const paint = paints.get(shape);
    const ownColor = paint?.pageColor.equals(shape.color) ? paint.ownColor : vec(shape.color);
    const parts = { sphere: GHOSTLY.bob, cylinder: GHOSTLY.cord, arrow: state.view.fade };
    const pageColor = mixed(scene().background, ownColor, parts[kindOf(shape)]);
    paints.set(shape, { ownColor, pageColor });
    if (!pageColor.equals(shape.color)) shape.color = pageColor;
  }
}

const mixed = (one, other, part) => one.multiply(1 - part).add(other.multiply(part));

// Soft shadows: a few discs of darker wood, one upon the other.
function castShadows() {
  const places = bobs();
  while (shadows.length < places.length * LAYERS.length) {
    const [, shade] = LAYERS[shadows.length % LAYERS.length];
    const looks = { color: vec(shade, shade, shade), texture: textures.wood };
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
