"""The report's page in a real browser."""

import json
import math

import pytest
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

from coscrew_codegen.backends.html.pages import number, with_interval
from coscrew_codegen.reports.kernels.report_page import write
from tests.support.browser import chromium, resize
from tests.support.sample_report import SHOWN_FIRST, layout_name, sample_report, variant

REPORT = sample_report()
LAYOUTS = ("C, gcc, array of structs", "C, gcc, structure of arrays", "C, gcc, latency",
           "Python, N = 1000")


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    folder = tmp_path_factory.mktemp("report")
    write(REPORT, folder)
    return folder


@pytest.fixture(scope="module")
def browser():
    with chromium() as driver:
        yield driver


@pytest.fixture
def page(browser, folder):
    """The page, freshly loaded on a desktop, with empty logs."""
    browser.get("about:blank")
    resize(browser, 1280, 900)
    browser.get_log("browser")
    browser.get_log("performance")
    browser.get((folder / "report.html").as_uri())
    return browser


def ns(entry, layout):
    return next((time for time in entry.times if layout_name(time) == layout), None)


def tables(page):
    """The shown rows of each table of kernels, by its title."""
    return dict(page.execute_script("""
        return [...document.querySelectorAll("details")].map(details => [
          details.querySelector("summary").textContent.trim(),
          [...details.querySelectorAll("tbody tr")].filter(row => !row.hidden).map(row =>
            [...row.cells].map(cell => cell.textContent))]);"""))


def marks(page, figure):
    """The titles of a figure's marks, their places, and their fills."""
    return page.execute_script("""
        const figure = document.querySelectorAll("figure")[arguments[0]];
        return [...figure.querySelectorAll("[data-artist]:has(> title):has(use)")].map(mark => {
          const box = mark.querySelector("use").getBoundingClientRect();
          return [mark.querySelector("title").textContent, box.x + box.width / 2,
                  box.y + box.height / 2, getComputedStyle(mark.querySelector("use")).fill];
        });""", figure)


def headings(page):
    """The headings of the first table."""
    return page.find_elements(By.CSS_SELECTOR, "details[open] thead th")


def shown(x, measure):
    return "–" if math.isnan(x) else f"{number(x)} {measure}"


@pytest.mark.parametrize("layout", LAYOUTS)
def test_the_tables_have_a_row_for_each_entry_with_its_numbers(page, layout):
    rows = tables(page)[layout]
    assert [" ".join(row[:3]) for row in rows] == [variant(entry) for entry in REPORT.entries]
    for row, entry in zip(rows, REPORT.entries, strict=True):
        *_, hard, p999, median, times, ratio, pareto, flops, bound, to_bound, benign, _, _ = row
        assert hard == shown(entry.hard.worst, entry.measure)
        assert (p999, median) == (number(entry.hard.p999), number(entry.hard.median))
        assert benign == ("–" if entry.benign is None else shown(
            entry.benign.worst, entry.measure))
        time = ns(entry, layout)
        assert times == ("–" if time is None else
                         with_interval(time.ns, time.low, time.high))
        assert ratio == ("–" if time is None or time.ratio is None else
                         with_interval(time.ratio, time.ratio_low, time.ratio_high))
        assert pareto == ("–" if time is None else "○ dominated" if time.dominated
                          else "● undominated")
        assert flops == str(entry.flops)
        assert bound == (entry.bound.text if entry.bound else "–")
        assert to_bound == number(entry.bound.worst_ratio if entry.bound else None)


def test_awkward_numbers_are_shown_as_what_they_are(page):
    rows = {" ".join(row[:3]): row[3:] for row in tables(page)[SHOWN_FIRST]}
    assert rows["vec3_l2norm double plain"][0] == "∞ u"
    assert rows["vec3_copy double plain"][0] == "0 ulp"
    assert rows["dc single plain"][0] == rows["dc single plain"][3] == "–"
    assert rows["product_CoAdc double plain"][0] == "3.25e15 ulp"


def test_awkward_text_is_shown_as_it_is(page):
    text = page.find_element(By.TAG_NAME, "body").text
    assert "made-up machine </script><script>alert(1)</script> <b> & \"ω~\" 'τ' | `x`" in text
    assert "Changes since before </script>" in text


@pytest.mark.parametrize("key", (None, Keys.ENTER, Keys.SPACE))
@pytest.mark.parametrize("column, value", (
    (3, lambda e: e.hard.worst), (6, lambda e: t.ns if (t := ns(e, SHOWN_FIRST)) else math.nan),
    (9, lambda e: e.flops), (0, lambda e: e.operation)))
def test_a_heading_sorts_up_then_down_by_mouse_and_by_key(page, column, value, key):
    heading = headings(page)[column]
    button = heading.find_element(By.TAG_NAME, "button")
    values = {variant(entry): value(entry) for entry in REPORT.entries}
    missing = [name for name, x in values.items() if not isinstance(x, str) and math.isnan(x)]
    for order, reverse in (("ascending", False), ("descending", True)):
        button.send_keys(key) if key else button.click()
        assert heading.get_attribute("aria-sort") == order
        results = [" ".join(row[:3]) for row in tables(page)[SHOWN_FIRST]]
        kept = results[:len(results) - len(missing)]
        assert [values[name] for name in kept] == sorted(map(values.get, kept), reverse=reverse)
        assert sorted(results[len(kept):]) == sorted(missing)  # last in both orders
    assert page.execute_script(
        "return document.querySelectorAll('[aria-sort=ascending],[aria-sort=descending]').length"
    ) == 1
    assert len(tables(page)[LAYOUTS[0]]) == len(REPORT.entries)  # the others stay


