// The question of an experiment: what you predict, what you have seen, and what happened.
import { make, one, show } from "page";
import { send } from "program";

let shown; // the question of now, as text

show("question", question => {
  const text = JSON.stringify(question);
  if (text !== shown) one(".asked").replaceChildren(...question ? [makeQuestion(question)] : []);
  shown = text;
});

const LETTERS = "ABCDE";
const WORDS = { predicted: "You said", seen: "You saw" };
const paragraph = (...parts) => make("p", {}, ...parts);
const strong = text => make("strong", {}, text);

/** @param {import("program").Command} command */
function button(text, className, command, ...values) {
  return make("button", { className, onclick: () => send(command, ...values) }, text);
}

const makeAgain = () => [
  button("Again", "again", "repeat", false),
  button("Again slowly", "again", "repeat", true),
];

function makeQuestion({ key, question, answers, asking, replies, happened }) {
  const withLetter = number => `${LETTERS[number]}, ${answers[number]}`;
  const element = make("div", { className: "question" });
  element.append(asking === "seen" ? paragraph(question) : paragraph(strong(question)));
  if (asking === "seen") element.append(paragraph(strong("What did you see?")));
  if (asking) {
    element.append(makeAnswers(key, answers));
    if (asking === "seen") element.append(...makeAgain());
    return element;
  }
  const said = makeReplies(replies, number => {
    return number === happened?.outcome ? LETTERS[number] : withLetter(number); // its text is below
  });
  if (said) element.append(paragraph(said));
  if (happened) element.append(...makeOutcome(happened, replies.seen, withLetter), ...makeAgain());
  return element;
}

// Return the replies in sentences; name(number) is that of an answer.
function makeReplies(replies, name) {
  const given = Object.keys(replies).filter(asked => replies[asked] !== null);
  return given.map(asked => `${WORDS[asked]}: ${name(replies[asked])}.`).join(" ");
}

function makeOutcome({ outcome, why }, seen, name) {
  const what = outcome === null ? "none of these answers" : name(outcome);
  const parts = [paragraph(strong(`What happened: ${what}. `), why)];
  const isWrong = seen !== null && seen !== outcome;
  if (isWrong) parts.push(paragraph("You saw something else: look again, slowly."));
  return parts;
}

function makeAnswers(key, answers) {
  const choices = answers.map((answer, number) => {
    return button(`${LETTERS[number]}\u2002${answer}`, "choice", "answer", key, number);
  });
  return make("div", { className: "answers" }, ...choices);
}
