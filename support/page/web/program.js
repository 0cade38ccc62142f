// What the page asks of the program. The last script of the page says how: connection.js or film.js.

/** @typedef {typeof import("names").COMMANDS[number]} Command */

/** Gives a command to the program. @type {(command: any[]) => any} */
let sender;

/** The last value of each slider that you move. @type {Map<any, number>} */
export const sliders = new Map();

/** @param {typeof sender} newSender */
export function setSender(newSender) {
  sender = newSender;
}

/** @param {Command} command */
export function send(command, ...values) {
  sender([command, ...values]);
}

// Set a control (declarations.py) to a value.
export const set = (control, value) => send("set", control, value);
