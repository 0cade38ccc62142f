// The hidden value of an experiment: you type what you have measured.
import { make, one, show, state } from "page";
import { send } from "program";

const AT_HOME = "Step through the first hit: the speeds are below the bobs. Check your value in class.";

show("unknown", unknown => one(".unknown").replaceChildren(...unknown ? [makeForm(unknown)] : []));
show("checked", showWord);

function makeForm({ question, name, unit }) {
  const hasSpeeds = state.view.labels.some(({ text }) => text.includes("m/s"));
  const field = make("input", { type: "text", inputMode: "decimal", size: 6 });
  const form = make("form", { className: "question" },
    make("p", {}, make("strong", {}, question)),
    make("label", {}, `${name} = `, field, ` ${unit} `),
    make("button", {}, "Check"),
    make("p", { role: "status" }, state.checked ?? ""),
    make("p", { className: "at-home" }, hasSpeeds ? AT_HOME : ""),
  );
  form.addEventListener("submit", event => {
    event.preventDefault();
    send("check", field.value);
  });
  return form;
}

function showWord(word) {
  const place = one(".unknown [role=status]");
  if (place) place.textContent = word;
}
