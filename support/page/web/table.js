// The table of the pendula: mass and e, which you can change, and the coordinates as they move.
import { find, make, one, show, state } from "page";
import { send } from "program";

const [head, body] = find(".pendula > *");
let cells = {}; // of the coordinates, by their names
let editors = {}; // of mass and e, by "row,column"
let shape;

for (const name of /** @type {const} */ (["keys", "table", "refused", "unknown"])) show(name, showTable);
show("now", showNumbers);
one(".programmers").addEventListener("toggle", showNumbers);

function showTable() {
  const newShape = `${state.table.mass.length} ${state.keys}`;
  if (shape !== newShape) build();
  shape = newShape;
  for (const place in editors) showEditor(place, editors[place]);
  showNumbers();
}

function showNumbers() {
  if (!one(".programmers").open) return;
  for (const name in cells) cells[name].textContent = state.now[name] ?? "";
}

function build() {
  cells = {};
  editors = {};
  const names = ["row", ...state.columns, ...state.keys];
  const titles = names.map(name => make("th", { scope: "col" }, name));
  head.replaceChildren(make("tr", {}, ...titles));
  body.replaceChildren(...state.table.mass.map((_, row) => makeRow(row)));
}

function makeRow(row) {
  const line = make("tr", {}, make("th", { scope: "row" }, String(row + 1)));
  for (const column of state.columns) line.append(makeEditor(row, column));
  for (const key of state.keys) {
    const cell = make("td", { className: "now" });
    cells[`${key}_${row + 1}`] = cell;
    line.append(cell);
  }
  return line;
}

function makeEditor(row, column) {
  const ariaLabel = `${column} of pendulum ${row + 1}`;
  const field = make("input", { type: "text", inputMode: "decimal", size: 6, ariaLabel });
  const message = make("div", { className: "failed", role: "alert" });
  field.addEventListener("change", () => {
    const isSent = send("edit", row, column, field.value);
    if (isSent) field.defaultValue = field.value;
    else field.value = field.defaultValue;
  });
  editors[`${row},${column}`] = { row, column, field, message };
  return make("td", {}, field, message);
}

function showEditor(place, { row, column, field, message }) {
  const refusal = state.refused[place];
  const number = state.table[column][row];
  const text = refusal?.text ?? number ?? "?"; // "?" is hidden
  field.disabled = !!state.unknown;
  const isTyped = field === document.activeElement && field.value !== field.defaultValue;
  if (!isTyped) field.value = field.defaultValue = text;
  const isNew = refusal && !message.textContent;
  if (isNew) one(".programmers").open = true; // a slider can be refused, too
  field.ariaInvalid = !!refusal;
  message.textContent = refusal?.message;
}
