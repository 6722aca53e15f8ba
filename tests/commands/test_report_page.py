"""The report's page in a real browser."""

import json
import math

import pytest
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import Select

from coscrew_codegen.reports.kernels.pages.overview import formatted
from coscrew_codegen.reports.kernels.pages.report_page import write
from tests.support.browser import chromium, resize
from tests.support.sample_report import SHOWN_FIRST, layout_name, same, sample_report, variant

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
    return next((time.ns for time in entry.times if layout_name(time) == layout), math.nan)


def rows(page):
    """The values in the table's cells, by variant, in order."""
    return dict(page.execute_script("""
        return [...document.querySelectorAll("#table-body tr")].map(row => [row.dataset.variant,
          Object.fromEntries([...row.querySelectorAll("td")].map(
            cell => [cell.dataset.column, [cell.dataset.value, cell.innerText]]))]);"""))


def marks(page, plot):
    """The marks of a plot: (variant, x, y, whether hollow)."""
    return [(name, float(x), float(y), hollow) for name, x, y, hollow in page.execute_script("""
        return [...document.querySelectorAll(`#${arguments[0]} .mark`)].map(mark => [
          mark.dataset.variant, mark.dataset.x, mark.dataset.y,
          mark.classList.contains("hollow")]);""", plot)]


def choose(page, control, value):
    Select(page.find_element(By.ID, control)).select_by_visible_text(value)


def header(page, column):
    return page.find_element(By.ID, f"by-{column}")


def test_the_table_has_a_row_for_each_entry_with_its_numbers(page):
    result = rows(page)
    assert list(result) == [variant(entry) for entry in REPORT.entries]
    assert page.find_element(By.ID, "shown").text == f"{len(result)} of {len(result)} kernels"
    for entry in REPORT.entries:
        cells = result[variant(entry)]
        for inputs, errors in (("hard", entry.hard), ("benign", entry.benign)):
            for name in ("worst", "p999", "median"):
                wanted = getattr(errors, name) if errors else math.nan
                assert same(float(cells[f"{inputs}-{name}"][0]), wanted), (variant(entry), name)
        assert same(float(cells["ns"][0]), ns(entry, SHOWN_FIRST))
        time = next((t for t in entry.times if layout_name(t) == SHOWN_FIRST), None)
        assert cells["interval"][1] == (
            f"{formatted(time.low)}–{formatted(time.high)}" if time else "–")
        assert cells["ratio"][1] == ("–" if not time or time.ratio is None else (
            f"{formatted(time.ratio)} × ({formatted(time.ratio_low)}–"
            f"{formatted(time.ratio_high)})"))
        assert same(float(cells["ratio-to-bound"][0]),
                    entry.bound.worst_ratio if entry.bound else math.nan)
        assert int(cells["flops"][0]) == entry.flops


def test_awkward_numbers_are_shown_as_what_they_are(page):
    result = rows(page)
    assert result["vec3_l2norm double plain"]["hard-worst"][1] == "∞ u"
    assert result["vec3_copy double plain"]["hard-worst"][1] == "0"
    assert result["dc single plain"]["hard-worst"][1] == "–"
    assert result["dc single plain"]["ns"][1] == "–"
    assert result["product_CoAdc double plain"]["hard-worst"][1] == "3.25e15"


def test_awkward_text_is_shown_as_it_is(page):
    text = page.find_element(By.TAG_NAME, "body").text
    assert "made-up machine </script><script>alert(1)</script> <b> & \"ω~\" 'τ' | `x`" in text
    assert f"co = {'product_CoAdc'} </script>" in page.find_element(By.ID, "statement").text
    assert "Changes since before </script>" in text


@pytest.mark.parametrize("key", (None, Keys.ENTER, Keys.SPACE))
@pytest.mark.parametrize("column, value", (
    ("hard-worst", lambda e: e.hard.worst), ("ns", lambda e: ns(e, SHOWN_FIRST)),
    ("flops", lambda e: e.flops), ("operation", lambda e: e.operation)))
