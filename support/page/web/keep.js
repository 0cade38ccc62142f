// The fold "Save and compare": the run, and ghosts.
import { make, one, state } from "page";
import { send } from "program";

one(".save-run").onclick = async ({ target }) => {
  const message = one(".unsaved");
  message.textContent = "";
  target.disabled = true;
  try {
    const name = `${state.controls.experiment.value}.html`;
    const answer = await fetch(`run.html${location.search}`);
    if (!answer.ok) throw new Error(`it answers ${answer.status}`);
    save(name, await answer.blob());
  } catch ({ message: why }) {
    message.textContent = `The program did not send the run, so it is not saved (${why}).`;
  }
  target.disabled = false;
};

function save(download, content) {
  const href = URL.createObjectURL(content);
  make("a", { download, href }).click();
  setTimeout(URL.revokeObjectURL, 60_000, href); // the browser has written it by then
}

// The program refuses a large file.
one("#ghosts").addEventListener("change", async ({ target }) => {
  const [file] = target.files;
  send("load_ghosts", file.name, await file.slice(0, 1e7 + 1).text());
  target.value = ""; // so that you can choose the same file again
});
