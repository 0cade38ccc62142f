// Additions to VPython's page: sizes that follow the window, keys, touch, the camera's limits, names for screen readers.
// The other scripts of this folder wait for the event "arranged".
{
  // VPython sends a slider's value only if it differs from the last value that it sent. It does not send the first value,
  // or a value that you choose again after the program has moved the slider. This change sends each of them once.
  lastsliders = new Proxy({}, { has: () => true, get: (sent, i) => sent[i] === sliders[i] ? sliders[i] : {} });

  const scene = () => glowObjs[0];
  const find = selector => [...document.querySelectorAll(selector)];
  const bobs = () => glowObjs.filter(o => o?.constructor.name === "sphere" && o.visible && o.shininess); // no ghosts
  const css = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  const dark = matchMedia("(prefers-color-scheme: dark)"), tall = matchMedia("(max-aspect-ratio: 14/10)"); // as in panel.css
  const FINGER = 1.5; // a finger within this many radii of a bob's centre is on the bob, as in dragging.py

  // --- the graph -----------------------------------------------------------------------------------------------------

  // VPython rounds 2.5 at the axis of a graph to 3, draws the legend over the curves, and knows no dark page.
  const plot = $.plot;
  let drawn = null; // what the last plot was drawn from
  $.plot = Object.assign((place, curves, options) => {
    drawn = [place, curves, options];
    if (!place.width() || !place.height()) return place.data("plot") ?? { draw() {} }; // flot draws nothing that is hidden
    const seen = curves.filter(({ data }) => Number.isFinite(data[0]?.[0])).map(curve => ({ ...curve, color: legible(curve.color) }));
    const phase = seen.find(curve => curve.label === "phase"), tickFormatter = value => Number(value.toPrecision(6));
    const total = seen.find(curve => curve.label === "total")?.data.map(([, percent]) => percent);
    const limits = total ? [{}, { min: 0, max: 1.05 * Math.max(0.01, ...total) }] : [{}, {}];
    if (phase) {
      delete phase.label;
      for (const axis of [0, 1]) { // with the origin in the middle
        const most = 1.05 * Math.max(0.01, ...phase.data.map(point => Math.abs(point[axis])));
        limits[axis] = { min: -most, max: most };
      }
    }
    return plot(place, seen, $.extend(true, {}, options, {
      // The name of the axis takes the place of its last number.
      xaxis: { ...limits[0], tickFormatter: (value, { min, max }) => (max - value) / (max - min) * place.width() < 80 ? "" : tickFormatter(value) },
      yaxis: { ...limits[1], tickFormatter, labelWidth: 44 },
      legend: { show: seen.length < 9, noColumns: 8, position: "ne", margin: [0, -24], backgroundOpacity: 0 },
      grid: { color: css("--pale"), borderColor: css("--line"), tickColor: css("--line"), backgroundColor: "transparent", borderWidth: 1 },
    }));
  }, plot);

  // A curve has the color of its bob. If this can hardly be seen on the page, some of the page's ink is mixed in.
  function legible(color) {
    const [own, ink, paper] = [color, css("--ink"), css("--paper")].map(text => {
      const { r, g, b } = $.color.parse(text);
      return [r, g, b];
    });
    const light = ([red, green, blue]) => (0.3 * red + 0.59 * green + 0.11 * blue) / 255;
    const part = Math.abs(light(own) - light(paper)) < 0.25 ? 0.4 : 0;
    return `rgb(${own.map((value, i) => Math.round((1 - part) * value + part * ink[i]))})`;
  }

  function redraw() {
    if (drawn?.[0].is(":visible")) $.plot(...drawn);
  }

  // --- the parts of the page -----------------------------------------------------------------------------------------

  // VPython puts all widgets one after the other. The program calls this function after the last one: each mark
  // <i class="part" data-name="..." data-fold="..."> begins a section; one with a title in data-fold is folded away.
  function arrange() {
    const canvas = document.querySelector(".glowscript-canvas-wrapper"), panel = canvas.nextElementSibling;
    canvas.classList.add("canvas");
    panel.classList.add("panel");
    panel.setAttribute("role", "main");
    let section;
    for (const node of [...panel.childNodes]) {
      const mark = node.querySelector?.(".part");
      if (mark) {
        section = document.createElement("section");
        section.className = section.style.gridArea = mark.dataset.name; // the panel of tall windows is a grid
        if (mark.dataset.fold) fold(panel, section, mark.dataset.fold);
        else panel.append(section);
        node.remove();
      } else if (section && node.innerHTML !== " ") section.append(node); // VPython puts a space behind a button
    }
    const selecting = new MutationObserver(selectGraph);
    for (const element of document.querySelector("section.graph").children) selecting.observe(element, { childList: true });
    new MutationObserver(moveGraph).observe(document.querySelector(".glowscript"), { childList: true });
    arrangeTable();
    nameWidgets();
    tall.addEventListener("change", placeGraph);
    placeGraph();
    new ResizeObserver(fit).observe(canvas);
    // The first picture waits for the bobs and their textures: one without them would only delay it.
    scene().waitfor_textures = true;
    scene().bind("textures", () => scene().waitfor_textures = !scene().objects.length);
    scene().bind("draw_complete", keepPicture);
    dark.addEventListener("change", paint);
    paint();
    setInterval(describe, 1000);
    requestAnimationFrame(limit);
    dispatchEvent(new Event("arranged"));
  }

  function fold(panel, section, title) {
    const details = panel.appendChild(document.createElement("details"));
    details.className = details.style.gridArea = "fold";
    details.append(document.createElement("summary"), section);
    details.firstChild.append(title);
    details.addEventListener("toggle", () => details.open && details.scrollIntoView({ block: "nearest" }));
  }

  function selectGraph() { // in its menu, the one that the program draws
    const menu = document.querySelector(".graph select"), chosen = document.querySelector(".chosen")?.dataset.name;
    if ([...menu.options].some(option => option.text === chosen)) menu.value = chosen;
  }

  function moveGraph() { // VPython adds the graph with its first points
    const graph = document.querySelector(".glowscript > .glowscript-graph");
    if (!graph) return;
    document.querySelector("section.graph").append(graph);
    new ResizeObserver(redraw).observe(graph);
  }

  function placeGraph() { // below the cradle; in a tall window, among the other parts of the panel
    const panel = document.querySelector(".panel"), graph = document.querySelector("section.graph");
    if (tall.matches) panel.querySelector(".fold").before(graph);
    else panel.after(graph);
  }

  function fit() { // the canvas fills its part of the window; the program then points the camera
    const { clientWidth: width, clientHeight: height } = document.querySelector(".canvas");
    if (width && height) {
      Object.assign(scene(), { width, height });
      scene().trigger("resize", { event: "resize" });
    }
  }

  function paint() { // the canvas has the color of the page
    const { r, g, b } = $.color.parse(css("--back"));
    scene().background = vec(r, g, b).divide(255);
    redraw();
  }

  // --- names for screen readers --------------------------------------------------------------------------------------

  function nameWidgets() {
    document.documentElement.lang = "en";
    for (const box of find(".panel input[type=checkbox]")) { // a click on its text must do the same as one on the box
      const label = document.createElement("label");
      const text = box.nextElementSibling;
      box.before(label);
      label.append(box, text);
    }
    find(":is(.panel, .graph) .label").forEach((label, number) => {
      const widget = label.parentElement.nextElementSibling;
      const element = widget.matches("select") ? widget : widget.querySelector(".ui-slider-handle");
      label.id = `label-${number}`;
      element.setAttribute("aria-labelledby", label.id);
      if (element === widget) return;
      element.setAttribute("role", "slider");
      const value = widget.nextElementSibling;
      const update = () => {
        const slider = $(widget), bobs = value.querySelector("[data-count]")?.dataset;
        if (bobs) slider.slider("option", { step: 1 / bobs.count, value: bobs.lifted / bobs.count }); // the value came before its step
        const now = { now: slider.slider("value"), min: slider.slider("option", "min"), max: slider.slider("option", "max") };
        if (bobs) Object.assign(now, { now: +bobs.lifted, max: +bobs.count });
        for (const [name, number] of Object.entries({ ...now, text: value.innerText }))
          element.setAttribute(`aria-value${name}`, number);
      };
      new MutationObserver(update).observe(value, { childList: true });
      update();
    });
    const keys = [...document.querySelector("#keys").querySelectorAll("dt")];
    document.querySelectorAll(".controls button").forEach((button, number) => button.title ||= `Key: ${keys[number].innerText}`);
    document.querySelector(".canvas").setAttribute("role", "img");
  }

  function describe() { // the canvas, in words; at most once a second, or a screen reader would never end
    const count = bobs().length;
    const state = find(".readout tr").slice(0, 2).map(row => row.innerText.replace(/\s+/g, " ").trim()).join(", ");
    const words = `${document.title} with ${count} ${count === 1 ? "bob" : "bobs"}: ${state}`;
    const canvas = document.querySelector(".canvas");
    if (canvas.getAttribute("aria-label") !== words) canvas.setAttribute("aria-label", words);
  }

  // --- the camera, the mouse and fingers -----------------------------------------------------------------------------

  function limit() { // the camera never looks at the base from below, and stays upright
    const { forward, up } = scene();
    if (forward.y > 0) scene().forward = vec(forward.x, 0, forward.z);
    if (up.y !== 1) scene().up = vec(0, 1, 0);
    requestAnimationFrame(limit);
  }

  function isOnBob(x, y) {
    const mouse = scene().mouse;
    mouse.__update({ pageX: x, pageY: y });
    return bobs().some(bob => bob.pos.sub(mouse.pos).cross(mouse.ray).mag < FINGER * bob.radius);
  }

  const isCanvas = event => event.target.tagName === "CANVAS" && event.target.closest(".canvas");

  // A bob that you grab on the canvas also follows the mouse outside it, and you can let it go there.
  addEventListener("pointerdown", event => {
    if (isCanvas(event) && event.pointerType === "mouse") event.target.setPointerCapture(event.pointerId);
  }, true);
  addEventListener("pointermove", event => {
    if (!isCanvas(event) || event.pointerType !== "mouse") return;
    const held = event.buttons === 1;
    if (!held || event.target.style.cursor !== "grabbing")
      event.target.style.cursor = !isOnBob(event.pageX, event.pageY) ? "" : held ? "grabbing" : "grab";
  }, true);

  // One finger on a bob drags it at once: VPython would wait whether the finger turns the camera.
  addEventListener("touchstart", event => {
    if (!isCanvas(event) || event.touches.length > 1) return;
    const [finger] = event.touches, onBob = isOnBob(finger.clientX, finger.clientY);
    Object.assign(scene(), { userspin: !onBob, userzoom: !onBob });
  }, { capture: true, passive: true });
  for (const type of ["touchend", "touchcancel"])
    addEventListener(type, event => {
      if (!event.touches.length) setTimeout(() => Object.assign(scene(), { userspin: true, userzoom: true }));
    }, { passive: true });

  // A slider knows only the mouse.
  for (const [touch, mouse] of [["touchstart", "mousedown"], ["touchmove", "mousemove"], ["touchend", "mouseup"], ["touchcancel", "mouseup"]])
    addEventListener(touch, event => {
      if (!event.target.closest(".ui-slider")) return;
      const { clientX, clientY } = event.changedTouches[0];
      event.target.dispatchEvent(new MouseEvent(mouse, { bubbles: true, cancelable: true, clientX, clientY }));
      if (event.cancelable) event.preventDefault();
    }, { passive: false });

  // --- to present ----------------------------------------------------------------------------------------------------

  function present() {
    if (document.documentElement.classList.toggle("presenting")) document.documentElement.requestFullscreen?.().catch(() => {});
    else if (document.fullscreenElement) document.exitFullscreen();
  }
  addEventListener("fullscreenchange", () => document.documentElement.classList.toggle("presenting", !!document.fullscreenElement));

  // --- the sheet of an experiment, on paper ----------------------------------------------------------------------------

  // Its picture is the second one that is drawn when the question is there: on white. The canvas forgets it after this
  // event. The numbers on the axles are on a second canvas.
  let asked, picture, background;
  function keepPicture() {
    const question = find(".answers").length && find(".question strong")[0].textContent;
    if (background) {
      const { __canvas_element: cradle, __overlay_element: labels } = scene();
      const paper = Object.assign(document.createElement("canvas"), { width: cradle.width, height: cradle.height });
      for (const layer of [cradle, labels]) paper.getContext("2d").drawImage(layer, 0, 0);
      [scene().background, background, picture] = [background, null, paper.toDataURL()];
    } else if (question && question !== asked)
      [asked, background, scene().background] = [question, scene().background, vec(1, 1, 1)];
  }
  addEventListener("beforeprint", () => find(".sheet img").forEach(image => image.src = picture));

  // --- keys ----------------------------------------------------------------------------------------------------------

  // The keys control the cradle, and do not scroll the page; but a widget that you reach with the Tab key keeps them.
  // VPython does not get the keys that are stopped here: unknown keys, such as volume keys, cause an error in it.
  document.body.addEventListener("keydown", event => {
    const known = !event.metaKey && /^([ -~]|ArrowRight|Control|Shift|Alt)$/.test(event.key);
    const repeated = event.repeat && event.key !== "ArrowRight";
    if (event.target !== document.body || !known || repeated) event.stopPropagation();
    else if (event.key === " " || event.key === "ArrowRight") event.preventDefault();
    else if (event.key.toLowerCase() === "f" && !event.ctrlKey && !event.altKey) present();
    else if (event.key === "?") document.querySelector("#keys").togglePopover();
  });
  addEventListener("keydown", event => { // without full screen, Escape does not reach fullscreenchange
    if (event.key === "Escape" && document.documentElement.classList.contains("presenting")) present();
  }, true);
  // A widget that you use with the mouse does not keep them.
  let byMouse = false;
  addEventListener("pointerdown", () => byMouse = true, true);
  addEventListener("keydown", () => byMouse = false, true);
  for (const [type, isSelect] of [["click", false], ["change", true]]) // a click on a menu only opens it
    addEventListener(type, event => {
      if (byMouse && (event.target.tagName === "SELECT") === isSelect) document.activeElement.blur();
    }, true);

  Object.assign(window, { arrange, present });
}
