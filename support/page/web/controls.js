// The controls: made and filled as the program declares them (declarations.py), and the buttons.
import { find, make, show, state, update } from "page";
import { send, set, sliders } from "program";

const SETTLING = 600; // ms after which a control shows what the program says
let moved; // the slider that you have just moved
let timer;

const makers = {
  Switch({ name, label }) {
    const box = make("input", { type: "checkbox", name });
    return make("label", {}, box, label);
  },
  Slider({ name, label, step }) {
    return make("div", { className: "slider" },
      make("label", { htmlFor: name }, label),
      make("input", { type: "range", id: name, name, step }),
      make("output", { htmlFor: name }),
    );
  },
  Menu({ name, label }) {
    return make("select", { name, ariaLabel: label });
  },
};

const fillers = {
  Switch(box, { value }) {
    box.checked = value;
  },
  Slider(slider, { min, max, text, value }) {
    Object.assign(slider, { min, max });
    const isMoving = slider.matches(":active") || slider === moved;
    if (!isMoving) slider.value = value;
    slider.nextElementSibling.value = text;
    slider.setAttribute("aria-valuetext", text);
  },
  Menu(menu, { choices, value }) {
    const old = [...menu.options].map(option => option.value);
    const isNew = JSON.stringify(old) !== JSON.stringify(choices);
    if (isNew) menu.replaceChildren(...choices.map(choice => new Option(choice, choice)));
    if (isNew || !menu.matches(":active")) menu.value = value;
  },
};

show("controls", controls => {
  for (const place of find("template[data-place]")) {
    const names = Object.keys(controls).filter(name => controls[name].place === place.dataset.place);
    const elements = names.map(name => makers[controls[name].kind]({ name, ...controls[name] }));
    place.replaceWith(...elements);
  }
  for (const name in controls) fill(name, controls[name]);
  for (const button of find("[data-set=lifted]"))
    button.disabled = +button.dataset.value > controls.lifted.max;
});

function fill(name, control) {
  for (const element of find(`[name="${name}"]`)) {
    for (const part of [element, ...element.labels]) part.title = control.help;
    element.disabled = !control.enabled;
    fillers[control.kind](element, control);
  }
}

addEventListener("click", ({ target }) => {
  const { do: command, set: control, value } = target.closest?.("button")?.dataset ?? {};
  if (command) send(command);
  if (control) set(control, JSON.parse(value));
});
addEventListener("input", ({ target }) => {
  if (target.type === "range") {
    sliders.set(target.name, +target.value);
    // For a moment, the program may still say an older value.
    moved = target;
  }
  clearTimeout(timer);
  timer = setTimeout(() => {
    moved = null;
    if (state.controls) update("controls");
  }, SETTLING);
});
addEventListener("change", ({ target }) => {
  if (!target.name || target.type === "range") return;
  set(target.name, target.type === "checkbox" ? target.checked : target.value);
});

for (const fold of find(".fold")) fold.addEventListener("toggle", () => {
  if (fold.open) fold.scrollIntoView({ block: "nearest" });
});
