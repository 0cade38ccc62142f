// The table of the pendula: mass and e, which you can change, and the coordinates as they move.
const [head, body] = find(".pendula > *");
let cells = {}, fields = {}, shape; // of the coordinates, by their names; of mass and e, by "row,column"

function build() {
  [cells, fields, shape] = [{}, {}, `${state.mass.length} ${state.keys}`];
  head.replaceChildren(make("tr", {}, ...["row", "mass", "e", ...state.keys].map(name => make("th", { scope: "col" }, name))));
  body.replaceChildren(...state.mass.map((_, row) => make("tr", {},
    make("th", { scope: "row" }, String(row + 1)),
    ...["mass", "e"].map(column => editor(row, column)),
    ...state.keys.map(key => cells[`${key}_${row + 1}`] = make("td", { className: "now" })))));
}

function editor(row, column) {
  const field = make("input", { type: "text", inputMode: "decimal", size: 6, ariaLabel: `${column} of pendulum ${row + 1}` });
  const words = make("div", { className: "failed", role: "alert" });
  field.addEventListener("change", () => {
    tell("edit", row, column, field.value);
    if (!isHeard) field.value = field.defaultValue; // it was not sent
  });
  fields[`${row},${column}`] = { row, column, field, words };
  return make("td", {}, field, words);
}

shows.keys = shows.mass = shows.e = shows.refused = () => {
  if (shape !== `${state.mass.length} ${state.keys}`) build();
  for (const [place, { row, column, field, words }] of Object.entries(fields)) {
    const [text, allowed] = state.refused[place] ?? [String(state[column][row]), ""];
    const isTyped = field === document.activeElement && field.value !== field.defaultValue; // it stays
    if (!isTyped) field.value = field.defaultValue = text;
    field.ariaInvalid = !!allowed;
    words.textContent = allowed;
  }
  shows.now(state.now);
};
shows.now = numbers => {
  if (!one(".fold").open) return;
  for (const name in cells) cells[name].textContent = numbers[name] ?? "";
};
one(".fold").addEventListener("toggle", () => shows.now(state.now));
