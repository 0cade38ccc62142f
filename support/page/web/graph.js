// The graph of the state's curves, by flot, which VPython has.
import { plot } from "glow";
import { one, show, state } from "page";

const ENTRY = 44; // pixels: the width of a number in the legend

show("curves", drawGraph);
new ResizeObserver(drawGraph).observe(one(".plot")); // also when Graph is ticked

function drawGraph() {
  const place = one(".plot");
  if (!state.curves || !place.clientHeight) return; // flot draws nothing that is hidden
  const { axes, curves, columns, from, to, bottom } = state.curves;
  one(".axes").textContent = axes;
  const drawn = curves.map(([label, x, y, color]) => ({
    label,
    color,
    data: columns[x].map((number, i) => [number, columns[y][i]]),
  }));
  plot(place, drawn, {
    shadowSize: 0,
    xaxis: { min: from, max: to },
    yaxis: { min: bottom },
    legend: {
      show: curves.length * ENTRY < place.clientWidth,
      noColumns: curves.length,
      backgroundOpacity: 0,
    },
    grid: { color: getComputedStyle(place).color, borderWidth: 1, offsets: new DOMRect() }, // they are 0
  });
}
