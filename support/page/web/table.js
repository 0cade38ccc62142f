// The fold "The bobs": pend_list as a table, live, with numbers that you can change, and its CSV.
import { save } from "keep";
import { make, one, show, state } from "page";
import { send } from "program";

const table = one(".pendula");
let shape;
let ticket; // of the CSV that this page has asked for

show("table", columns => {
  const newShape = String(columns.map(({ title, limits, texts }) => [title, limits, texts.length]));
  if (shape !== newShape) build(columns);
  shape = newShape;
  columns.forEach(({ texts }, column) => texts.forEach((text, row) => {
    const cell = table.rows[row + 1].cells[column + 1];
    const [field] = cell.children;
    if (!field) cell.textContent = text;
    else if (field !== document.activeElement) fill(field, text);
  }));
});

function build(columns) {
  const titles = columns.map(({ title }) => make("th", { scope: "col" }, title));
  const rows = columns[0].texts.map((_, row) => {
    const name = make("th", { scope: "row" }, `pend_list[${row}]`);
    const fields = columns.map(({ title, limits }) => limits ? makeField(row, title, limits) : "");
    return make("tr", {}, name, ...fields.map(field => make("td", {}, field)));
  });
  table.replaceChildren(make("tr", {}, make("td"), ...titles), ...rows);
}

function makeField(row, column, [least, most]) {
  const ariaLabel = `${column} of pend_list[${row}]`;
  const field = make("input", { type: "text", inputMode: "decimal", size: 6, ariaLabel });
  field.addEventListener("change", () => {
    const number = Number(field.value.replace(",", ".") || NaN);
    const isAllowed = number >= least && number <= most;
    field.setCustomValidity(isAllowed ? "" : `Type a number from ${least} to ${most}.`);
    if (field.reportValidity()) send("edit", row, column, number);
  });
  return field;
}

function fill(field, text) {
  field.value = text;
  field.setCustomValidity("");
}

one(".save-csv").onclick = () => {
  ticket = Math.random();
  send("save_csv", ticket);
};
show("saved_csv", csv => {
  if (csv.ticket !== ticket) return;
  one(".unsaved-csv").textContent = csv.mistake;
  if (csv.text) save(`${state.controls.experiment.value}.csv`, new Blob([csv.text]));
});
show("unknown", unknown => one(".save-csv").disabled = !!unknown);
