// The line to the program: a websocket. It brings the state and VPython's drawing, and takes
// commands. When it is cut, the page connects again.
import "controls";
import "gallery";
import "graph";
import "hits";
import "keep";
import "keys";
import "questions";
import "readout";
import "sound";
import "sheets";
import "table";
import "unknown";
import { showPicture } from "canvas";
import { whenItEnds } from "goodbye";
import { fill, notice, one, remember, show, state, update } from "page";
import { set, setLine, sliders } from "program";

const SILENT_LOOKS = 4; // looks without a sign of life, after which the page says so
const LOST_LOOKS = 20; // such looks, after which it connects again

// Relative to the page, whatever stands before it.
const address = new URL(`ws${location.search}`, location.href);
address.protocol = address.protocol.replace("http", "ws");
// The program knows the page again when its line was cut, by its name; and after a reload, by its
// name before that.
const pageName = `${Math.random()}`;
address.searchParams.set("page", pageName);
address.searchParams.set("was", history.state?.page ?? "");
remember({ page: pageName });

let socket;
let has = 0; // the number of the last message
let silence = 0; // looks without a sign of life
let isHeard = true;
let isDone = false; // whether the page wants no line any more
let unreported = 0; // messages that the program does not know to be drawn
let seen = 0; // messages whose picture the program does not know of
let nextWord = 0; // ms: the time of the next word to the program

const isOpen = () => socket?.readyState === WebSocket.OPEN;

setLine(send);
show("ended", message => {
  if (message !== null) finish("ended");
});
connect();
setInterval(look, 1000);
requestAnimationFrame(countPictures);

function send(command) {
  // A bob that is let go must not stay in the air.
  const canSend = isOpen() && (isHeard || command[0] === "let_go");
  if (canSend) socket.send(JSON.stringify(command));
}

function connect() { // the program sends what is later than the last message
  if (isDone) return;
  socket?.close();
  address.searchParams.set("has", `${has}`);
  const line = new WebSocket(address);
  socket = line;
  line.onmessage = event => {
    if (line === socket) receive(event.data);
  };
  line.onclose = () => {
    if (line === socket) lose();
  };
}

async function lose() {
  if (isDone) return;
  isHeard = false;
  silence = 0;
  sliders.clear();
  setTimeout(connect, 1000);
  const answer = await fetch(`alive${location.search}`).then(answer => answer.text(), () => "");
  if (answer.includes("ends with a key")) finish("ended"); // another start has another key
}

function look() { // each second, but seldom in a tab that nobody sees: so it counts looks, not time
  if (isDone) return;
  silence++;
  if (silence > SILENT_LOOKS) isHeard = false;
  if (silence > LOST_LOOKS) lose();
  if (!isHeard && !one(".silence").firstChild) fill(".silence", "silence");
}

function hear() {
  silence = 0;
  if (!isHeard) showAgain();
  isHeard = true;
}

function showAgain() {
  one(".silence").replaceChildren();
  for (const name of /** @type {import("page").Value[]} */ (Object.keys(state)))
    if (name !== "sound") update(name); // a control may show a value that was not sent
}

function receive(data) {
  hear();
  if (!data) return; // only a sign of life
  unreported++;
  const { number, ...picture } = JSON.parse(data);
  has = number;
  showPicture(picture);
}

// For each picture that the browser has drawn, the program may send one message more. Few words are
// quicker than many.
function countPictures(now) {
  if (unreported > seen) seen++;
  if (isOpen() && now > nextWord && (seen || sliders.size)) {
    if (seen) socket.send("seen ".repeat(seen));
    // Only the last value of a slider: most of them restart the cradle.
    for (const [name, value] of sliders) set(name, value);
    sliders.clear();
    unreported -= seen;
    seen = 0;
    nextWord = now + 45;
  }
  requestAnimationFrame(countPictures);
}

function finish(id) {
  isDone = true;
  notice(id);
}

whenItEnds(isOpen, word => {
  // Not only by the line: what is on its way here can take it back. And Firefox may lose this one.
  navigator.sendBeacon(`${word}${address.search}`);
  isDone = true;
  socket?.close(word === "closed" ? 4001 : 4000); // a browser that keeps the page would keep it open
});
addEventListener("pageshow", event => {
  if (!event.persisted || one(".notice").firstChild) return;
  isDone = false;
  connect();
});
