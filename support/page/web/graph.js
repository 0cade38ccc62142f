// The graph of the state's rows: below the cradle; in a tall window, among the other parts of the panel.
const tall = matchMedia("(max-aspect-ratio: 14/10)"); // as in page.css

shows.curves = drawGraph;
new ResizeObserver(drawGraph).observe(one(".plot"));
dark.addEventListener("change", drawGraph);
tall.addEventListener("change", placeGraph);
placeGraph();

function placeGraph() {
  if (tall.matches) one(".fold").before(one(".graph"));
  else one(".panel").after(one(".graph"));
}

function drawGraph() {
  const { x, y, curves, rows, from, to } = state.curves ?? { curves: [] }, place = $(".plot");
  one(".graph").classList.toggle("none", !curves.length);
  one(".x").textContent = x ?? "";
  one(".y").textContent = y ?? "";
  if (!curves.length || !rows.length || !place.width() || !place.height()) return; // flot draws nothing that is hidden
  const data = curves.map(([label, color], i) => ({ label, color: legible(color), data: rows.map(row => [row[0], row[i + 1]]) }));
  const most = column => 1.05 * Math.max(0.01, ...rows.map(row => Math.abs(row[column])));
  const [along, up] = from === undefined ? [1, 2].map(number => ({ min: -most(number - 1), max: most(number - 1) })) // a phase picture
    : [{ min: from, max: to }, y === "%" ? { min: 0, max: most(curves.length) } : {}]; // the total is the last one
  $.plot(place, data, {
    series: { shadowSize: 0 },
    // The name of the axis takes the place of its last number.
    xaxis: { ...along, tickFormatter: (value, { min, max }) => (max - value) / (max - min) * place.width() < 80 ? "" : Number(value.toPrecision(6)) },
    yaxis: { ...up, labelWidth: 44 },
    legend: { show: curves.length < 9 && from !== undefined, noColumns: 8, position: "ne", margin: [0, -24], backgroundOpacity: 0 },
    grid: { offsets: { left: 0, right: 0, top: 0, bottom: 0 }, color: css("--pale"), borderColor: css("--line"), tickColor: css("--line"), backgroundColor: "transparent", borderWidth: 1 },
  });
}

// A curve has the color of its bob. If this can hardly be seen on the page, some of the page's ink is mixed in.
function legible(color) {
  const light = ({ r, g, b }) => (0.3 * r + 0.59 * g + 0.11 * b) / 255;
  const isPale = Math.abs(light($.color.parse(color)) - light($.color.parse(css("--paper")))) < 0.25;
  return isPale ? `color-mix(in srgb, ${color} 60%, ${css("--ink")})` : color;
}
