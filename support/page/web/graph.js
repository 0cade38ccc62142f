// The graph of the state's rows: below the cradle; in a tall window, in the panel.
const tall = matchMedia("(max-aspect-ratio: 14/10)"); // as in windows.css
const ENTRY = 44; // pixels: the width of a number in the legend

shows.curves = drawGraph;
new ResizeObserver(drawGraph).observe(one(".plot"));
dark.addEventListener("change", drawGraph);
dark.addEventListener("change", () => shows.bars(state.bars)); // their colors are legible(...)
tall.addEventListener("change", placeGraph);
placeGraph();

function placeGraph() {
  if (tall.matches) one(".folds").before(one(".graph"));
  else one(".panel").after(one(".graph"));
}

function drawGraph() {
  const { x, y, curves, rows, scales, from, to, bottom, top } = state.curves ?? { curves: [] };
  const place = $(".plot");
  one(".graph").classList.toggle("none", !curves.length);
  one(".save-graph").disabled = !curves.length;
  one(".x").textContent = x ?? "";
  one(".y").textContent = y ?? "";
  // flot draws nothing that is hidden.
  if (!curves.length || !rows.length || !place.width() || !place.height()) return;
  const data = curves.map(({ label, color }, i) => ({
    label,
    color: legible(color),
    data: rows.map(row => [scales[0] * row[0], scales[1] * row[i + 1]]),
  }));
  const line = css("--line");
  $.plot(place, data, {
    series: { shadowSize: 0 },
    xaxis: { min: from, max: to, tickFormatter },
    yaxis: { min: bottom, max: top, labelWidth: 44 },
    legend: {
      show: curves.length * ENTRY < place.width(),
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
  const pixels = (max - value) / (max - min) * $(".plot").width();
  return pixels < 80 ? "" : Number(value.toPrecision(6));
}

// A curve has the color of its bob. If this can hardly be seen on the page, some of the page's ink
// is mixed in.
function legible(color) {
  const isPale = Math.abs(lightness(color) - lightness(css("--paper"))) < 0.25;
  return isPale ? `color-mix(in srgb, ${color} 40%, ${css("--ink")})` : color;
}

function lightness(color) {
  const { r, g, b } = $.color.parse(color);
  return (0.3 * r + 0.59 * g + 0.11 * b) / 255;
}
