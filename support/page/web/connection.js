// The connection to the program: a websocket. It brings the state and VPython's drawing, and takes commands.
// Whatever happens to it, the next one is that of a new tab, which gets the whole state.
import { showPicture } from "canvas";
import { fill, notice, one, show } from "page";
import { set, setSender, sliders } from "program";

const SILENT = 4; // looks without a word of the program, after which the page says so
const LONGEST = 5000; // ms that an answer to a request may take
const PAUSE = 50; // ms between two answers: few are quicker, and most sliders restart the cradle

// Relative to the page, whatever stands before it: ws, or wss.
const address = new URL(`ws${location.search}`, location.href);
address.protocol = address.protocol.replace("http", "ws");

let socket;
let silence = 0; // looks since the last word of the program
let isAsking = false; // whether the page asks for a new connection
let hasEnded = false; // whether the program has said so
let seen = 0; // messages that are shown, and not yet answered

const isOpen = () => socket.readyState === WebSocket.OPEN;

setSender(send);
show("ended", () => {
  hasEnded = true;
  notice("ended");
});
connect();
setInterval(look, 1000); // seldom in a tab that nobody sees: so it counts looks, not time
setInterval(answer, PAUSE);

function connect() {
  seen = 0;
  socket = new WebSocket(address);
  socket.onmessage = ({ data }) => receive(data);
  socket.onclose = () => hasEnded || sayNobodyAnswers();
}

// Only if the program answers a request: Firefox lets a websocket wait longer after each failure.
async function connectAgain() {
  isAsking = true;
  const how = { method: "HEAD", signal: AbortSignal.timeout(LONGEST) };
  const answer = await fetch(location.href, how).catch(() => null);
  isAsking = false;
  if (answer?.status === 403) location.reload(); // another start has another key, and says so
  else if (answer?.ok) connect();
}

function send(command) {
  if (isOpen()) socket.send(JSON.stringify(command));
}

function receive(data) {
  silence = 0;
  one(".silence").replaceChildren();
  if (!data) return; // only a sign of life
  requestAnimationFrame(() => seen++); // first: a picture can fail
  showPicture(JSON.parse(data));
}

function look() {
  if (hasEnded) return;
  silence++;
  if (silence > SILENT) sayNobodyAnswers();
  const isLost = socket.readyState === WebSocket.CLOSED;
  if (isLost && !isAsking) connectAgain();
  else if (isOpen() && silence > SILENT) socket.send(""); // so the browser finds out about a cut
}

function sayNobodyAnswers() {
  if (!one(".silence").firstChild) fill(".silence", "silence");
}

function answer() {
  if (seen) send(["seen", seen]);
  seen = 0;
  for (const [name, value] of sliders) set(name, value);
  sliders.clear();
}
