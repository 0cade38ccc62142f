// The question of an experiment: its answers, what was said, what happened; and its sheet on paper.
shows.question = question => {
  const parts = question ? [makeQuestion(question), makeSheet(question)] : [];
  one(".asked").replaceChildren(...parts);
};

const LETTERS = "ABCDE";
const paragraph = (...parts) => make("p", {}, ...parts);
const strong = text => make("strong", {}, text);
const row = cells => make("tr", {}, ...cells.map(cell => make("td", {}, cell)));
const outcome = ({ title, why }) => paragraph(strong(`${title} `), why);

function button(text, className, ...command) {
  return make("button", { className, onclick: () => send(...command) }, text);
}

function makeQuestion({ key, question, answers, votes, asking, said, happened }) {
  const element = make("div", { className: "question", role: "status" });
  element.append(paragraph(strong(question)));
  if (asking) {
    const choices = make("div", { className: "answers" });
    answers.forEach((answer, number) => {
      const hands = button(String(votes[number]), "hands", "vote", key, number);
      hands.ariaLabel = `${votes[number]} hands for ${LETTERS[number]}`;
      choices.append(button(`${LETTERS[number]}\u2002${answer}`, "", "answer", key, number), hands);
    });
    element.append(choices, button("Run it without an answer", "plain", "answer", key, null));
  }
  if (said) element.append(paragraph(said));
  if (happened) element.append(
    outcome(happened),
    button("Again", "", "again", false),
    button("Again slowly", "", "again", true),
    button("Next experiment", "", "next"),
  );
  element.append(make("button", { className: "plain", onclick: () => print() }, "Print a sheet"));
  return element;
}

// A page to fill in, with the picture of picture.js; after the measurement, one with its figures.
function makeSheet({ name, question, answers, happened }) {
  const sheet = make("div", { className: "sheet printed" });
  sheet.append(make("article", {},
    make("h2", {}, name),
    make("p", { className: "picture" }),
    paragraph(question),
    make("ol", { type: "A" }, ...answers.map(answer => make("li", {}, answer))),
    paragraph("My answer: ______ because"),
    make("div", {}, "My sketch of the first swing:"),
    paragraph("I measured: speed ____________ m/s, angle ____________ degrees"),
  ));
  if (happened) sheet.append(make("article", {},
    make("h2", {}, `${name}: measured`),
    outcome(happened),
    make("table", {}, ...happened.rows.map(row)),
  ));
  return sheet;
}
