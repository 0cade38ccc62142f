// The cradles that you can choose: a small drawn picture of each, as it is before its release.
import { find, make, one, show, state } from "page";
import { set } from "program";

const SVG = "http://www.w3.org/2000/svg";
const CORD = 30; // of the whole pendulum; the lengths are those of the drawing
const SPACING = 9;
const RADIUS = 4.4; // of the lightest bob
const LARGEST_BOB = 1.6; // times RADIUS: the heaviest bob

show("pictures", pictures => {
  one(".gallery").replaceChildren(...Object.entries(pictures).map(makeTile));
  markTile();
});
show("controls", markTile);
show("changed", markTile);
show("mistakes", mistakes => {
  one("ul.failed").replaceChildren(...mistakes.map(mistake => make("li", {}, mistake)));
});

function makeTile([name, pendula]) {
  const onclick = () => {
    set("experiment", name);
    one("#gallery").hidePopover();
  };
  return make("button", { title: name, onclick }, drawCradle(pendula), make("span", {}, name));
}

function markTile() {
  const chosen = state.controls.experiment.value;
  for (const tile of find(".gallery button")) tile.ariaPressed = tile.title === chosen;
  const name = state.changed ? `${chosen}, changed` : chosen;
  const word = make("small", {}, "Experiments ▾");
  one(".choose").replaceChildren(drawCradle(state.pictures[chosen]), make("span", {}, name), word);
}

function draw(kind, attributes, ...parts) {
  const element = document.createElementNS(SVG, kind);
  for (const name in attributes) element.setAttribute(name, attributes[name]);
  element.append(...parts);
  return element;
}

export function drawCradle(pendula) {
  const width = SPACING * (pendula.length - 1);
  const lightest = Math.min(...pendula.map(({ mass }) => mass ?? Infinity));
  const view = `${-CORD} -2 ${width + 2 * CORD} ${CORD + 11}`;
  const rail = draw("line", { x1: -CORD / 2, x2: width + CORD / 2 });
  const drawing = draw("svg", { viewBox: view, "aria-hidden": true }, rail);
  pendula.forEach(({ color, mass, angles }, number) => {
    const radius = RADIUS * Math.min(LARGEST_BOB, Math.cbrt((mass ?? lightest) / lightest));
    let [x, y] = [SPACING * number, 0];
    for (const angle of angles) {
      const [x1, y1] = [x, y];
      x += CORD / angles.length * Math.sin(angle);
      y += CORD / angles.length * Math.cos(angle);
      drawing.append(draw("line", { x1, y1, x2: x, y2: y }));
      drawing.append(draw("circle", { cx: x, cy: y, r: radius, fill: color }));
      if (mass === null) drawing.append(draw("text", { x, y: y + 3 }, "?"));
    }
  });
  return drawing;
}
