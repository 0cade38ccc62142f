// VPython's canvas in this tab: its size, its color, its camera, the numbers above the axles, the mouse and fingers.
window.__context = { glowscript_container: $(".canvas") };
window.Jupyter_VPython = new URL(".", location.href).pathname; // where VPython finds its textures

const scene = () => glowObjs[0];
const bobs = () => glowObjs.filter(o => o?.constructor.name === "sphere" && o.visible && o.shininess); // no ghosts
const FORWARD = [-0.25, -0.18, -1]; // the camera looks a little from the left and from above
const NEAREST = 0.1, FARTHEST = 3; // of the range with which the whole cradle fills the canvas
const MOVED = 1e-3; // the least part of the range, or turn (rad), by which a camera has moved
const MARGIN = 1.04; // the view is larger than the cradle by this factor
const TEXT = 1 / 30, SMALLEST = 0.75, LETTER = 0.55; // of the numbers: height in heights of the canvas, in those of the page's text, width in heights
const INK = [0.5, 0.5, 0.53]; // of the numbers, on a pale and on a dark page
const FINGER = 1.5; // a finger within this many radii of a bob's centre is on the bob, as in dragging.py
let home = null, fitted, labels = []; // home: the center and the range for the points in fitted, the whole cradle
const dark = matchMedia("(prefers-color-scheme: dark)");

// Firefox's driver may remove an attribute that a shader does not use (opacity). VPython then passes undefined as its
// number. WebGL reads undefined as 0, the number of the position, and draws nothing.
const gl = canDraw ? WebGL2RenderingContext.prototype : {};
for (const name of ["enableVertexAttribArray", "vertexAttribPointer"]) {
  const call = gl[name];
  gl[name] = function (attribute, ...others) {
    if (attribute !== undefined) call.call(this, attribute, ...others);
  };
}

shows.view = ({ points }) => { // the first one comes with the canvas
  if (!canDraw) return;
  if (!home) begin();
  if (fitted === JSON.stringify(points)) writeNumbers(); // the camera stays as you turned it
  else fit();
  fitted = JSON.stringify(points);
};

function begin() {
  const { mouse } = scene(), update = mouse.__update;
  // The canvas has the display's own pixels; VPython takes the mouse's, which are those of the page.
  mouse.__update = function (event) {
    const { left, top } = $(scene().__canvas_element).offset(), { pageX, pageY } = event;
    update.call(this, { ...event, type: event.type, pageX: left + (pageX - left) * devicePixelRatio, pageY: top + (pageY - top) * devicePixelRatio });
  };
  scene().forward = vec(...history.state ?? FORWARD);
  history.replaceState(null, "");
  scene().bind("mousedown", event => tell("grab", ...ray(event)));
  scene().bind("mousemove", event => tell("drag", ...ray(event)));
  scene().bind("mouseup", () => tell("let go"));
  // The first picture waits for the bobs and their textures: one without them would only delay it.
  scene().waitfor_textures = true;
  scene().bind("textures", () => scene().waitfor_textures = !scene().objects.length);
  scene().bind("draw_complete", keepPicture);
  scene().__canvas_element.addEventListener("webglcontextlost", stopDrawing);
  scene().__canvas_element.addEventListener("webglcontextrestored", loadAgain);
  dark.addEventListener("change", paint);
  paint();
  resize();
  setInterval(describe, 1000);
  requestAnimationFrame(watch);
}

// The driver was restarted, or the machine slept: all that the graphics card had is gone. VPython cannot send it again.
function stopDrawing(event) {
  event.preventDefault(); // or the browser would not restore it
  scene().visible = false; // or VPython would show alerts
  one(".lost").hidden = false;
}

function loadAgain() { // as soon as the program can be reached; the camera then looks in the same direction
  history.replaceState(parts(scene().forward), "");
  setInterval(() => isOpen() && location.reload(), 100);
}

