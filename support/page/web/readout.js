// What the page says of the motion: in numbers, in a sentence, and in bars.
import { make, one, show, state } from "page";

show("running", running => {
  one("[data-do=pause]").textContent = running ? "Pause" : "Run";
  one("[data-do=step]").disabled = running;
});
show("paused", isPaused => {
  const sign = one(".paused");
  if (isPaused && sign.hidden) tell(); // not again after a cut of the connection
  sign.hidden = !isPaused;
});
show("motion", motion => {
  one(".readout").replaceChildren(...Object.entries(motion).map(readoutRow));
});
show("bars", chart => {
  const parts = chart ? [make("h2", {}, chart.title), ...chart.bars.map(makeBar)] : [];
  one(".momenta").replaceChildren(...parts);
});

export const inWords = () => [...Object.entries(state.motion ?? {}), state.summary].join(", ");

// A new element: a screen reader also says a sentence again.
export function tell() {
  one(".summary").replaceChildren(make("span", {}, inWords()));
}

function readoutRow([name, text]) { // its second line is a caption
  const [number, ...captions] = text.split("\n");
  const cell = make("td", {}, `${number} `, ...captions.map(caption => make("small", {}, caption)));
  return make("tr", { className: name }, make("th", { scope: "row" }, name), cell);
}

// A bar to the left or to the right of a line in the middle, which stands for 0.
function makeBar([name, text, color, part]) {
  const bar = make("i");
  const width = 50 * Math.abs(part);
  const left = part < 0 ? 50 - width : 50;
  Object.assign(bar.style, { left: `${left}%`, width: `${width}%`, background: color });
  const track = make("span", { className: "track" }, bar);
  return make("div", {}, make("span", {}, name), track, make("output", {}, text));
}
