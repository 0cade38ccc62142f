// The colors of the page (style.css), and colors that can be seen on it.
import { rgb, vec } from "glow";
import { css } from "page";

// Return the color with this name as VPython has it.
export function colorOf(name) {
  const { r, g, b } = rgb(css(name));
  return vec(r, g, b).divide(255);
}

// A curve has the color of its bob. If this can hardly be seen on the page, some of the page's ink
// is mixed in.
export function legible(color) {
  const isPale = Math.abs(lightness(color) - lightness(css("--paper"))) < 0.25;
  return isPale ? `color-mix(in srgb, ${color} 40%, ${css("--ink")})` : color;
}

function lightness(color) {
  const { r, g, b } = rgb(color);
  return (0.3 * r + 0.59 * g + 0.11 * b) / 255;
}
