// What you take away: a picture and the data as downloads, and the sheet of an experiment.
{
  const NAME = "newtons_cradle";
  const scene = () => glowObjs[0];
  const find = selector => document.querySelector(selector);

  function download(address, name) {
    Object.assign(document.createElement("a"), { href: address, download: name }).click();
  }

  const takePicture = () => scene().capture(`${NAME}.png`);
  const takeData = () => download(`/cradle_data.csv${location.search}`, "cradle_data.csv");

  // --- the sheet -----------------------------------------------------------------------------------------------------

  // It has the picture of the cradle before the release: the first one that is drawn when the question is there. The
  // canvas forgets it after this event. The numbers on the axles are on a second canvas.
  let picture = "";

  function keepPicture() {
    if (!find(".answers")) picture = find(".question") && picture;
    else if (!picture) {
      const { __canvas_element: cradle, __overlay_element: labels } = scene();
      const paper = Object.assign(document.createElement("canvas"), { width: cradle.width, height: cradle.height });
      for (const layer of [cradle, labels]) paper.getContext("2d").drawImage(layer, 0, 0);
      picture = paper.toDataURL();
    }
  }

  addEventListener("arranged", () => scene().bind("draw_complete", keepPicture));
  addEventListener("beforeprint", () => {
    const image = find(".sheet img");
    if (image) image.src = picture;
  });

  Object.assign(window, { takePicture, takeData });
}