def test_a_heading_sorts_up_then_down_by_mouse_and_by_key(page, column, value, key):
    button = header(page, column).find_element(By.TAG_NAME, "button")
    values = {variant(entry): value(entry) for entry in REPORT.entries}
    missing = [name for name, x in values.items() if not isinstance(x, str) and math.isnan(x)]
    for order, reverse in (("ascending", False), ("descending", True)):
        button.send_keys(key) if key else button.click()
        assert header(page, column).get_attribute("aria-sort") == order
        results = list(rows(page))
        kept = results[:len(results) - len(missing)]
        assert [values[name] for name in kept] == sorted(map(values.get, kept), reverse=reverse)
        assert sorted(results[len(kept):]) == sorted(missing)  # last in both orders
    assert page.execute_script(
        "return document.querySelectorAll('[aria-sort=ascending],[aria-sort=descending]').length"
    ) == 1


def test_the_filter_keeps_rows_with_all_its_words(page):
    page.find_element(By.ID, "text").send_keys("CROSS_SC accurate")
    assert list(rows(page)) == ["cross_sc double accurate", "cross_sc single accurate"]
    page.find_element(By.ID, "text").send_keys(" nowhere")
    assert rows(page) == {}
    assert page.find_element(By.ID, "shown").text.startswith("0 of ")


def test_precision_and_tier_choose_rows_and_marks(page):
    choose(page, "precision", "single")
    choose(page, "tier", "certified")
    assert list(rows(page)) == ["product_CoAdc single certified", "cross_sc single certified"]
    assert [name for name, *_ in marks(page, "pareto-plot")] == [
        "product_CoAdc single certified"]


@pytest.mark.parametrize("layout", LAYOUTS)
@pytest.mark.parametrize("inputs", ("hard", "benign"))
def test_plot_and_table_hold_the_same_numbers(page, layout, inputs):
    choose(page, "layout", layout)
    choose(page, "inputs", inputs)
    result = rows(page)
    for operation in ("product_CoAdc", "cross_sc"):
        choose(page, "operation", operation)
        entries = {variant(e): e for e in REPORT.entries if e.operation == operation}
        drawn = marks(page, "pareto-plot")
        assert sorted(name for name, *_ in drawn) == sorted(entries)
        for name, x, y, hollow in drawn:
            assert (str(x), y) == (str(float(result[name]["ns"][0])),
                                   float(result[name][f"{inputs}-worst"][0]))
            assert (x, y) == (ns(entries[name], layout), getattr(entries[name], inputs).worst)
            assert hollow == (result[name]["pareto"][1] == "○ dominated") == (
                "certified" in name)
        whiskers = page.execute_script("""
            return [...document.querySelectorAll("#pareto-plot .interval")].map(line =>
              [line.dataset.variant, line.dataset.low, line.dataset.high]);""")
        assert sorted((name, float(low), float(high)) for name, low, high in whiskers) == sorted(
            (variant(e), t.low, t.high) for e in entries.values() for t in e.times
            if layout_name(t) == layout)


def test_the_headline_plots_hold_each_variant_once(page):
    wanted = [variant(e) for e in REPORT.entries if e.operation in ("product_CoAdc", "cross_sc")]
    assert sorted(name for name, *_ in marks(page, "headline-plots")) == sorted(wanted)


def test_marks_stand_where_their_values_are(page):
    """More error is higher, more time further right."""
    places = page.execute_script("""
        return [...document.querySelectorAll("#pareto-plot .mark")].map(mark => {
          const box = mark.getBoundingClientRect();
          return [mark.dataset.x, box.x + box.width / 2, mark.dataset.y, box.y + box.height / 2];
        });""")
    for x, across, y, down in places:
        for other_x, other_across, other_y, other_down in places:
            if float(x) < float(other_x):
                assert across < other_across
            if float(y) > float(other_y):
                assert down < other_down


def test_errors_lie_below_their_bound_s_line(page):
    drawn = marks(page, "condition-plot")
    wanted = [(variant(e), x, y) for e in REPORT.entries if e.operation == "product_CoAdc"
              for x, y in e.condition]
    assert sorted((name, x, y) for name, x, y, _ in drawn) == sorted(wanted)
    lines = page.find_elements(By.CSS_SELECTOR, "#condition-plot .bound")
    assert len(lines) == sum(e.operation == "product_CoAdc" for e in REPORT.entries)
    bound = page.execute_script(
        "return report.entries.filter(e => e.operation === 'cross_sc').map(e => boundAt(e, 1000))")
    u = {"double": 2.0**-53, "single": 2.0**-24}
    assert bound == [1 + (e.bound.c1 + e.bound.c2 * u[e.precision]) * 1000
                     for e in REPORT.entries if e.operation == "cross_sc"]