def test_the_filter_keeps_rows_with_all_its_words(page):
    count = len(REPORT.entries)
    assert page.find_element(By.ID, "shown").text == f"{count} of {count} rows"
    page.find_element(By.ID, "filter").send_keys("CROSS_SC accurate")
    rows = tables(page)
    assert [" ".join(x[:3]) for x in rows[SHOWN_FIRST]] == [
        "cross_sc double accurate", "cross_sc single accurate"]
    assert {x[0] for of in rows.values() for x in of} == {"cross_sc"}
    assert page.find_element(By.ID, "shown").text == f"2 of {count} rows"
    page.find_element(By.ID, "filter").send_keys(" nowhere")
    assert not any(tables(page).values())


def test_figures_hold_a_mark_for_each_variant_where_its_values_are(page):
    """The headline in each precision, then each operation: more error is higher, more time further
    right; dominated ones are hollow; titles have the numbers of the tables."""
    entries = {variant(e): e for e in REPORT.entries}
    for figure, wanted in ((0, ("double", "product_CoAdc", "cross_sc")),
                           (1, ("single", "product_CoAdc", "cross_sc")),
                           (2, ("double", "single", "product_CoAdc")),
                           (4, ("double", "single", "cross_sc"))):
        drawn = {text.partition(":")[0]: (text, x, y, fill)
                 for text, x, y, fill in marks(page, figure)}
        assert set(drawn) == {name for name in entries if not set(name.split()[:2]) - {*wanted}}
        card = page.execute_script("""
            return getComputedStyle(document.querySelector("figure")).backgroundColor;""")
        for name, (text, x, y, fill) in drawn.items():
            time = ns(entries[name], SHOWN_FIRST)
            assert f"{number(entries[name].hard.worst)} ulp" in text
            assert f"{number(time.ns)} (" in text
            assert ("dominated" in text) == time.dominated == (fill == card)
            for other, (_, other_x, other_y, _) in drawn.items():
                if time.ns < ns(entries[other], SHOWN_FIRST).ns:
                    assert x < other_x
                if entries[name].hard.worst > entries[other].hard.worst:
                    assert y < other_y


def test_witnesses_are_in_hex(page):
    rows = tables(page)["Inputs of the worst errors in hex"]
    of = [row for row in rows if row[0] == "cross_sc"]
    assert len(of) == 2 * sum(e.operation == "cross_sc" for e in REPORT.entries)
    assert {row[5] for row in of} == {"0x1.8p+0 -0x1.23456789abcdep-1022"}


def test_drift_and_changes_are_in_tables(page):
    drift, changes = ([cell.text for cell in section.find_elements(By.CSS_SELECTOR, "tbody tr > *")]
                      for section in page.find_elements(By.TAG_NAME, "section")[-2:])
    assert drift == ["double", "no", "1000", "12.5", "101", "20.5 (20.2–21)",
                     "single", "yes", "1000000", "1.5", "∞", "30.2 (30–30.5)"]
    assert changes[:7] == ["cross_sc", "single", "plain", "worst error, hard, ulp", "4", "1",
                         "0.25 ×"]
    assert changes[7:10] + changes[11:] == ["product_CoAdc", "double", "plain", "2", "3", "1.5 ×"]


def test_the_page_asks_the_network_for_nothing_and_logs_nothing(page, folder):
    headings(page)[6].find_element(By.TAG_NAME, "button").click()
    messages = [json.loads(line["message"])["message"] for line in page.get_log("performance")]
    requested = [message["params"]["request"]["url"] for message in messages
                 if message["method"] == "Network.requestWillBeSent"]
    assert [url for url in requested if not url.startswith("data:")] == [
        (folder / "report.html").as_uri()]
    assert page.get_log("browser") == []


@pytest.mark.parametrize("width, height, phone", ((390, 844, True), (1280, 900, False)))
def test_the_page_does_not_overflow_sideways(page, width, height, phone):
    resize(page, width, height, phone)
    page.refresh()
    for summary in page.find_elements(By.TAG_NAME, "summary"):
        summary.click()
    page_width, visible = page.execute_script(
        "const root = document.documentElement; return [root.scrollWidth, root.clientWidth]")
    assert page_width == visible <= width
    table = page.find_element(By.CSS_SELECTOR, "details .scroll")
    if phone:  # the table is wider and scrolls inside
        assert table.get_property("scrollWidth") > table.get_property("clientWidth")


@pytest.mark.parametrize("scheme", ("light", "dark"))
def test_text_stands_out_from_its_ground(page, scheme):
    """WCAG 2.2's contrast of at least 4.5, for text, links and notes."""
    page.execute_cdp_cmd("Emulation.setEmulatedMedia", {
        "features": [{"name": "prefers-color-scheme", "value": scheme}]})
    colours = page.execute_script("""
        const style = getComputedStyle(document.documentElement);
        return Object.fromEntries(["paper", "card", "ink", "quiet", "accent", "warn"].map(
          name => [name, style.getPropertyValue(`--${name}`).trim()]));""")
    for text in ("ink", "quiet", "accent", "warn"):
        for ground in ("paper", "card"):
            light, dark = sorted((_luminance(colours[text]), _luminance(colours[ground])))[::-1]
            assert (light + 0.05) / (dark + 0.05) >= 4.5, (scheme, text, ground)


def _luminance(colour):
    parts = [int(colour[i:i + 2], 16) / 255 for i in (1, 3, 5)]
    linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in parts]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def test_every_control_has_a_name(page):
    unnamed = page.execute_script("""
        return [...document.querySelectorAll("select, input, button, [role=img], [role=region]")]
          .filter(e => !(e.labels?.length || e.textContent?.trim() || e.getAttribute("aria-label")
                         || document.getElementById(e.getAttribute("aria-labelledby"))))
          .map(e => e.outerHTML);""")
    assert unnamed == []
