// The question of an experiment: what you predict, what you have seen, and what happened.
import { find, make, one, show } from "page";
import { send } from "program";

let shown; // the question of now, as text, but for the hands while they are counted

show("question", question => {
  const isAsking = question?.asking;
  const text = JSON.stringify(isAsking ? { ...question, votes: null } : question);
  if (text !== shown) one(".asked").replaceChildren(...question ? [makeQuestion(question)] : []);
  shown = text;
  if (isAsking) question.votes[isAsking].forEach(showHands); // in their fields, which keep the keys
});

const LETTERS = "ABCDE";
const MOST_HANDS = 999;
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

function makeQuestion({ key, question, answers, votes, asking, replies, happened }) {
  const withLetter = number => `${LETTERS[number]}, ${answers[number]}`;
  const element = make("div", { className: "question" });
  element.append(asking === "seen" ? paragraph(question) : paragraph(strong(question)));
  if (asking === "seen") element.append(paragraph(strong("What did you see?")));
  if (asking) {
    element.append(makeAnswers(key, answers));
    element.append(make("button", { className: "count", onclick: countHands }, "Count hands"));
    if (asking === "seen") element.append(...makeAgain());
    return element;
  }
  element.append(...makeBars(votes));
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
  const choices = make("div", { className: "answers" });
  answers.forEach((answer, number) => {
    const choice = button(`${LETTERS[number]}\u2002${answer}`, "choice", "answer", key, number);
    choices.append(make("div", {}, choice, ...makeCounter(key, number)));
  });
  return choices;
}

function countHands() {
  document.documentElement.classList.toggle("counting");
}

// The hands for an answer: one fewer, a field to type in, and one more.
function makeCounter(key, number) {
  const letter = LETTERS[number];
  const field = make("input", { type: "text", inputMode: "numeric", className: "hands" });
  field.ariaLabel = `Hands for ${letter}`;
  field.onfocus = () => field.select(); // what you type replaces the number
  const set = count => {
    const isCount = Number.isInteger(count) && count >= 0 && count <= MOST_HANDS;
    if (isCount) send("vote", key, number, count);
    field.value = isCount ? count : field.defaultValue;
  };
  const step = (text, change, ariaLabel) => {
    const onclick = () => set(Number(field.value) + change);
    return make("button", { className: "hands", ariaLabel, onclick }, text);
  };
  field.onchange = () => set(Number(field.value));
  return [
    step("\u2212", -1, `One hand fewer for ${letter}`),
    field,
    step("+", 1, `One hand more for ${letter}`),
  ];
}

function showHands(count, number) {
  const field = find("input.hands")[number];
  const isTyped = field === document.activeElement && field.value !== field.defaultValue;
  field.defaultValue = count;
  if (!isTyped) field.value = count;
}

// The hands of both votes, side by side, on one scale.
function makeBars(votes) {
  const counted = Object.keys(votes).filter(name => votes[name].some(count => count));
  if (!counted.length) return [];
  const most = Math.max(...counted.flatMap(name => votes[name]));
  const chart = make("div", { className: "votes" });
  chart.style.setProperty("--votes", `${counted.length}`);
  chart.append(make("b"), ...counted.map(name => make("small", {}, name)));
  votes.predicted.forEach((_, number) => {
    chart.append(make("b", {}, LETTERS[number]));
    for (const name of counted) {
      const count = votes[name][number];
      const ariaLabel = `${LETTERS[number]}, ${name}: ${count}`;
      const bar = make("i", { style: `width: ${100 * count / most}%` });
      const track = make("span", { role: "img", ariaLabel }, bar);
      chart.append(make("div", {}, track, make("output", {}, count)));
    }
  });
  return [chart];
}
