// The fold "Save and compare": a file with ghosts goes to the program, which refuses a large one.
one("#ghosts").addEventListener("change", async ({ target }) => {
  const [file] = target.files;
  send("ghosts", file.name, await file.slice(0, 1e7 + 1).text());
  target.value = ""; // so that you can choose the same file again
});
