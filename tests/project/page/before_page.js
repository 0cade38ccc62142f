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

  // peak() is the largest sample of the last 0.7 s at the loudspeaker, if it is in use.
  const connect = /** @type {any} */ (AudioNode.prototype.connect);
  page.peak = () => null;
  AudioNode.prototype.connect = function (to, ...others) {
    if (to === this.context.destination) {
      const tap = new AnalyserNode(this.context, { fftSize: 32768 });
      const samples = new Float32Array(tap.fftSize);
      connect.call(this, tap);
      page.audio = this.context;
      page.peak = () => {
        tap.getFloatTimeDomainData(samples);
        return Math.max(...samples.map(Math.abs));
      };
    }
    return connect.call(this, to, ...others);
  };
}
