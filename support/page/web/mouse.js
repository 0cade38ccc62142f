// The mouse and fingers on the canvas: they drag a bob, or turn the camera.
import { bobs, mouseAt, scene, useDisplaysPixels } from "glow";
import { state } from "page";
import { send } from "program";

let isDown = false; // whether a button, or a finger, is down on the canvas

export function listen() {
  useDisplaysPixels();
  const ray = ({ pos }) => [pos, scene().mouse.ray].map(({ x, y, z }) => [x, y, z]);
  scene().bind("mousedown", event => {
    isDown = true;
    send("grab", ...ray(event));
  });
  scene().bind("mousemove", event => isDown && send("drag", ...ray(event)));
}

const isCanvas = target => target.matches?.(".canvas canvas"); // a document has no matches

function isOnBob(event) { // as bob_at in dragging.py finds it
  if (document.documentElement.matches(".playing-film, .following")) return false; // nobody drags there
  const { pos, ray } = mouseAt(event);
  const distance = bob => bob.pos.sub(pos).cross(ray).mag;
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
for (const type of ["pointerup", "pointercancel"])
  addEventListener(type, () => {
    if (isDown) send("let_go");
    isDown = false;
  }, true);

// One finger on a bob drags it at once: VPython would wait whether the finger turns the camera.
const letTurn = isOn => Object.assign(scene(), { userspin: isOn, userzoom: isOn });
addEventListener("touchstart", ({ target, touches }) => {
  if (isCanvas(target) && touches.length === 1) letTurn(!isOnBob(touches[0]));
}, { capture: true, passive: true });
for (const type of ["touchend", "touchcancel"])
  addEventListener(type, ({ touches }) => {
    if (scene() && !touches.length) setTimeout(letTurn, 0, true);
  }, { passive: true });
