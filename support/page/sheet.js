// The sheet of an experiment, which the browser prints. Its picture is the second one that is drawn when the question is
// there: on white. The canvas forgets it after this event. The numbers on the axles are on a second canvas.
{
  const find = selector => document.querySelector(selector);
  let asked, picture, background;

  function keepPicture() {
    const scene = glowObjs[0], question = find(".answers") && find(".question strong").textContent;
    if (background) {
      const { __canvas_element: cradle, __overlay_element: labels } = scene;
      const paper = Object.assign(document.createElement("canvas"), { width: cradle.width, height: cradle.height });
      for (const layer of [cradle, labels]) paper.getContext("2d").drawImage(layer, 0, 0);
      [scene.background, background, picture] = [background, null, paper.toDataURL()];
    } else if (question && question !== asked)
      [asked, background, scene.background] = [question, scene.background, vec(1, 1, 1)];
  }

  addEventListener("arranged", () => glowObjs[0].bind("draw_complete", keepPicture));
  addEventListener("beforeprint", () => {
    const image = find(".sheet img");
    if (image) image.src = picture;
  });
}
