// How a page ends: you have left it, and may come back by Back; or its tab is closed, for sure
// - in Firefox, if the line is open: Firefox closes that of a page that you leave before pagehide;
// - in others, if nobody has questions before: it is closed by a script, or with the browser,
// - or if the page still runs a moment later: Chromium stops a page at once that you leave.
const isFirefox = navigator.userAgent.includes("Firefox");
let isAsked = false;
addEventListener("beforeunload", () => isAsked = true);

// Call leave("left") or leave("closed") when the page ends; isOpen() says whether the line is open.
export function whenItEnds(isOpen, leave) {
  addEventListener("pagehide", ({ persisted }) => {
    const isClosed = !persisted && (isFirefox ? isOpen() : !isAsked);
    leave(isClosed ? "closed" : "left");
    if (!persisted) window.scheduler?.postTask(() => leave("closed"));
  });
}
