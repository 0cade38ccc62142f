// Present: the cradle in full screen, for a class.
import { find } from "page";

export function present() {
  const root = document.documentElement;
  const isPresenting = root.classList.toggle("presenting");
  if (isPresenting) root.requestFullscreen?.().catch(() => {});
  else if (document.fullscreenElement) document.exitFullscreen();
}
for (const button of find("button.present")) button.addEventListener("click", present);
addEventListener("fullscreenchange", () => {
  document.documentElement.classList.toggle("presenting", !!document.fullscreenElement);
});
