// The camera of this tab: it shows the whole cradle, and does not lose it when you turn and zoom.
import { scene, vec } from "glow";
import { one, state } from "page";

const FORWARD = [0, -0.2, -1]; // the camera looks a little from above
const MARGIN = 1.04; // the view is larger than the cradle by this factor
const NEAREST = 0.1; // of the range with which the whole cradle fills the canvas
const FARTHEST = 3;
const MOVED = 1e-3; // the least part of the range, or turn (rad), by which a camera has moved

let home; // the range (m) with which the whole cradle fills the canvas
let fitted; // the points for which it does

export function follow(points) {
  if (fitted === String(points)) return; // the camera stays as you turned it
  fitted = String(points);
  fit();
}

// Point the camera at the view's center, just far enough away to show all its points.
// The shorter side of the canvas shows 2 range (m) of the plane through the center. The camera is
// at the distance d = range / tan(fov / 2). A point at the distance x from the axis of view, and z
// nearer to the camera than the center, appears in that plane at x d / (d - z). So range * side /
// shorter side must be at least x d / (d - z).
export function fit() {
  const { width, height, fov, up } = scene();
  const forward = scene().forward.norm();
  const sideways = forward.cross(up).norm();
  const upwards = sideways.cross(forward);
  const center = vec(...state.view.center);
  const shorter = Math.min(width, height);
  let range = 0;
  for (const point of state.view.points) {
    const arm = vec(...point).sub(center);
    const x = Math.abs(arm.dot(sideways)) * shorter / width;
    const y = Math.abs(arm.dot(upwards)) * shorter / height;
    range = Math.max(range, Math.max(x, y) - arm.dot(forward) * Math.tan(fov / 2));
  }
  home = MARGIN * range;
  Object.assign(scene(), { center, range: home });
}

export function resetView() {
  scene().forward = vec(...FORWARD);
  fit();
}
one(".view").onclick = resetView;

// The camera never looks at the base from below, stays upright, and is neither too near nor too far.
export function limit() {
  const { forward, up, range } = scene();
  const allowed = Math.min(Math.max(range, NEAREST * home), FARTHEST * home);
  if (forward.y > 0) scene().forward = vec(forward.x, 0, forward.z);
  if (up.y !== 1) scene().up = vec(0, 1, 0);
  if (allowed !== range) scene().range = allowed;
  const turn = forward.diff_angle(vec(...FORWARD));
  one(".view").hidden = turn <= MOVED && Math.abs(allowed - home) <= MOVED * home;
}
