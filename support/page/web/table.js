// The fold "The bobs": pend_list as a table, live, with numbers that you can change, and its CSV.
import { save } from "keep";
import { make, one, show, state } from "page";
import { send } from "program";

const table = one(".pendula");
let ticket; // of the CSV that this page has asked for

show("columns", columns => {
  const titles = columns.map(([title]) => make("th", { scope: "col" }, title));
  const rows = state.cells[0].map((_, row) => {
    const name = make("th", { scope: "row" }, `pend_list[${row}]`);
    const fields = columns.map(([title, limits]) => limits ? makeField(row, title, limits) : "");
    return make("tr", {}, name, ...fields.map(field => make("td", {}, field)));
  });
  table.replaceChildren(make("tr", {}, make("td"), ...titles), ...rows);
  fill();
});
show("cells", fill);

function fill() {
  state.cells.forEach((texts, column) => texts.forEach((text, row) => {
    const cell = table.rows[row + 1].cells[column + 1];
    const [field] = cell.children;
    if (!field) cell.textContent = text;
    else if (field !== document.activeElement) {
      field.value = text;
      field.setCustomValidity("");
    }
  }));
}

function makeField(row, column, [least, most]) {
  const ariaLabel = `${column} of pend_list[${row}]`;
  const field = make("input", { type: "text", inputMode: "decimal", ariaLabel });
  field.onchange = () => {
    const number = Number(field.value.replace(",", ".") || NaN);
    const isAllowed = number >= least && number <= most;
    field.setCustomValidity(isAllowed ? "" : `Type a number from ${least} to ${most}.`);
    if (field.reportValidity()) send("edit", row, column, number);
  };
  return field;
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
