// Present: the page in full screen, with larger letters, for a class.
import { one } from "page";

const root = document.documentElement;

export function present() {
  const isOn = !root.matches(".presenting");
  setPresenting(isOn);
  if (isOn) root.requestFullscreen?.().catch(() => {}); // a frame may refuse it
  else if (document.fullscreenElement) document.exitFullscreen();
}

function setPresenting(isOn) {
  root.classList.toggle("presenting", isOn);
  one(".present").ariaPressed = `${isOn}`;
}

one(".present").onclick = present;
addEventListener("fullscreenchange", () => setPresenting(!!document.fullscreenElement));
