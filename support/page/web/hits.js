// The hits of a series, which Slow hits show one by one, and the button that goes to the next one.
import { find, make, one, show } from "page";

show("controls", ({ slow_hits }) => {
  one("[data-do=step]").textContent = slow_hits.value ? "Next hit" : "Step";
});
show("hits", hits => {
  const head = hits.slice(-1).map(({ bobs }) => makeRow("th", Object.keys(bobs[0])));
  one(".hits table").replaceChildren(...head, ...hits.map(makeHit));
  one(".hits > div").scrollTop = 0; // the end: style.css turns it over
  // A screen reader hears the headings and the hit of now, not the whole table.
  const cells = find(".hits:has(.now) th, .now td");
  if (cells.length) one(".summary").textContent = cells.map(cell => cell.textContent).join(" ");
});

function makeHit({ call, bobs, now }) {
  const title = makeRow("td", [call]);
  title.firstChild.colSpan = 9;
  const rows = bobs.map(bob => makeRow("td", Object.values(bob)));
  return make("tbody", { className: now ? "now" : "" }, title, ...rows);
}

function makeRow(kind, texts) {
  return make("tr", {}, ...texts.map(text => make(kind, {}, text)));
}
