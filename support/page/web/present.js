// Present: the cradle in full screen, for a class.
import { find, one } from "page";

export function present() {
  const root = document.documentElement;
  const isPresenting = root.classList.toggle("presenting");
  if (isPresenting) root.requestFullscreen?.().catch(() => {});
  else if (document.fullscreenElement) document.exitFullscreen();
}
for (const button of find("button.present")) button.addEventListener("click", present);
one("#graphing").addEventListener("change", ({ target }) => {
  document.documentElement.classList.toggle("graphing", target.checked);
});
addEventListener("fullscreenchange", () => {
  document.documentElement.classList.toggle("presenting", !!document.fullscreenElement);
});
