// VPython in this page: all that the page uses of it is here, under names of its own.
// VPython's scripts are classic ones, with globals: jquery.min.js; glow.min.js, which has flot for
// the graph; and vpython.js, a part of VPython's own page (web_files.py). They run before each
// module, and take what is set here when the program makes the canvas.
const vpython = /** @type {any} */ (window);
const { $, decode, handler } = vpython;

// Where the canvas goes; without it, there is no canvas.
vpython.__context = { glowscript_container: $(".canvas") };
// What stands before the name of a texture; without it, textures come from another site.
vpython.Jupyter_VPython = "";
// It is jQuery UI's, and glow.min.js calls it; the canvas here follows the window.
$.fn.resizable = () => {};

export const { vec, label, textures, glowObjs: objects } = vpython;
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
export const isShape = object => object?.pickable !== undefined; // else a canvas, or a light
// No ghosts: these cannot be picked.
export const bobs = () => objects.filter(o => kindOf(o) === "sphere" && o.visible && o.pickable);
export const coordinates = ({ x, y, z }) => [x, y, z];

// Do what the program says to its objects; decode and handler are those of VPython's own page.
export const draw = drawing => handler(decode(drawing));

// Draw a graph (flot).
export const plot = (...how) => $.plot(...how);

// Return the parts of a CSS color, from 0 to 255 (flot, too).
export const rgb = color => $.color.parse(color);

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

// Let VPython take its textures from what this function makes, in place of images.
export function takeImagesFrom(make) {
  vpython.Image = function () {
    return make();
  };
}
