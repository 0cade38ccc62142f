// The page: its elements, and the state that the program sends, with what shows it.

/** @typedef {typeof import("names").VALUES[number]} Value */

/** @type {{ [name in Value]?: any }} */
export const state = {};
/** What shows each value. @type {{ [name in Value]?: ((value: any) => void)[] }} */
const shows = {};

/** @type {(selector: string) => any[]} */
export const find = selector => [...document.querySelectorAll(selector)];
/** @type {(selector: string) => any} */
export const one = selector => document.querySelector(selector);

/**
 * Make an element; texts in parts are never HTML.
 * @param {string} kind
 * @param {(any)[]} parts
 * @returns {any}
 */
export function make(kind, attributes = {}, ...parts) {
  const element = Object.assign(document.createElement(kind), attributes);
  element.append(...parts);
  return element;
}

export const paragraph = (...parts) => make("p", {}, ...parts);

/**
 * Let a function show a value, now and then: it gets the value when this has changed.
 * @param {Value} name
 * @param {(value: any) => void} how
 */
export function show(name, how) {
  shows[name] ??= [];
  shows[name].push(how);
}

/** @param {Value} name */
export function update(name) {
  for (const how of shows[name] ?? []) {
    try {
      how(state[name]);
    } catch (error) { // the other parts still show theirs
      reportError(error);
    }
  }
  showText(name);
}

function showText(name) {
  for (const element of find(`[data-text="${name}"]`)) element.textContent = state[name] ?? "";
}

// Fill a place of the page with the template of this id.
export function fill(place, id) {
  one(place).replaceChildren(one(`#${id}`).content.cloneNode(true));
  for (const name in state) showText(name);
}

// Say what ends the use of the page.
export function notice(id) {
  one(".silence").replaceChildren();
  fill(".notice", id);
  one(".notice").classList.add(id);
  for (const part of find(".canvas, .controls, .graph, .panel > :not(.messages, .head)")) part.inert = true;
}
