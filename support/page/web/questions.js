// The question of an experiment: what you predict, what you have seen, and what happened.
import { make, one, paragraph, show } from "page";
import { send } from "program";

const LETTERS = "ABCDE";
const strong = text => make("strong", {}, text);

show("question", question => one(".asked").replaceChildren(...question ? [makeQuestion(question)] : []));

function makeQuestion({ state, stem, question, answers, replies, outcome, why }) {
  const element = make("div", { className: "question" }, paragraph(strong(question)));
  const withLetter = number => `${LETTERS[number]}, ${answers[number]}`;
  if (state === "seen") element.append(paragraph(strong("What did you see?")));
  if (state in replies) {
    element.append(makeAnswers(stem, answers));
  } else {
    if (replies.asked !== null) element.append(paragraph(`You said: ${withLetter(replies.asked)}.`));
    if (replies.seen !== null) element.append(paragraph(`You saw: ${withLetter(replies.seen)}.`));
  }
  if (state === "explained") {
    const what = outcome === null ? "none of these answers" : withLetter(outcome);
    element.append(paragraph(strong(`What happened: ${what}. `), why));
    const isWrong = replies.seen !== null && replies.seen !== outcome;
    if (isWrong) element.append(paragraph("You saw something else: look again, slowly."));
  }
  if (state === "seen" || state === "explained")
    element.append(make("button", { className: "again", onclick: () => send("repeat") }, "Again slowly"));
  return element;
}

function makeAnswers(stem, answers) {
  const choices = answers.map((answer, number) => {
    const onclick = () => send("answer", stem, number);
    return make("button", { className: "choice", onclick }, `${LETTERS[number]}\u2002${answer}`);
  });
  return make("div", { className: "answers" }, ...choices);
}