def test_bounds_are_shown_by_their_constants(page):
    result = rows(page)
    assert result["cross_sc double plain"]["bound"][1] == "u |x̂| + 5 u S"
    assert result["cross_sc single accurate"]["bound"][1] == "u |x̂| + 4 u S + 3 u² S"
    assert result["vec3_copy double plain"]["bound"][1] == "exact"
    assert result["vec3_l2norm double plain"]["bound"][1] == "–"


def test_missing_zero_and_infinite_figures_are_drawn_or_left_out(page):
    for operation, wanted in (("vec3_copy", [0.0]), ("vec3_l2norm", [math.inf]), ("dc", [])):
        choose(page, "operation", operation)
        assert [y for _, _, y, _ in marks(page, "pareto-plot")] == wanted
        assert "NaN" not in page.find_element(By.ID, "operation-section").get_attribute("outerHTML")


def test_an_operation_s_name_in_the_table_shows_it(page):
    page.find_element(By.ID, "text").send_keys("cross_sc double plain")
    page.find_element(By.CSS_SELECTOR, "#table-body th button").send_keys(Keys.ENTER)
    assert page.find_element(By.ID, "operation").get_attribute("value") == "cross_sc"
    assert {name.split()[0] for name, *_ in marks(page, "pareto-plot")} == {"cross_sc"}
    for summary in page.find_elements(By.CSS_SELECTOR, "#operation-section summary"):
        summary.click()
    text = page.find_element(By.ID, "witnesses").text
    assert text.count("0x1.8p+0 -0x1.23456789abcdep-1022") == 12
    assert page.find_element(By.ID, "times").text.count("gcc") == 3


def test_drift_and_changes_are_in_tables(page):
    cells = [cell.text for cell in page.find_elements(By.CSS_SELECTOR, "#drift tbody tr > *")]
    assert cells == ["double", "no", "1000", "12.5", "101", "20.5 (20.3–21)",
                     "single", "yes", "1000000", "1.5", "∞", "30.3 (30–30.5)"]
    cells = [cell.text for cell in page.find_elements(By.CSS_SELECTOR, "#compare tbody tr > *")]
    assert cells[:7] == ["cross_sc", "single", "plain", "worst error, hard, ulp", "4", "1",
                         "0.25 ×"]
    assert cells[7:10] + cells[11:] == ["product_CoAdc", "double", "plain", "2", "3", "1.5 ×"]


def test_the_page_asks_the_network_for_nothing_and_logs_nothing(page, folder):
    choose(page, "operation", "cross_sc")
    header(page, "ns").find_element(By.TAG_NAME, "button").click()
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
    table = page.find_element(By.CSS_SELECTOR, "#kernels .scroll")
    if phone:  # the table is wider and scrolls inside
        assert table.get_property("scrollWidth") > table.get_property("clientWidth")


@pytest.mark.parametrize("scheme", ("light", "dark"))
def test_text_stands_out_from_its_ground(page, scheme):
    """WCAG 2.2's contrast of at least 4.5, for text, links and notes."""
    page.execute_cdp_cmd("Emulation.setEmulatedMedia", {
        "features": [{"name": "prefers-color-scheme", "value": scheme}]})
    colours = page.execute_script("""
        const style = getComputedStyle(document.documentElement);
        return Object.fromEntries(["paper", "card", "wash", "ink", "quiet", "accent", "warn"].map(
          name => [name, style.getPropertyValue(`--${name}`).trim()]));""")
    for text in ("ink", "quiet", "accent", "warn"):
        for ground in ("paper", "card", "wash"):
            light, dark = sorted((_luminance(colours[text]), _luminance(colours[ground])))[::-1]
            assert (light + 0.05) / (dark + 0.05) >= 4.5, (scheme, text, ground)


def _luminance(colour):
    parts = [int(colour[i:i + 2], 16) / 255 for i in (1, 3, 5)]
    linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in parts]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def test_every_control_has_a_name(page):
    unnamed = page.execute_script("""
        return [...document.querySelectorAll("select, input, button, [role=img], [role=region]")]
          .filter(e => !(e.labels?.length || e.innerText?.trim() || e.getAttribute("aria-label") ||
                         document.getElementById(e.getAttribute("aria-labelledby"))))
          .map(e => e.outerHTML);""")
    assert unnamed == []
