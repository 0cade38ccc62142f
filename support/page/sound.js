// The sound of the hits: a click of steel for the fastest hit of each picture. Off until you tick the box Sound.
{
  const LOUDEST = 2; // m/s: a faster hit is not louder
  const LIMIT = 0.5; // of full scale: nothing gets louder, however many clicks sound together
  const MOST = 8; // clicks at once
  const LENGTH = 0.04; // s
  // The partials of a click: frequency (Hz), part, and time (s) in which it falls to a third.
  const PARTIALS = [[2100, 0.5, 0.008], [3700, 1, 0.006], [5900, 0.7, 0.004], [8600, 0.4, 0.002]];

  let box, place; // the checkbox, and the element in which the program puts a hit
  let audio, steel, limiter; // only after you have ticked the box
  let sounding = 0;

  function open() {
    audio = new AudioContext();
    steel = audio.createBuffer(1, LENGTH * audio.sampleRate, audio.sampleRate);
    const wave = steel.getChannelData(0).map((_, i) => {
      const t = i / audio.sampleRate;
      return PARTIALS.reduce((sum, [f, part, fall]) => sum + part * Math.sin(2 * Math.PI * f * t) * Math.exp(-t / fall), 0);
    });
    const peak = Math.max(...wave.map(Math.abs));
    steel.copyToChannel(wave.map(value => value / peak), 0);
    // A DynamicsCompressor would let the first milliseconds of a click through, which is most of it. This one is a
    // curve, which bends and ends at the limit.
    const curve = Float32Array.from({ length: 1001 }, (_, i) => LIMIT * Math.tanh((i / 500 - 1) / LIMIT));
    limiter = new WaveShaperNode(audio, { curve });
    limiter.connect(audio.destination);
  }

  function follow() { // a browser allows sound only after a click or a key; a reload needs one, too
    if (box.checked) {
      if (!audio) open();
      audio.resume();
    } else audio?.suspend();
  }

  function play() {
    const speed = Number(place.querySelector(".hit")?.dataset.speed);
    if (audio?.state !== "running" || !speed || sounding >= MOST) return;
    const click = new AudioBufferSourceNode(audio, { buffer: steel });
    // The root: the ear hears slow hits, too, beside fast ones.
    click.connect(new GainNode(audio, { gain: Math.sqrt(Math.min(1, speed / LOUDEST)) })).connect(limiter);
    click.onended = () => sounding--;
    sounding++;
    click.start();
  }

  addEventListener("arranged", () => {
    place = document.querySelector(".hit").parentElement;
    box = place.previousElementSibling.querySelector("input");
    new MutationObserver(play).observe(place, { childList: true });
    for (const type of ["click", "keydown"]) addEventListener(type, follow, true);
  });
}
