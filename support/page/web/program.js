// What the page asks of the program. The last script of the page says how: line.js or run.js.

/** @typedef {typeof import("names").COMMANDS[number]} Command */

/** Gives a command to the program. @type {(command: any[]) => any} */
let line;

/** The last value of each slider that you move. @type {Map<any, number>} */
export const sliders = new Map();

/** @param {typeof line} newLine */
export function setLine(newLine) {
  line = newLine;
}

/** @param {Command} command */
export function send(command, ...values) {
  line([command, ...values]);
}

// Set a control (declarations.py) to a value.
export const set = (control, value) => send("set", control, value);
