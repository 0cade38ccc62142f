// The fold Take away: a picture, a film and the data as downloads, and the command for the clipboard.
{
  const NAME = "newtons_cradle";
  const TYPES = ["video/webm;codecs=vp8", "video/webm", "video/mp4"]; // the first one that the browser can record
  const type = TYPES.find(type => window.MediaRecorder?.isTypeSupported(type));
  const BITS = 6e6; // a second

  const scene = () => glowObjs[0];
  const find = selector => document.querySelector(selector);

  function download(address, name) {
    Object.assign(document.createElement("a"), { href: address, download: name }).click();
  }

  const takePicture = () => scene().capture(`${NAME}.png`);
  const takeData = () => download(`/cradle_data.csv${location.search}`, "cradle_data.csv");

  // --- the film ------------------------------------------------------------------------------------------------------

  let film; // the recorder, its paper (a canvas) and the time of its begin (ms), while a film runs

  function takeFilm() {
    if (film) film.recorder.stop();
    else begin();
  }

  function begin() {
    const { width, height } = scene().__canvas_element;
    const canvas = Object.assign(document.createElement("canvas"), { width: width & ~1, height: height & ~1 }); // even
    const paper = canvas.getContext("2d"), parts = [];
    const recorder = new MediaRecorder(canvas.captureStream(), { mimeType: type, videoBitsPerSecond: BITS });
    recorder.ondataavailable = event => parts.push(event.data);
    recorder.onstop = () => {
      film = undefined;
      showFilm();
      const address = URL.createObjectURL(new Blob(parts, { type }));
      download(address, `${NAME}.${type.slice(6).split(";")[0]}`);
      setTimeout(() => URL.revokeObjectURL(address), 60_000);
    };
    film = { recorder, paper, start: performance.now(), isEmpty: true };
  }

  // VPython has just drawn the cradle; the canvas forgets it after this event. The numbers on the axles are on a second
  // canvas. A film keeps its size: if the window changes, the cradle fills as much of it as fits.
  function draw() {
    if (!film) return;
    const { paper, recorder } = film, { width, height } = paper.canvas;
    const { __canvas_element: picture, __overlay_element: labels } = scene();
    const scale = Math.min(width / picture.width, height / picture.height);
    const place = [(width - scale * picture.width) / 2, (height - scale * picture.height) / 2, scale * picture.width, scale * picture.height];
    paper.fillStyle = getComputedStyle(document.body).backgroundColor;
    paper.fillRect(0, 0, width, height);
    for (const layer of [picture, labels]) paper.drawImage(layer, ...place);
    if (film.isEmpty) recorder.start(1000); // a part each second (ms)
    film.isEmpty = false;
    showFilm();
    if (find(".ended") && recorder.state === "recording") recorder.stop(); // the program has ended
  }

  function showFilm() {
    const button = find(".film"), seconds = film && Math.floor((performance.now() - film.start) / 1000);
    const text = film ? `Stop film (${seconds} s)` : "Film";
    if (button.textContent !== text) button.textContent = text;
    button.classList.toggle("running", !!film);
  }

  // --- the command ---------------------------------------------------------------------------------------------------

  async function takeCommand() {
    const command = find(".command"), copied = find(".copied");
    if (!command) return; // the panel says why there is none
    try {
      await navigator.clipboard.writeText(command.textContent);
      copied.textContent = "Copied.";
    } catch { // the browser does not allow it
      getSelection().selectAllChildren(command);
      copied.textContent = "Press Ctrl+C to copy it.";
    }
    setTimeout(() => copied.textContent = "", 5000);
  }

  addEventListener("arranged", () => {
    scene().bind("draw_complete", draw);
    if (!type) Object.assign(find(".film"), { disabled: true, title: "This browser cannot record a film." });
  });

  Object.assign(window, { takePicture, takeFilm, takeData, takeCommand });
}
