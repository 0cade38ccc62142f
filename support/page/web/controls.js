// The controls: made and filled as the program declares them (declarations.py), and the buttons.
import { find, make, show, update } from "page";
import { send, set, sliders } from "program";

const makers = {
  Switch({ name, label }) {
    const box = make("input", { type: "checkbox", name });
    return make("label", {}, box, label);
  },
  Slider({ name, label, step }) {
    return make("div", { className: "slider" },
      make("label", { htmlFor: name }, label),
      make("input", { type: "range", id: name, name, step, onblur: () => update("controls") }),
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
    // While you move it, by the mouse or by keys, the program may still say an older value.
    if (!slider.matches(":active, :focus")) slider.value = value;
    slider.nextElementSibling.value = text;
    slider.setAttribute("aria-valuetext", text);
  },
  Menu(menu, { choices, value }) {
    menu.replaceChildren(...choices.map(choice => new Option(choice)));
    menu.value = value;
  },
};

show("controls", controls => {
  for (const place of find("template[data-place]")) {
    const names = Object.keys(controls).filter(name => controls[name].place === place.dataset.place);
    const elements = names.map(name => makers[controls[name].kind]({ name, ...controls[name] }));
    place.replaceWith(...elements);
  }
  for (const name in controls) fill(name, controls[name]);
});

function fill(name, control) {
  for (const element of find(`[name="${name}"]`)) {
    for (const part of [element, ...element.labels]) part.title = control.help;
    element.disabled = !control.enabled;
    fillers[control.kind](element, control);
  }
}

addEventListener("click", ({ target }) => {
  const command = target.closest("button")?.dataset.do;
  if (command) send(command);
});
addEventListener("input", ({ target }) => {
  if (target.type === "range") sliders.set(target.name, +target.value);
});
addEventListener("change", ({ target }) => {
  if (!target.name || target.type === "range") return;
  set(target.name, target.type === "checkbox" ? target.checked : target.value);
});

for (const fold of find("details")) fold.ontoggle = () => {
  if (fold.open) fold.scrollIntoView({ block: "nearest" });
};
