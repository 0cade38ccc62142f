// The mouse and fingers on the canvas: they drag a bob, or turn the camera.
const coordinates = ({ x, y, z }) => [x, y, z];

function listen() {
  const { mouse } = scene();
  const update = mouse.__update;
  // The canvas has the display's own pixels. VPython takes the mouse's, which are the page's.
  mouse.__update = function (event) {
    const { left, top } = $(scene().__canvas_element).offset();
    const pageX = left + (event.pageX - left) * devicePixelRatio;
    const pageY = top + (event.pageY - top) * devicePixelRatio;
    update.call(this, { ...event, type: event.type, pageX, pageY });
  };
  const ray = ({ pos }) => [pos, mouse.ray].map(coordinates);
  scene().bind("mousedown", event => send("grab", ...ray(event)));
  scene().bind("mousemove", event => send("drag", ...ray(event)));
  scene().bind("mouseup", letGo);
}
const letGo = () => send("let_go");

const isCanvas = target => home && target.matches(".canvas canvas");

function isOnBob({ pageX, pageY }) { // as bob_at in dragging.py finds it
  const { mouse } = scene();
  mouse.__update({ pageX, pageY });
  const distance = bob => bob.pos.sub(mouse.pos).cross(mouse.ray).mag;
  return bobs().some(bob => distance(bob) < state.view.finger * bob.radius);
}

// A bob that you grab on the canvas also follows the mouse outside it, and you can let it go there.
addEventListener("pointerdown", ({ target, pointerType, pointerId }) => {
  if (pointerType === "mouse" && isCanvas(target)) target.setPointerCapture(pointerId);
}, true);
addEventListener("pointermove", event => {
  const { target, pointerType, buttons } = event;
  if (pointerType !== "mouse" || !isCanvas(target)) return;
  const cursor = buttons === 1 ? "grabbing" : "grab";
  if (cursor === "grabbing" && target.style.cursor === cursor) return; // the bob comes after it
  target.style.cursor = isOnBob(event) ? cursor : "";
}, true);

// VPython does not hear of each end of a drag: not of one with two buttons, nor of one that the
// system ends.
for (const type of ["pointerup", "pointercancel"]) addEventListener(type, letGo, true);

// One finger on a bob drags it at once: VPython would wait whether the finger turns the camera.
const letTurn = isOn => Object.assign(scene(), { userspin: isOn, userzoom: isOn });
addEventListener("touchstart", ({ target, touches }) => {
  if (isCanvas(target) && touches.length === 1) letTurn(!isOnBob(touches[0]));
}, { capture: true, passive: true });
for (const type of ["touchend", "touchcancel"])
  addEventListener(type, ({ touches }) => {
    if (home && !touches.length) setTimeout(letTurn, 0, true);
  }, { passive: true });
