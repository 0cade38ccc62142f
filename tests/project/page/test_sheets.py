"""The sheets of the experiments, on paper."""

from pages import press


def test_all_sheets_are_printed_at_once_two_on_a_page(shared):
    """Nothing else is on the paper."""
    shared.evaluate("window.print = () => {}")
    shared.locator(".choose").click()
    press(shared, "Print the sheets of all experiments")
    shared.emulate_media(media="print")
    sheets = shared.locator("article")
    names = shared.evaluate("state.sheets.map(([name]) => name)")
    assert sheets.locator("h2").all_inner_texts() == names
    assert sheets.first.get_by_text("I predict").is_visible()
    measured = sheets.filter(has_text="I measured").locator("h2").all_inner_texts()
    assert measured == [name for name in names if "unknown" in name]
    assert sheets.nth(1).locator("circle").count() == 5
    assert not shared.locator(".readout").is_visible()
    pages_of_paper = shared.pdf(format="A4").count(b"/Type /Page\n")
    assert pages_of_paper == (len(names) + 1) // 2
    shared.evaluate("dispatchEvent(new Event('afterprint'))")
    assert sheets.count() == 0
