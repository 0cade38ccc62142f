// The fold "Save and compare": the film, and ghosts.
import { make, one, state } from "page";
import { send } from "program";

one(".save-film").onclick = async () => {
  const name = `${state.controls.experiment.value}.html`;
  const answer = await fetch(`film.html${location.search}`).catch(() => null);
  one(".unsaved").hidden = answer?.ok;
  if (answer?.ok) save(name, await answer.blob());
};

export function save(download, content) {
  const href = URL.createObjectURL(content);
  make("a", { download, href }).click();
}

// The program gets the bytes, to say why it refuses them, but no more than of the largest file.
one("#ghosts").onchange = ({ target }) => {
  const [file] = target.files;
  const reader = new FileReader();
  reader.onload = () => send("load_ghosts", file.name, reader.result);
  reader.readAsDataURL(file.slice(0, 6e6 + 1));
  target.value = ""; // so that you can choose the same file again
};
