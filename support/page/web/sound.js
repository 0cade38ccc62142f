// The sound of the hits: a click for the fastest hit of each picture. Off until you tick the box Sound, in this tab.
const LOUDEST = 2; // m/s: a faster hit is not louder
const RATE = 48000; // samples a second
const wave = t => Math.sin(2 * Math.PI * 3700 * t) * Math.exp(-t / 0.006); // as short as steel's
const click = new AudioBuffer({ length: 0.04 * RATE, sampleRate: RATE });
click.copyToChannel(click.getChannelData(0).map((_, i) => wave(i / RATE)), 0);
let audio; // it comes when you tick the box: a browser allows sound only after a click or a key

one("#sound").addEventListener("change", ({ target }) => {
  audio ??= new AudioContext();
  audio[target.checked ? "resume" : "suspend"]();
});

shows.sound = ([, speed]) => {
  if (audio?.state !== "running" || !speed) return;
  const source = new AudioBufferSourceNode(audio, { buffer: click });
  const gain = 0.5 * Math.sqrt(Math.min(1, speed / LOUDEST)); // the root: the ear hears slow hits, too, beside fast ones
  source.connect(new GainNode(audio, { gain })).connect(audio.destination);
  source.start();
};