function watch() { // before each picture: no event tells of all that changes the pixels of the canvas
  resize();
  limit();
  requestAnimationFrame(watch);
}

const parts = ({ x, y, z }) => [x, y, z];
const ray = ({ pos }) => [pos, scene().mouse.ray].map(parts);

function resize() { // the canvas fills its part of the window, in the pixels of the display
  const { clientWidth, clientHeight } = one(".canvas");
  const [width, height] = [clientWidth, clientHeight].map(size => Math.round(size * devicePixelRatio));
  if (!width || !height || width === scene().width && height === scene().height) return;
  Object.assign(scene(), { width, height });
  fit();
}

function paint() { // the canvas has the color of the page
  const { r, g, b } = $.color.parse(css("--back"));
  scene().background = vec(r, g, b).divide(255);
}

// Point the camera at the middle of the view's points, just far enough away to show them all in the canvas.
// The shorter side of the canvas shows 2 range (m) of the plane through the center. The camera is at the distance
// d = range / tan(fov / 2). A point at the distance x from the axis of view, and z nearer to the camera than the center,
// appears in that plane at x d / (d - z). So range * side / shorter side must be at least x d / (d - z).
function fit() {
  const { width, height, fov, up } = scene(), forward = scene().forward.norm();
  const sideways = forward.cross(up).norm(), upwards = sideways.cross(forward);
  const points = state.view.points.map(point => vec(...point)), shorter = Math.min(width, height);
  let center = vec(0, 0, 0), range = 0;
  for (const direction of [forward, sideways, upwards]) {
    const places = points.map(point => point.dot(direction));
    center = center.add(direction.multiply((Math.min(...places) + Math.max(...places)) / 2));
  }
  for (const arm of points.map(point => point.sub(center)))
    for (const [direction, side] of [[sideways, width], [upwards, height]])
      range = Math.max(range, Math.abs(arm.dot(direction)) * shorter / side - arm.dot(forward) * Math.tan(fov / 2));
  home = { center, range: MARGIN * range };
  Object.assign(scene(), home);
  writeNumbers();
}

function resetView() {
  Object.assign(scene(), { forward: vec(...FORWARD), up: vec(0, 1, 0) });
  fit();
}
one(".view").addEventListener("click", resetView);

function limit() { // the camera never looks at the base from below, stays upright, and comes back if it sees nothing
  const { forward, up, center, range } = scene(), away = center.sub(home.center);
  if (forward.y > 0) scene().forward = vec(forward.x, 0, forward.z);
  if (up.y !== 1) scene().up = vec(0, 1, 0);
  const near = Math.min(Math.max(range, NEAREST * home.range), FARTHEST * home.range);
  if (near !== range) scene().range = near;
  if (away.mag > 1.001 * home.range) scene().center = home.center.add(away.norm().multiply(home.range));
  const turned = forward.norm().sub(vec(...FORWARD).norm()).mag > MOVED;
  one(".view").hidden = !turned && Math.max(Math.abs(near - home.range), away.mag) <= MOVED * home.range;
}

// Write the numbers of the pendula, and their masses if these differ, above as many axles as they fit.
function writeNumbers() {
  const { numbers, words, top } = state.view, { width, height, range } = scene();
  const ofPage = parseFloat(getComputedStyle(document.documentElement).fontSize) * devicePixelRatio;
  const size = Math.max(SMALLEST * ofPage, TEXT * height);
  const longest = Math.max(...numbers.flatMap(([, text]) => text.split("\n")).map(line => line.length));
  const apart = (numbers.at(-1)[0] - numbers[0][0]) / Math.max(1, numbers.length - 1);
  const widest = LETTER * size * (0.4 + longest) * 2 * range / Math.min(width, height); // m, with a gap
  const step = [1, 5, 10, 50].find(step => step * apart >= widest) ?? Infinity;
  const texts = numbers.filter((_, i) => i === 0 || (i + 1) % step === 0).map(([x, text]) => [x, top, text, size]);
  if (numbers[0][1].includes("\n")) texts.push([numbers[0][0] - Math.max(widest, apart), top, " \nkg", size]);
  texts.push(...words.map(([x, y, text]) => [x, y, text, 0.875 * ofPage]));
  for (const label of labels) label.visible = false;
  labels = texts.map(([x, y, text, height], i) => {
    const mark = labels[i] ?? label({ canvas: scene(), box: false, line: false, opacity: 0, color: vec(...INK) });
    return Object.assign(mark, { pos: vec(x, y, 0), text, height, yoffset: y === top ? 1 : 0, visible: true });
  }).concat(labels.slice(texts.length));
}

