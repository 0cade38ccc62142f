// The hidden value of an experiment: you type what you have measured.
import { make, one, paragraph, show } from "page";
import { send } from "program";

show("unknown", unknown => one(".unknown").replaceChildren(...unknown ? [makeForm(unknown)] : []));
show("checked", showWord); // first the form, then the word

function makeForm({ question, name, unit }) {
  const field = make("input", { type: "text", inputMode: "decimal" });
  const form = make("form", { className: "question" },
    paragraph(make("strong", {}, question)),
    make("label", {}, `${name} = `, field, ` ${unit} `),
    make("button", {}, "Check"),
    make("p", { role: "status" }),
    make("p", { className: "at-home" }, "Check your value in class."),
  );
  form.onsubmit = event => {
    event.preventDefault();
    send("check", field.value);
  };
  return form;
}

function showWord(word) {
  const form = one(".unknown form");
  if (!form) return;
  form.querySelector("[role=status]").textContent = word;
  if (!word) form.reset(); // for the next group
}
