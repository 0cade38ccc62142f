"""The layout of the page, by rules that hold in each state, at each size, in and out of Present."""

import pytest
from pages import button, pause, press, tick
from whole_cradles import FIVE_CSV, GOOD

from support.files.experiments import EXPERIMENTS, read_experiments

SIZES = ((1024, 768), (1280, 720), (1366, 768), (1600, 900), (1920, 1080), (2560, 1440))

# Return what is wrong on the page as it is, a text for each fault. The rules:
# - A part is inside of all that is around it, and of the window, or can be scrolled to.
# - No part covers another one.
# - No word has a line for itself where the word before it has room, too.
# - The tracks of a chart have one length, and equal numbers have equal bars.
FAULTS = """async () => {
    await new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)));
    // The parts that lie on others: on the cradle, in a corner or at an edge of it; in a tall
    // window, a slow hit is at the lower edge of the panel.
    const ON_TOP = ".leave, .paused, .hit-part";
    const PARTS = "button, input, select, summary, svg, .track, .votes span, .canvas, .series";
    const style = element => getComputedStyle(element);
    const edges = element => element.getBoundingClientRect();

    const seen = [...document.querySelectorAll("body *")].filter(isSeen);
    const controls = seen.filter(element => element.matches(PARTS));
    const boxes = controls.map(element => ({ element, name: nameOf(element), ...sides(edges(element)) }));
    const words = seen.filter(element => !element.matches(PARTS.replace("button, ", "")))
        .flatMap(wordsOf);
    boxes.push(...words);
    return [...new Set([...outside(), ...covered(), ...alone(), ...uneven()])];

    function isSeen(element) {
        if (!element.checkVisibility({ visibilityProperty: true }) || element.closest("select *, svg *, .series *"))
            return false;
        for (let part = element; part; part = part.parentElement)
            if (style(part).clipPath !== "none") return false;
        return true;
    }

    function nameOf(element) {
        const name = element.className || element.name || element.nodeName.toLowerCase();
        return `${name} ${element.textContent.slice(0, 40)}`.trim();
    }

    function sides({ left, right, top, bottom }) {
        return { left, right, top, bottom };
    }

    function wordsOf(element) { // letters are lower than their line
        const found = [];
        const range = new Range();
        const texts = [...element.childNodes].filter(node => node.nodeType === Node.TEXT_NODE);
        for (const text of texts) for (const { 0: word, index } of text.data.matchAll(/\\S+/g)) {
            range.setStart(text, index);
            range.setEnd(text, index + word.length);
            const { left, right, top, bottom, height } = range.getBoundingClientRect();
            const name = `“${word}” in ${nameOf(element)}`;
            found.push({ element, name, left, right, top: top + height / 8, bottom: bottom - height / 8 });
        }
        return found;
    }

    function outside() {
        return boxes.flatMap(box => {
            const around = whatCuts(box);
            return around ? [`${box.name} is outside of ${around}`] : [];
        });
    }

    // Return the name of what a box is outside of, if it cannot be scrolled to.
    function whatCuts({ element, left, right, top, bottom }) {
        let [isAside, isDown] = [false, false]; // whether a part around it scrolls this way
        const start = element.closest(".plot")?.parentElement ?? element; // it places its labels
        for (let part = start; part !== document.body; part = part.parentElement) {
            const { display, position, overflowX, overflowY } = style(part);
            if (display !== "contents" && part !== element) {
                const box = edges(part);
                const first = box.left - part.scrollLeft - 1;
                const top1 = box.top - part.scrollTop - 1;
                isAside ||= overflowX === "auto" && first <= left;
                isDown ||= overflowY === "auto" && top1 <= top;
                const fits = (isAside || (box.left - 1 <= left && right <= box.right + 1))
                    && (isDown || (box.top - 1 <= top && bottom <= box.bottom + 1));
                if (!fits) return nameOf(part).slice(0, 30);
            }
            if (position === "fixed") break;
        }
        const fits = (isAside || (0 <= left && right <= innerWidth))
            && (isDown || (0 <= top && bottom <= innerHeight));
        return fits ? null : "the window";
    }

    function covered() {
        const found = [];
        const flat = boxes.filter(({ element }) => !element.closest(ON_TOP)).map(inSight);
        flat.forEach((box, number) => flat.slice(0, number).forEach(other => {
            const isPart = box.element.contains(other.element) || other.element.contains(box.element);
            if (!isPart && meet(box, other)) found.push(`${box.name} covers ${other.name}`);
        }));
        return found;
    }

    function inSight(box) { // the rest is scrolled away
        let { left, right, top, bottom } = box;
        for (let part = box.element.parentElement; part; part = part.parentElement) {
            if (style(part).display === "contents" || style(part).overflowY === "visible") continue;
            const around = edges(part);
            [left, right] = [Math.max(left, around.left), Math.min(right, around.right)];
            [top, bottom] = [Math.max(top, around.top), Math.min(bottom, around.bottom)];
        }
        return { ...box, left, right, top, bottom };
    }

    function meet(a, b) {
        return a.left + 1 < b.right && b.left + 1 < a.right
            && a.top + 1 < b.bottom && b.top + 1 < a.bottom;
    }

    function alone() {
        const found = [];
        for (const [block, texts] of Map.groupBy(words, ({ element }) => blockOf(element))) {
            const lines = [...Map.groupBy(texts, ({ bottom }) => Math.round(bottom / 5)).values()];
            lines.forEach((line, number) => {
                if (!number || line.length > 1) return;
                const [word, before] = [line[0], lines[number - 1].at(-1)];
                const needs = word.right - word.left + before.right - before.left + 8;
                const isEnough = texts.length >= 2 * lines.length; // of words, two for each line
                const fits = needs < widthOf(block) ? isEnough : needs < widthOf(block) + freeBeside(block);
                if (fits) found.push(`${word.name} has a line for itself`);
            });
        }
        return found;
    }

    function blockOf(element) {
        while (style(element).display === "inline") element = element.parentElement;
        return element;
    }

    function widthOf(block) { // without its padding
        const { paddingLeft, paddingRight } = style(block);
        return edges(block).width - parseFloat(paddingLeft) - parseFloat(paddingRight);
    }

    function freeBeside(block) { // the free width on its right
        const box = edges(block);
        const others = boxes.filter(({ element, left, top, bottom }) => left >= box.right
            && top < box.bottom && box.top < bottom && !block.contains(element));
        const end = edges(block.closest(".question, section, body")).right;
        return Math.max(0, Math.min(end, ...others.map(({ left }) => left)) - 16 - box.right);
    }

    function uneven() {
        const found = [];
        for (const chart of [".votes", ".momenta"]) {
            const rows = seen.filter(element => element.matches(`${chart} div`));
            const tracks = rows.map(row => edges(row.children[1]));
            const bars = rows.map(row => edges(row.querySelector("i")).width);
            const numbers = rows.map(row => Math.abs(parseFloat(row.lastChild.textContent)));
            const isMomentum = rows.map(row => !row.textContent.startsWith("energy"));
            const largest = Math.max(...numbers.filter((_, row) => isMomentum[row]));
            const scale = bars[numbers.indexOf(largest)] / largest;
            rows.forEach((row, number) => {
                const { left, width } = tracks[number];
                const isAbove = edges(row).left === edges(rows[0]).left;
                if (Math.abs(width - tracks[0].width) > 1 || isAbove && left !== tracks[0].left)
                    found.push(`${chart}: the track of ${row.textContent} is not like the first`);
                if (isMomentum[number] && Math.abs(bars[number] - scale * numbers[number]) > 1)
                    found.push(`${chart}: the bar of ${row.textContent} has another scale`);
            });
        }
        return found;
    }
}"""


