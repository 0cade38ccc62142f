// The sound of the hits: a click for the fastest hit of each picture. Off until you tick the box Sound.
{
  const LOUDEST = 2; // m/s: a faster hit is not louder
  let box, place; // the checkbox, and the element in which the program puts a hit
  let audio; // only after you have ticked the box

  function follow() { // a browser allows sound only after a click or a key; a reload needs one, too
    if (box.checked) (audio ??= new AudioContext()).resume();
    else audio?.suspend();
  }

  function play() {
    const speed = Number(place.querySelector(".hit")?.dataset.speed);
    if (audio?.state !== "running" || !speed) return;
    const gain = 0.5 * Math.sqrt(Math.min(1, speed / LOUDEST)); // the root: the ear hears slow hits, too, beside fast ones
    const tone = new OscillatorNode(audio, { type: "triangle", frequency: 3700 }), fading = new GainNode(audio, { gain });
    fading.gain.setTargetAtTime(0, audio.currentTime, 0.006); // s: as short as the click of steel
    tone.connect(fading).connect(audio.destination);
    tone.start();
    tone.stop(audio.currentTime + 0.05);
  }

  addEventListener("arranged", () => {
    place = document.querySelector(".hit").parentElement;
    box = place.previousElementSibling.querySelector("input");
    new MutationObserver(play).observe(place, { childList: true });
    for (const type of ["click", "keydown"]) addEventListener(type, follow, true);
  });
}
