"""The rules of the page's layout, which hold in each state and at each size.

- A part has a size. It is inside of all that is around it, and of the window, or can be scrolled
  to.
- No part covers another one.
- The tracks of a chart have one length, and equal numbers have equal bars.
"""

# Return what is wrong on the page as it is: a text for each fault.
FAULTS = """async () => {
    await new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)));
    // The parts that lie on others: at a corner or an edge of the cradle. In a tall window, a slow
    // hit is at the lower edge instead, on a panel that scrolls.
    const ON_TOP = {
        ".leave": ".canvas, .hit-part",
        ".paused": ".canvas",
        ".hit-part": ".canvas",
    };
    const BOXES = "input, select, summary, svg, .track, .canvas, .hit-part";
    const SMALLEST = 8; // pixels: of a part's width and height

    const style = element => getComputedStyle(element);
    const edges = element => element.getBoundingClientRect();
    const seen = [...document.querySelectorAll("body *")].filter(isSeen);
    const parts = seen.filter(element => element.matches(`button, ${BOXES}`)).map(boxOf);
    const words = seen.filter(element => !element.matches(BOXES)).flatMap(wordsOf);
    const boxes = [...parts, ...words];
    const faults = [...crushed(), ...outside(), ...covered(), ...uneven()];
    return [...new Set(faults)];

    function isSeen(element) {
        const isPart = !element.closest("select *, svg *");
        if (!isPart || !element.checkVisibility({ visibilityProperty: true })) return false;
        for (let part = element; part; part = part.parentElement)
            if (style(part).clipPath !== "none") return false;
        return true;
    }

    function nameOf(element) {
        const name = element.getAttribute("class") || element.name || element.localName;
        return `${name} ${element.textContent.slice(0, 40)}`.replace(/\\s+/g, " ").trim();
    }

    function boxOf(element) {
        const { left, right, top, bottom } = edges(element);
        return { element, name: nameOf(element), left, right, top, bottom };
    }

    function wordsOf(element) { // letters are lower than their line
        const texts = [...element.childNodes].filter(node => node.nodeType === Node.TEXT_NODE);
        const range = new Range();
        return texts.flatMap(text => [...text.data.matchAll(/\\S+/g)].map(({ 0: word, index }) => {
            range.setStart(text, index);
            range.setEnd(text, index + word.length);
            const { left, right, top, bottom, height } = range.getBoundingClientRect();
            const name = `“${word}” in ${nameOf(element)}`;
            const lower = height / 8;
            return { element, name, left, right, top: top + lower, bottom: bottom - lower };
        }));
    }

    function crushed() {
        const isSmall = ({ left, right, top, bottom }) =>
            right - left < SMALLEST || bottom - top < SMALLEST;
        return parts.filter(isSmall).map(({ name }) => `${name} has no room`);
    }

    function outside() {
        const found = boxes.map(box => [box.name, whatCuts(box)]).filter(([, around]) => around);
        return found.map(([name, around]) => `${name} is outside of ${around}`);
    }

    // Return the name of what a box is outside of, if it cannot be scrolled to.
    function whatCuts({ element, left, right, top, bottom }) {
        let isAside = false; // whether a part around it scrolls aside, or down
        let isDown = false;
        const isInside = around =>
            (isAside || (around.left <= left + 1 && right <= around.right + 1))
            && (isDown || (around.top <= top + 1 && bottom <= around.bottom + 1));
        // The plot places its labels itself
        let part = element.closest(".plot")?.parentElement ?? element;
        for (; part !== document.body; part = part.parentElement) {
            const { display, position, overflowX, overflowY } = style(part);
            if (display !== "contents" && part !== element) {
                const around = edges(part);
                isAside ||= overflowX === "auto" && around.left - part.scrollLeft <= left + 1;
                isDown ||= overflowY === "auto" && around.top - part.scrollTop <= top + 1;
                if (!isInside(around)) return nameOf(part);
            }
            if (position === "fixed") break;
        }
        const all = { left: 0, right: innerWidth, top: 0, bottom: innerHeight };
        return isInside(all) ? null : "the window";
    }

    function covered() {
        const found = [];
        const visible = boxes.map(inSight);
        visible.forEach((box, number) => visible.slice(0, number).forEach(other => {
            const [a, b] = [box.element, other.element];
            const isAllowed = a.contains(b) || b.contains(a) || isOnTop(a, b) || isOnTop(b, a);
            if (!isAllowed && meet(box, other)) found.push(`${box.name} covers ${other.name}`);
        }));
        return found;
    }

    function isOnTop(element, other) {
        const hit = element.closest(".hit-part");
        if (hit && edges(hit).bottom === innerHeight) return true;
        const rules = Object.entries(ON_TOP);
        return rules.some(([part, below]) => element.closest(part) && other.matches(below));
    }

    function inSight(box) { // the rest is scrolled away
        let { left, right, top, bottom } = box;
        for (let part = box.element; part; part = part.parentElement) {
            const { display, position, overflowY } = style(part);
            if (display !== "contents" && overflowY !== "visible") {
                const around = edges(part);
                [left, right] = [Math.max(left, around.left), Math.min(right, around.right)];
                [top, bottom] = [Math.max(top, around.top), Math.min(bottom, around.bottom)];
            }
            if (position === "fixed") break;
        }
        return { ...box, left, right, top, bottom };
    }

    function meet(a, b) {
        return a.left + 1 < b.right && b.left + 1 < a.right
            && a.top + 1 < b.bottom && b.top + 1 < a.bottom;
    }

    function uneven() {
        const bars = seen.filter(element => element.matches(".momenta div")).map(row => ({
            name: nameOf(row),
            left: edges(row).left,
            track: edges(row.children[1]),
            bar: edges(row.querySelector("i")).width,
            number: Math.abs(parseFloat(row.lastChild.textContent)),
        }));
        const largest = bars.toSorted((a, b) => b.number - a.number)[0];
        const isOther = ({ left, track }) => Math.abs(track.width - largest.track.width) > 1
            || (left === largest.left && track.left !== largest.track.left);
        const isFalse = ({ bar, number }) =>
            Math.abs(bar - largest.bar * number / largest.number) > 1;
        return [
            ...bars.filter(isOther).map(({ name }) => `the track of ${name} is another one`),
            ...bars.filter(isFalse).map(({ name }) => `the bar of ${name} has another scale`),
        ];
    }
}"""
