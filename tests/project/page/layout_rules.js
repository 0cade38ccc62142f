// The rules of the page's layout, which hold in each state and at each size.
import { find, one } from "page";

const SMALLEST = 8; // pixels: of the width and height of a part
const BY_ITSELF = ".graph, svg *, .plot *, .canvas *, .unseen"; // they place what is in them

// Return what is wrong on the page as it is: a text for each fault.
async function faults() {
  await new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)));
  const isTall = getComputedStyle(one("main")).display === "block"; // then the page scrolls
  const seen = find("body, body *").filter(part => part.checkVisibility() && !part.matches(BY_ITSELF));
  const parts = seen.filter(part => part.matches("button, input, select, summary, svg, .track, .plot"));
  const found = [
    ...seen.filter(part => !fits(part)).map(part => `${nameOf(part)} is cut`),
    ...parts.filter(isTiny).map(part => `${nameOf(part)} has no room`),
    ...parts.filter(isCovered).map(part => `${nameOf(part)} is covered`),
  ];
  if (innerWidth < document.documentElement.scrollWidth) found.push("The page scrolls aside");
  if (isTall) return found;
  if (one(".stage").clientHeight < innerHeight / 2) found.push("The cradle has less than half");
  const all = document.documentElement.matches(".presenting") ? "html, .panel" : "html";
  for (const part of find(all))
    if (part.scrollHeight > part.clientHeight) found.push(`${nameOf(part)} scrolls`);
  return found;
}

const nameOf = part => `${part.localName} ${part.className} ${part.innerText}`.slice(0, 60);

// Return whether all that is in a part can be seen, or scrolled to. The numbers of the plot may stand
// beside it: its graph has room for them.
function fits(part) {
  if (part.matches(".plot")) return true;
  const { overflowX, overflowY } = getComputedStyle(part);
  return (overflowX === "auto" || part.scrollWidth <= part.clientWidth + 1)
    && (overflowY === "auto" || part.scrollHeight <= part.clientHeight + 1);
}

function isTiny(part) {
  const { width, height } = part.getBoundingClientRect();
  return Math.min(width, height) < SMALLEST;
}

// Return whether another part lies on the middle of this one; what has to be scrolled to is free.
function isCovered(part) {
  const { left, right, top, bottom } = part.getBoundingClientRect();
  const above = document.elementFromPoint((left + right) / 2, (top + bottom) / 2);
  return !!above && !part.closest(".hits, .sideways") && !part.contains(above) && !above.contains(part);
}

Object.assign(window, { faults });
