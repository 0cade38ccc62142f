// Whether the page is dark, and what can be seen on it.
import { rgb } from "glow";
import { css } from "page";

export const dark = matchMedia("(prefers-color-scheme: dark)");

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
