// VPython's canvas in this tab: its size, its color, its name, and the loss of the graphics driver.
// It has a camera (camera.js), it can be touched (mouse.js), and printed (paper.js).
window.__context = { glowscript_container: $(".canvas") };
window.Jupyter_VPython = ""; // before the names of textures: they are next to the page

const dark = matchMedia("(prefers-color-scheme: dark)");
const scene = () => glowObjs[0];
const isSphere = o => o?.constructor.name === "sphere";
const bobs = () => glowObjs.filter(o => isSphere(o) && o.visible && o.pickable); // a ghost is not

// Firefox's driver may remove an attribute that a shader does not use (opacity). VPython then
// passes undefined as its number. WebGL reads undefined as 0, the number of the position, and draws
// nothing.
const gl = canDraw ? WebGL2RenderingContext.prototype : {};
for (const name of ["enableVertexAttribArray", "vertexAttribPointer"]) {
  const call = gl[name];
  gl[name] = function (attribute, ...others) {
    if (attribute !== undefined) call.call(this, attribute, ...others);
  };
}

shows.view = view => { // the first one comes with the canvas
  if (!canDraw) return;
  if (!home) begin();
  follow(view.points);
};

function begin() {
  const element = scene().__canvas_element;
  scene().forward = vec(...history.state?.forward ?? FORWARD);
  remember({ forward: null });
  listen();
  // The first picture waits for the bobs and their textures: one without them would only delay it.
  scene().waitfor_textures = true;
  scene().bind("textures", () => scene().waitfor_textures = !scene().objects.length);
  scene().bind("draw_complete", keepPicture);
  scene().bind("draw_complete", endPicture);
  element.addEventListener("webglcontextlost", stopDrawing);
  element.addEventListener("webglcontextrestored", loadAgain);
  dark.addEventListener("change", paint);
  paint();
  resize();
  setInterval(describe, 1000);
  requestAnimationFrame(watch);
}

// Before each picture: no event tells of all that changes the pixels of the canvas.
function watch() {
  resize();
  limit();
  requestAnimationFrame(watch);
}

function resize() { // the canvas fills its part of the window, in the pixels of the display
  const { clientWidth, clientHeight } = one(".canvas");
  const width = Math.round(clientWidth * devicePixelRatio);
  const height = Math.round(clientHeight * devicePixelRatio);
  const isSame = width === scene().width && height === scene().height;
  if (!width || !height || isSame) return;
  Object.assign(scene(), { width, height });
  fit();
}

function paint() { // the canvas has the color of the page
  const { r, g, b } = $.color.parse(css("--back"));
  scene().background = vec(r, g, b).divide(255);
  shine();
  paintShapes();
}

// The canvas, in words; at most once a second, or a screen reader would never end.
function describe() {
  one(".canvas").ariaLabel = `${document.title}: ${state.summary}`;
}

// A new element: a screen reader also says a sentence again.
function tell() {
  one(".summary").replaceChildren(make("span", {}, state.summary));
}

// The driver was restarted, or the machine slept: all that the graphics card had is gone.
// VPython cannot send it again.
function stopDrawing(event) {
  event.preventDefault(); // or the browser would not restore it
  scene().visible = false; // or VPython would show alerts
  one(".lost").hidden = false;
}

// As soon as the program can be reached; the camera then looks in the same direction.
function loadAgain() {
  remember({ forward: coordinates(scene().forward) });
  setInterval(() => isOpen() && location.reload(), 100);
}
