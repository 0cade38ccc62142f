// The question of an experiment: its answers, what was said, what happened; and its sheet on paper.
const button = (text, className, ...command) => make("button", { className, onclick: () => tell(...command) }, String(text));
const row = cells => make("tr", {}, ...cells.map(cell => make("td", {}, cell)));
const happened = ({ title, why }) => make("p", {}, make("strong", {}, `${title} `), why);

shows.question = question => one(".asked").replaceChildren(...question ? [shown(question), sheet(question)] : []);

function shown({ key, question, answers, votes, asking, said, happened: outcome }) {
  const parts = [make("p", {}, make("strong", {}, question))];
  if (asking) parts.push(
    make("div", { className: "answers" }, ...answers.flatMap((answer, number) => [
      button(`${"ABCDE"[number]}\u2002${answer}`, "", "answer", key, number),
      Object.assign(button(votes[number], "hands", "vote", key, number), { ariaLabel: `${votes[number]} hands for ${"ABCDE"[number]}` }),
    ])),
    button("Run it without an answer", "plain", "answer", key, null));
  if (said) parts.push(make("p", {}, said));
  if (outcome) parts.push(happened(outcome),
    button("Again", "", "again", false), button("Again slowly", "", "again", true), button("Next experiment", "", "next"));
  parts.push(make("button", { className: "plain", onclick: () => print() }, "Print a sheet"));
  return make("div", { className: "question", role: "status" }, ...parts);
}

// A page to fill in, and after the measurement one with its figures; canvas.js puts the picture into it.
function sheet({ name, question, answers, happened: outcome }) {
  const pages = [make("article", {},
    make("h2", {}, name), make("p", { className: "picture" }), make("p", {}, question),
    make("ol", { type: "A" }, ...answers.map(answer => make("li", {}, answer))),
    make("p", {}, "My answer: ______ because"), make("div", {}, "My sketch of the first swing:"),
    make("p", {}, "I measured: speed ____________ m/s, angle ____________ degrees"))];
  if (outcome) pages.push(make("article", {},
    make("h2", {}, `${name}: measured`), happened(outcome), make("table", {}, ...outcome.rows.map(row))));
  return make("div", { className: "sheet printed" }, ...pages);
}
