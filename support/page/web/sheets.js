// The sheets of all experiments, two on a page: to predict, to see and to measure.
import { drawCradle } from "gallery";
import { make, one, paragraph, state } from "page";

one(".print-sheets").onclick = () => {
  one("#gallery").hidePopover();
  one(".sheets").replaceChildren(...state.sheets.map(makeSheet));
  print();
};
addEventListener("afterprint", () => one(".sheets").replaceChildren());

const ruled = () => make("div", { className: "ruled" });

function makeSheet([name, question, answers]) {
  return make("article", {},
    make("div", { className: "fields" }, make("span", {}, "Name"), make("span", {}, "Date")),
    make("h2", {}, name),
    paragraph(question),
    make("div", { className: "sketch" }, drawCradle(state.pictures[name])),
    ...answers.length ? toPredict(answers) : toMeasure(),
  );
}

const toPredict = answers => [
  make("ol", { type: "A" }, ...answers.map(answer => make("li", {}, answer))),
  paragraph("I predict ______ because"),
  ruled(),
  paragraph("I saw ______ (sketch it in the picture)."),
  ruled(),
];

const toMeasure = () => [ // a hidden value
  paragraph("I measured, before and after the first hit (m/s):"),
  paragraph("left bob: v = ______, v' = ______"),
  paragraph("right bob: w = ______, w' = ______"),
  paragraph("My value: ______, because"),
  ruled(),
];
