"""Shared parts of all pages: figures in their colours, with ids of their own; tables; escaping."""

import re
from xml.etree import ElementTree

import pytest
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from coscrew_codegen.backends.html.pages import Table
from coscrew_codegen.backends.html.plots import LINES, Panel, logarithmic
from tests.support.browser import chromium

LONG = "final spring_damper.front_left_knee_actuator_with_a_long_name.torque [N m]"
AWKWARD = "</script><b> & `x` *y* | [z](w) ~a~ \\"


def panel(title: str = "title", label: str = "label", mark: str = "_", name: str = "panel"
          ) -> Panel:
    def draw(axes: Axes) -> None:
        axes.set(title=title, xlabel=label, ylabel=label)
        for n, _ in enumerate(LINES):
            axes.plot([1, 2], [n, n + 1], "o-", gid=f"line {n}", label=mark if n == 1 else "_")

    return Panel(name, draw)


@pytest.mark.parametrize("text", ("short", LONG, "x" * 80))
def test_titles_and_labels_end_inside_their_figure(text, tmp_path):
    """In a browser: all letters are inside of the drawing."""
    (tmp_path / "page.html").write_text(f"<!DOCTYPE html>{panel(text, text).inline}")
    with chromium() as browser:
        browser.get((tmp_path / "page.html").as_uri())
        outer, *inner = browser.execute_script("""
            return [...document.querySelectorAll("svg, text")].map(x => {
              const box = x.getBoundingClientRect();
              return [x.textContent, box.left, box.top, box.right, box.bottom]; });""")
    shown = [box for words, *box in inner if words == text]
    assert len(shown) == 3
    for left, top, right, bottom in shown:
        assert left > outer[1] and top > outer[2] and right < outer[3] and bottom < outer[4]


def test_all_colours_of_a_figure_follow_the_theme():
    text = panel().inline
    assert not re.findall(r"(?<!light-dark\()(?<!, )#[0-9a-f]{6}\b", text)
    assert set(re.findall(r"light-dark\((#[0-9a-f]{6}), (#[0-9a-f]{6})\)", text)) == {*LINES}


def test_ids_of_two_figures_in_a_page_differ():
    results = []
    for label in ("one", "two & <three>"):
        root = ElementTree.fromstring(panel(mark=AWKWARD, name=label).inline)
        assert root.get("aria-label") == label
        results.append({x.get("id") for x in root.iter() if x.get("id")})
        used = {value.strip("#") for x in root.iter() for name, value in x.attrib.items()
                if name.endswith("href")}
        assert used and used <= results[-1]
        titles = {x.get("data-artist"): [y.text for y in x if y.tag.endswith("title")]
                  for x in root.iter() if x.get("data-artist")}
        assert titles == {f"line {n}": [AWKWARD] if n == 1 else [] for n, _ in enumerate(LINES)}
    assert not results[0] & results[1]


@pytest.mark.parametrize("low, high, texts", (
    (5, 60, ["5", "10", "20", "50"]),
    (1e-9, 5e-8, ["1e-9", "2e-9", "5e-9", "1e-8", "2e-8", "5e-8"]),
    (1, 1e4, ["1", "10", "100", "1000", "10000"]),
    (0.1, 1e7, ["1e-1", "1e1", "1e3", "1e5", "1e7"])))
def test_ticks_of_logarithmic_axes_are_round_and_alike(low, high, texts):
    figure = Figure(figsize=(3.3, 2.7))
    axes = figure.subplots()
    axes.set_xlim(low, high)
    logarithmic(axes.xaxis)
    assert [x.get_text() for x in axes.get_xticklabels()
            if low <= x.get_position()[0] <= 1.001 * high] == texts


def test_cells_are_read_back_as_they_were():
    table = Table(("what", "n"), ((AWKWARD, "1"), ("two\nlines", "12")), ("below",))
    lines = table.text().splitlines()
    assert lines[0].endswith("  n") and lines[2].endswith("  1") and lines[-1] == "below"
    html = ElementTree.fromstring(table.html())
    assert [x.text for x in html.iter() if x.tag in ("th", "td")] == [
        "what", "n", AWKWARD, "1", "two\nlines", "12"]
