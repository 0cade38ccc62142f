// The sheet of an experiment, which the browser prints. It has the picture of the cradle before the release: the first
// one that is drawn when the question is there. The canvas forgets it after this event. The numbers on the axles are on a
// second canvas.
{
  const find = selector => document.querySelector(selector);
  let asked, picture, filter;

  function keepPicture() {
    const question = find(".answers") && find(".question strong").textContent;
    if (!question || question === asked) return;
    const { __canvas_element: cradle, __overlay_element: labels } = glowObjs[0];
    const paper = Object.assign(document.createElement("canvas"), { width: cradle.width, height: cradle.height });
    for (const layer of [cradle, labels]) paper.getContext("2d").drawImage(layer, 0, 0);
    [asked, picture] = [question, paper.toDataURL()];
    filter = matchMedia("(prefers-color-scheme: dark)").matches ? "invert(1) hue-rotate(180deg)" : ""; // on white paper
  }

  addEventListener("arranged", () => glowObjs[0].bind("draw_complete", keepPicture));
  addEventListener("beforeprint", () => {
    const image = find(".sheet img");
    if (image) Object.assign(image, { src: picture, style: `filter: ${filter}` });
  });
}
