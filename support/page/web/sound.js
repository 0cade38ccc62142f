// The sound of the hits in this tab: a click for the fastest hit of each picture. It is off until
// you tick the box Sound.
import { one, show } from "page";

const LOUDEST = 2; // m/s: a faster hit is not louder
const RATE = 48000; // samples a second
const wave = t => Math.sin(2 * Math.PI * 3700 * t) * Math.exp(-t / 0.006); // as short as steel's
const click = new AudioBuffer({ length: 0.04 * RATE, sampleRate: RATE });
const samples = click.getChannelData(0).map((_, i) => wave(i / RATE));
click.copyToChannel(samples, 0);
let audio;

// A browser allows sound only after a click or a key. It may have ticked the box itself, when it
// loaded the page again: then any click or key brings the sound.
for (const type of ["click", "keydown"]) addEventListener(type, followBox, true);

function followBox() {
  const isOn = one("#sound").checked;
  if (isOn) audio ??= new AudioContext();
  audio?.[isOn ? "resume" : "suspend"]();
}

show("sound", ({ speed }) => {
  if (audio?.state !== "running") return;
  const source = new AudioBufferSourceNode(audio, { buffer: click });
  // The root: the ear hears slow hits, too, among fast ones.
  const gain = 0.5 * Math.sqrt(Math.min(1, speed / LOUDEST));
  source.connect(new GainNode(audio, { gain })).connect(audio.destination);
  source.start();
});
