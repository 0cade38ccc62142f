// The question of an experiment: its answers, the reply, what happened; and its sheet on paper.
import { find, make, one, show } from "page";
import { send } from "program";

let shown; // the question of now, as text, but for the hands while they are counted

show("question", question => {
  const isCounting = question?.asking;
  const text = JSON.stringify(isCounting ? { ...question, votes: [] } : question);
  if (text !== shown) {
    const parts = question ? [makeQuestion(question), makeSheet(question)] : [];
    one(".questions").replaceChildren(...parts);
  }
  shown = text;
  if (isCounting) question.votes.forEach(showHands); // in their buttons, which keep the keys
});

const LETTERS = "ABCDE";
const paragraph = (...parts) => make("p", {}, ...parts);
const strong = text => make("strong", {}, text);
const tableRow = cells => make("tr", {}, ...cells.map(cell => make("td", {}, cell)));
const outcome = ({ title, why }) => paragraph(strong(`${title} `), why);

/** @param {import("program").Command} command */
function button(text, className, command, ...values) {
  return make("button", { className, onclick: () => send(command, ...values) }, text);
}

function makeQuestion({ key, question, answers, votes, asking, reply, happened }) {
  const element = make("div", { className: "question" });
  element.append(paragraph(strong(question)));
  if (asking) {
    const choices = make("div", { className: "answers" });
    answers.forEach((answer, number) => {
      const text = `${LETTERS[number]}\u2002${answer}`;
      const choice = make("div", {}, button(text, "choice", "answer", key, number));
      choice.append(...makeCounter(key, number));
      choices.append(choice);
    });
    element.append(choices, button("Run it without an answer", "", "answer", key, null));
  }
  if (!asking && votes.some(count => count)) element.append(makeBars(votes));
  if (reply) element.append(paragraph(reply));
  if (happened) element.append(
    outcome(happened),
    button("Again", "", "repeat", false),
    button("Again slowly", "", "repeat", true),
    button("Next experiment", "", "next"),
  );
  element.append(make("button", { onclick: () => print() }, "Print a sheet"));
  return element;
}

const inHands = count => count === 1 ? "1 hand" : `${count} hands`;

// A button that counts one hand more, or one fewer by a right click; and one that counts one fewer.
function makeCounter(key, number) {
  const more = button("", "hands more", "vote", key, number, true);
  const fewer = button("\u2212", "hands", "vote", key, number, false);
  fewer.ariaLabel = `one hand fewer for ${LETTERS[number]}`;
  more.oncontextmenu = event => {
    event.preventDefault();
    fewer.click();
  };
  return [more, fewer];
}

function showHands(count, number) {
  const more = find(".hands.more")[number];
  more.textContent = inHands(count);
  more.ariaLabel = `${inHands(count)} for ${LETTERS[number]}`;
}

function makeBars(votes) {
  const chart = make("div", { className: "votes" });
  const most = Math.max(...votes);
  votes.forEach((count, number) => {
    const line = make("div", { role: "img", ariaLabel: `${LETTERS[number]}: ${inHands(count)}` });
    const bar = make("i", { style: `width: ${100 * count / most}%` });
    line.append(make("b", {}, LETTERS[number]), make("span", {}, bar), make("output", {}, count));
    chart.append(line);
  });
  return chart;
}

// A page to fill in, with the picture of paper.js; after the measurement, one with its figures.
function makeSheet({ name, question, answers, happened }) {
  const sheet = make("div", { className: "sheet printed" });
  sheet.append(make("article", {},
    make("div", { className: "fields" }, make("span", {}, "Name"), make("span", {}, "Date")),
    make("h2", {}, name),
    paragraph(question),
    make("ol", { type: "A" }, ...answers.map(answer => make("li", {}, answer))),
    paragraph("My answer: ______ because"),
    make("div", { className: "ruled" }),
    make("div", { className: "ruled" }),
    paragraph("My sketch of the first swing:"),
    make("div", { className: "picture sketch" }),
    paragraph(
      "I measured: speed ________ m/s, angle ________ degrees, ____ half swings in ________ s",
    ),
  ));
  if (happened) sheet.append(make("article", {},
    make("h2", {}, `${name}: measured`),
    outcome(happened),
    make("table", {}, ...happened.rows.map(tableRow)),
  ));
  return sheet;
}
