// The table of the pendula: mass and e, which you can change, and the coordinates as they move; and one tick in words.
{
  const [head, body] = find(".pendula > *");
  let cells = {}; // of the coordinates, by their names

  function editor(row, column) {
    const [text, words] = state.refused[`${row},${column}`] ?? [state[column][row]];
    const field = make("input", { type: "text", inputMode: "decimal", size: 6, value: text, ariaLabel: `${column} of pendulum ${row + 1}` });
    field.ariaInvalid = !!words;
    field.dataset.place = `${row},${column}`;
    field.addEventListener("change", () => tell("edit", row, column, field.value));
    return make("td", {}, field, ...words ? [make("div", { className: "failed", role: "alert" }, words)] : []);
  }

  function showRows() {
    const last = document.activeElement?.dataset.place;
    head.replaceChildren(make("tr", {}, ...["row", "mass", "e", ...state.keys].map(name => make("th", { scope: "col" }, name))));
    cells = {};
    body.replaceChildren(...state.mass.map((_, row) => make("tr", {},
      make("th", { scope: "row" }, String(row + 1)),
      ...["mass", "e"].map(column => editor(row, column)),
      ...state.keys.map(key => cells[`${key}_${row + 1}`] = make("td", { className: "now" })))));
    shows.now(state.now);
    if (last) body.querySelector(`[data-place="${last}"]`)?.focus(); // the Tab key goes on from there
  }

  shows.keys = shows.mass = shows.e = shows.refused = showRows;
  shows.now = numbers => {
    if (!one(".fold").open) return;
    for (const name in cells) cells[name].textContent = numbers[name] ?? "";
  };
  one(".fold").addEventListener("toggle", () => shows.now(state.now));
}
