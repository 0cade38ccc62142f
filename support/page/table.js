// The table of the pendula: table.py sends the rows and the present numbers as data, and gets what you change.
{
  const make = (kind, attributes = {}, ...parts) => {
    const element = Object.assign(document.createElement(kind), attributes);
    element.append(...parts);
    return element;
  };

  // Give the program a command; it travels as the text of VPython's input widget, which is hidden.
  function tell(name, value) {
    const idx = glowObjs.findIndex(o => o?.objName === "winput");
    events.push({ idx, widget: "winput", text: JSON.stringify([name, value]), value: null });
  }

  const body = make("tbody"), table = make("table", { className: "pendula" }, make("thead"), body);
  let cells = {}, now = {}; // of the numbers that move, by their names: the cells, and the texts

  function editor(row, column, text, data) {
    const mistake = data.mistakes[`${row},${column}`];
    const field = make("input", { type: "text", inputMode: "decimal", size: 6 });
    Object.assign(field, { value: mistake?.[0] ?? text, ariaLabel: `${column} of pendulum ${row + 1}`, ariaInvalid: !!mistake });
    field.dataset.place = `${row},${column}`;
    field.addEventListener("change", () => tell("edit", [row, column, field.value]));
    return make("td", {}, field, ...mistake ? [make("div", { className: "failed", role: "alert" }, mistake[1])] : []);
  }

  function showRows(data) {
    const isNew = !table.rows.length;
    const last = document.activeElement?.dataset.place;
    const head = ["", "mass", "e", ...data.keys].map(name => make("th", { scope: "col" }, name));
    table.tHead.replaceChildren(make("tr", {}, ...head));
    cells = {};
    body.replaceChildren(...data.rows.map((pendulum, row) => make("tr", {},
      make("th", { scope: "row" }, String(row + 1)),
      ...["mass", "e"].map(column => editor(row, column, pendulum[column], data)),
      ...data.keys.map(key => cells[`${key}_${row + 1}`] = make("td", { className: "now" })))));
    showNow(now);
    if (isNew) table.closest("details").scrollIntoView({ block: "nearest" });
    if (last) body.querySelector(`[data-place="${last}"]`)?.focus(); // the Tab key goes on from there
  }

  function showNow(numbers) {
    now = numbers;
    for (const name in cells) cells[name].textContent = numbers[name] ?? "";
  }

  // panel.js calls this when the parts of the page are in their places.
  function arrangeTable() {
    const section = document.querySelector("section.pendula-part");
    section.prepend(make("div", { className: "sideways" }, table));
    section.querySelector("input").remove(); // of VPython
    section.closest("details").addEventListener("toggle", event => tell("table", event.target.open));
    const spans = section.querySelectorAll(":scope > span");
    for (const [i, show] of [showRows, showNow].entries()) // in the order in which table.py makes them
      new MutationObserver(() => {
        const data = spans[i].querySelector(".data");
        if (data) show(JSON.parse(data.dataset.value));
      }).observe(spans[i], { childList: true });
  }

  Object.assign(window, { arrangeTable, tell });
}
