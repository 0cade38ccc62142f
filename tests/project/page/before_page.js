// What runs in each page of the tests before the page's own scripts.
{
  const page = /** @type {any} */ (window);

  addEventListener("DOMContentLoaded", () => {
    // No graphics card draws the canvas
    document.head.insertAdjacentHTML("beforeend", `<style id="small">
      .canvas { max-width: 320px !important; max-height: 200px !important; }
    </style>`);
    if (document.querySelector("[type=importmap]")) page.tools.forEach(run); // VPython's has none
  });

  const run = module => {
    const script = document.createElement("script");
    Object.assign(script, { type: "module", textContent: module });
    document.head.append(script);
    script.remove(); // it runs all the same; a page that is saved is without it
  };
}