def length_of_texts(experiment):
    return len("".join(answer.text for answer in experiment.answers) + experiment.why)


LONGEST = max(read_experiments(EXPERIMENTS / "single", 1)[0], key=length_of_texts).name


def ask(page, file):
    tick(page, "Predict first")
    button(page, LONGEST).click()
    page.locator(".answers").wait_for()


def count(page, file):
    """Count hands: their buttons are there only in Present."""
    ask(page, file)
    page.keyboard.press("f")
    for answer, hands in (("A", 1), ("C", 10)):
        for number in range(hands):
            press(page, f"{number} hand{'' if number == 1 else 's'} for {answer}")
    button(page, f"10 hands for C").wait_for()
    page.keyboard.press("f")


def answer(page, file):
    count(page, file)
    page.keyboard.press("a")
    page.locator(".question").get_by_text("What happened: ").wait_for()


def show_arrows(page, file):
    tick(page, "Arrows")
    page.locator(".track").first.wait_for()


def measure(page, file):
    tick(page, "Measure")
    page.locator(".readout").get_by_text("half swings").wait_for()


def show_slow_hits(page, file):
    show_arrows(page, file)
    tick(page, "Slow hits")
    page.locator(".hit-part strong").wait_for()


def show_all(page, file):
    show_arrows(page, file)
    measure(page, file)
    answer(page, file)


def make_a_mistake(page, file):
    file.write_text(FIVE_CSV + GOOD.replace("1.0", "-1", 1))
    page.locator(".error").first.get_by_text("line 7, column mass").wait_for()


STATES = {
    "asking": ask,
    "counted": count,
    "answered": answer,
    "arrows": show_arrows,
    "measure": measure,
    "slow hits": show_slow_hits,
    "both": show_all,
    "error": make_a_mistake,
}


@pytest.fixture
def wide(shared):
    """The shared page, with the whole place of the cradle."""
    shared.evaluate("document.querySelector('#small').disabled = true")
    yield shared
    if shared.get_by_role("checkbox", name="Measure").is_checked():
        shared.get_by_role("checkbox", name="Measure").uncheck()
    shared.evaluate("document.querySelector('#small').disabled = false")


@pytest.mark.parametrize("state", STATES)
def test_each_part_has_its_place(wide, file, state):
    STATES[state](wide, file)
    if state not in ("asking", "counted"):
        pause(wide)
    faults = []
    for mode in ("page", "Present"):
        for width, height in SIZES:
            wide.set_viewport_size({"width": width, "height": height})
            for fault in wide.evaluate(FAULTS):
                faults.append(f"{width} x {height}, {mode}: {fault}")
        wide.keyboard.press("f")
    assert not faults, "\n".join(faults)
