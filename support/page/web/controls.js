// The controls: made and filled as the program declares them (declarations.py), and the buttons.
import { find, make, show, state } from "page";
import { send, sliders } from "program";

const makers = {
  Switch({ name, label }) {
    const box = make("input", { type: "checkbox", name });
    return [make("label", {}, box, label)];
  },
  Slider({ name, label, step }) {
    const id = name;
    return [make("div", { className: "slider" },
      make("label", { htmlFor: id }, label),
      make("input", { type: "range", id, name, step }),
      make("output", { htmlFor: id }),
    )];
  },
  Menu({ name, label }, isUnlabelled) {
    if (isUnlabelled) return [make("select", { name, ariaLabel: label })];
    const menu = make("select", { id: name, name });
    return [make("div", { className: "menu" }, make("label", { htmlFor: name }, label), menu)];
  },
};

const fillers = {
  Switch(box, _, value) {
    box.checked = value;
  },
  Slider(slider, { min, max, text }, value) {
    Object.assign(slider, { min, max });
    if (!slider.matches(":active")) slider.value = value;
    slider.nextElementSibling.value = text;
    slider.setAttribute("aria-valuetext", text);
  },
  Menu(menu, { choices }, value) {
    const old = [...menu.options].map(option => option.value);
    const isNew = JSON.stringify(old) !== JSON.stringify(choices);
    if (isNew) menu.replaceChildren(...choices.map(choice => new Option(choice, choice)));
    if (isNew || !menu.matches(":active")) menu.value = value;
  },
};

for (const { dataset } of find("template[data-control]")) {
  show(dataset.control, () => showControl(dataset.control));
}
show("controls", controls => {
  for (const place of find("template[data-control]")) {
    const name = place.dataset.control;
    const control = controls[name];
    if (!control) continue; // the other kind of cradle has it
    const isUnlabelled = place.matches(".unlabelled");
    place.replaceWith(...makers[control.kind]({ name, ...control }, isUnlabelled));
  }
  for (const name in controls) showControl(name);
  for (const button of find("[data-do=lifted]"))
    button.disabled = +button.dataset.value > controls.lifted.max;
});

function showControl(name) {
  const control = state.controls?.[name];
  if (!control) return;
  for (const element of find(`[name="${name}"]`)) {
    for (const part of [element, ...element.labels]) part.title = control.help;
    element.disabled = !control.enabled;
    fillers[control.kind](element, control, state[name]);
  }
}

addEventListener("click", ({ target }) => {
  const { do: command, value } = target.closest?.("button")?.dataset ?? {};
  if (command) send(command, ...value === undefined ? [] : [JSON.parse(value)]);
});
addEventListener("input", ({ target }) => {
  if (target.type === "range") sliders.set(target.name, +target.value);
});
addEventListener("change", ({ target }) => {
  if (!target.name || target.type === "range") return;
  send(target.name, target.type === "checkbox" ? target.checked : target.value);
});

for (const fold of find(".fold")) fold.addEventListener("toggle", () => {
  if (fold.open) fold.scrollIntoView({ block: "nearest" });
});
