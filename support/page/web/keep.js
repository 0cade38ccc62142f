// The fold "Save and compare": the setup of the cradle as text or as a file, the run, the numbers
// of the graph, and ghosts.
one(".save-setup").onclick = () => save("my_cradle.txt", asFile(state.setup));
one(".save-graph").onclick = () => {
  const { names, rows } = state.curves;
  save("graph.csv", asFile([names, ...rows].join("\n"))); // a row as text has commas
};
one(".save-run").onclick = () => save(`${state.experiment}.html`, `run.html${location.search}`);

const asFile = text => URL.createObjectURL(new Blob([text]));
const save = (download, href) => make("a", { download, href }).click();

// The program refuses a large file.
one("#ghosts").addEventListener("change", async ({ target }) => {
  const [file] = target.files;
  send("load_ghosts", file.name, await file.slice(0, 1e7 + 1).text());
  target.value = ""; // so that you can choose the same file again
});
