// VPython in this page: all that the page uses of it is here, under names of its own.
// VPython's scripts are classic ones, with globals: jquery.min.js; glow.min.js, which has flot for
// the graph; and vpython.js, a part of VPython's own page (vpython_inside.py). They run before each
// module, and take what is set here when the program makes the canvas.
const vpython = /** @type {any} */ (window);
const { $, decode, handler } = vpython;

// Where the canvas goes; without it, there is no canvas.
vpython.__context = { glowscript_container: $(".canvas") };
// What stands before the name of a texture; without it, textures come from another site.
vpython.Jupyter_VPython = "";
// It is jQuery UI's, and glow.min.js calls it; the canvas here follows the window.
$.fn.resizable = () => {};

export const { vec, textures, glowObjs: objects } = vpython;
export const canDraw = !!document.createElement("canvas").getContext("webgl2");

// Firefox's driver may remove an attribute that a shader does not use (opacity). VPython then
// passes undefined as its number. WebGL reads undefined as 0, the number of the position, and draws
// nothing.
const gl = /** @type {any} */ (canDraw ? WebGL2RenderingContext.prototype : {});
for (const name of ["enableVertexAttribArray", "vertexAttribPointer"]) {
  const call = gl[name];
  gl[name] = function (attribute, ...others) {
    if (attribute !== undefined) call.call(this, attribute, ...others);
  };
}

export const scene = () => objects[0];
export const kindOf = object => object?.constructor.name; // "sphere", "arrow", ...
// Else a canvas, or a light
export const isShape = object => object?.pickable !== undefined || kindOf(object) === "label";
// No ghosts: these cannot be picked.
export const bobs = () => objects.filter(o => kindOf(o) === "sphere" && o.visible && o.pickable);

// Make and change objects as a message says, or a picture of a film (changes.py); decode and handler
// are those of VPython's own page.
export function draw(drawing) {
  const attrs = [];
  const cmds = [];
  for (const [key, change] of Object.entries(drawing)) {
    if (typeof change === "string") attrs.push(change);
    else cmds.push(...asCmds(key, change));
  }
  handler(decode({ attrs, cmds }));
}

const FIXED = ["canvas", "texture"]; // of a shape: they never change
const canvasHas = {}; // the last values of its attributes: to set its lights again would remove them

// An object that is there already gets the values with which it was made: after a cut, or when a film
// goes back.
function asCmds(key, { cmd, idx, ...values }) {
  const object = objects[idx];
  if (cmd && !object) return [{ cmd, idx, ...values }]; // VPython's handler changes what it gets
  if (cmd && !isShape(object)) return [];
  if (cmd) {
    const names = Object.keys(values).filter(name => !FIXED.includes(name));
    return [{ idx, visible: true }, ...names.map(name => ({ idx, [name]: values[name] }))];
  }
  const text = JSON.stringify(values);
  if (idx === 0 && canvasHas[key] === text) return [];
  canvasHas[key] = text;
  return [{ idx, ...values }];
}

// What was made later must not be seen in a film that goes back.
export function hideAll() {
  for (const shape of objects.filter(isShape)) shape.visible = false;
}

// Draw a graph (flot).
export const plot = (...how) => $.plot(...how);

export const canvasElement = () => scene().__canvas_element;

// Let the page be seen behind the picture.
export const clearBackground = () => scene().__opacity = 0;

// Return the image of a texture; then do something as soon as it is there.
export function imageOf(texture, onload) {
  return Object.assign(new vpython.Image(), { src: texture.slice(1), onload });
}

// Let a shape with a texture have what is on this canvas as its own one.
export function paint(shape, canvas) {
  const context = canvasElement().getContext("webgl2");
  shape.ownTexture ??= context.createTexture();
  shape.__tex.texture_ref.reference = shape.ownTexture;
  context.bindTexture(context.TEXTURE_2D, shape.ownTexture);
  context.texImage2D(context.TEXTURE_2D, 0, context.RGBA, context.RGBA, context.UNSIGNED_BYTE, canvas);
  context.texParameteri(context.TEXTURE_2D, context.TEXTURE_MIN_FILTER, context.LINEAR);
}

// The canvas has the display's own pixels. VPython takes the mouse's, which are the page's: on a
// display with twice as many, it would look for the mouse in another place.
export function useDisplaysPixels() {
  const { mouse } = scene();
  const update = mouse.__update;
  mouse.__update = function (event) {
    const { left, top } = $(canvasElement()).offset();
    const pageX = left + (event.pageX - left) * devicePixelRatio;
    const pageY = top + (event.pageY - top) * devicePixelRatio;
    update.call(this, { ...event, type: event.type, pageX, pageY });
  };
}

// Return VPython's mouse as it is where this event, or this finger, was.
export function mouseAt({ pageX, pageY }) {
  const { mouse } = scene();
  mouse.__update({ pageX, pageY });
  return mouse;
}

// Let VPython take its textures from what this function returns, in place of images.
export function takeImagesFrom(make) {
  vpython.Image = make;
}
