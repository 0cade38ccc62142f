// The graph of the state's rows: below the cradle; in a tall window, in the panel.
import { legible } from "colors";
import { plot } from "glow";
import { css, one, show, state } from "page";

const tall = matchMedia("(max-aspect-ratio: 14/10)"); // as in windows.css
const ENTRY = 44; // pixels: the width of a number in the legend

show("curves", drawGraph);
new ResizeObserver(drawGraph).observe(one(".plot"));
tall.addEventListener("change", placeGraph);
placeGraph();

function placeGraph() {
  if (tall.matches) one(".folds").before(one(".graph"));
  else one(".panel").after(one(".graph"));
}

function drawGraph() {
  const { x, y, curves, rows, from, to, bottom, top } = state.curves ?? { curves: [] };
  const place = one(".plot");
  one(".graph").classList.toggle("none", !curves.length);
  one(".x").textContent = x ?? "";
  one(".y").textContent = y ?? "";
  // flot draws nothing that is hidden.
  if (!curves.length || !rows.length || !place.clientWidth || !place.clientHeight) return;
  const data = curves.map(({ label, color }, i) => ({
    label,
    color: legible(color),
    data: rows.map(row => [row[0], row[i + 1]]),
  }));
  const line = css("--line");
  plot(place, data, {
    series: { shadowSize: 0 },
    xaxis: { min: from, max: to, tickFormatter },
    yaxis: { min: bottom, max: top, labelWidth: 44 },
    legend: {
      show: curves.length * ENTRY < place.clientWidth,
      noColumns: curves.length,
      position: "ne",
      margin: [0, -24],
      backgroundOpacity: 0,
    },
    grid: {
      offsets: { left: 0, right: 0, top: 0, bottom: 0 },
      color: css("--pale"),
      borderColor: line,
      tickColor: line,
      backgroundColor: "transparent",
      borderWidth: 1,
    },
  });
}

// The name of the axis takes the place of its last number.
function tickFormatter(value, { min, max }) {
  const pixels = (max - value) / (max - min) * one(".plot").clientWidth;
  return pixels < 80 ? "" : Number(value.toPrecision(6));
}
