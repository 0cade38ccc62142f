// What the page asks of the program. The first script of the page says how: line.js or run.js.
import { COMMANDS } from "names";

/** @typedef {typeof COMMANDS[number]} Command */

/** @type {{ send: (command: any[]) => any, isOpen: () => boolean }} */
let line;

/** The last value of each slider that you move. @type {Map<any, number>} */
export const sliders = new Map();

/** @param {typeof line} newLine */
export function setLine(newLine) {
  line = newLine;
}

export const isOpen = () => line.isOpen();

/**
 * Give a command to the program; return whether it will come there.
 * @param {Command} command
 */
export function send(command, ...values) {
  if (!COMMANDS.includes(command)) throw new Error(`There is no command ${command}.`);
  return line.send([command, ...values]);
}

// Set a control (declarations.py) to a value.
export const set = (control, value) => send("set", control, value);
