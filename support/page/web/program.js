// What the page asks of the program. The first script of the page says how: line.js or run.js.
import { COMMANDS } from "names";

/** @typedef {typeof COMMANDS[number]} Command */

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
  if (!COMMANDS.includes(command)) throw new Error(`There is no command ${command}.`);
  line([command, ...values]);
}

// Set a control (declarations.py) to a value.
export const set = (control, value) => send("set", control, value);