function isOnBob(x, y) {
  const mouse = scene().mouse;
  mouse.__update({ pageX: x, pageY: y });
  return bobs().some(bob => bob.pos.sub(mouse.pos).cross(mouse.ray).mag < FINGER * bob.radius);
}

const isCanvas = event => home && event.target.tagName === "CANVAS" && event.target.closest(".canvas");

// A bob that you grab on the canvas also follows the mouse outside it, and you can let it go there.
addEventListener("pointerdown", event => {
  if (isCanvas(event) && event.pointerType === "mouse") event.target.setPointerCapture(event.pointerId);
}, true);
addEventListener("pointermove", event => {
  if (!isCanvas(event) || event.pointerType !== "mouse") return;
  const held = event.buttons === 1;
  if (!held || event.target.style.cursor !== "grabbing")
    event.target.style.cursor = !isOnBob(event.pageX, event.pageY) ? "" : held ? "grabbing" : "grab";
}, true);

// VPython does not hear of each end of a drag: not of one with two buttons, nor of one that the system ends.
for (const type of ["pointerup", "pointercancel"]) addEventListener(type, () => tell("let go"), true);

// One finger on a bob drags it at once: VPython would wait whether the finger turns the camera.
addEventListener("touchstart", event => {
  if (!isCanvas(event) || event.touches.length > 1) return;
  const [finger] = event.touches, onBob = isOnBob(finger.clientX, finger.clientY);
  Object.assign(scene(), { userspin: !onBob, userzoom: !onBob });
}, { capture: true, passive: true });
for (const type of ["touchend", "touchcancel"])
  addEventListener(type, event => {
    if (home && !event.touches.length) setTimeout(() => Object.assign(scene(), { userspin: true, userzoom: true }));
  }, { passive: true });

function describe() { // the canvas, in words; at most once a second, or a screen reader would never end
  const count = bobs().length, { t, energy } = state.motion;
  const words = `${document.title} with ${count} ${count === 1 ? "bob" : "bobs"}: t ${t}, energy ${energy}`;
  if (one(".canvas").ariaLabel !== words) one(".canvas").ariaLabel = words;
}

// On paper: the cradle as it is now; on the sheet of an experiment, as it was before its release. The picture is a canvas,
// because a browser that hides the pixels of canvases would make stripes of an image.
let asked, before = "";
function keepPicture() {
  const question = state.question?.asking && state.question.question;
  if (question && question !== asked && bobs().every(bob => bob.ready)) [asked, before] = [question, picture()];
}
addEventListener("beforeprint", () => {
  if (home) one(".picture").replaceChildren(state.question ? before : picture());
});

function picture() { // a copy of the cradle on white, and of the numbers on the axles, which are on a second canvas
  const { __canvas_element: cradle, __overlay_element: texts, width, height, background } = scene();
  const paper = make("canvas", { width, height });
  drawOn(vec(1, 1, 1));
  for (const layer of [cradle, texts]) paper.getContext("2d").drawImage(layer, 0, 0); // at once: the canvas forgets
  drawOn(background);
  return paper;
}

function drawOn(background) {
  scene().background = background;
  scene().__renderer.render(0); // VPython's number for a picture
}
