"""Shared parts of all pages: figures in their colours, with ids of their own; tables; escaping."""

import re
from xml.etree import ElementTree

import pytest
from markdown_it import MarkdownIt
from matplotlib.figure import Figure

from coscrew_codegen.backends.html.pages import Table
from coscrew_codegen.backends.html.plots import LINES, THEME, inline, logarithmic, styled

LONG = "final spring_damper.front_left_knee_actuator_with_a_long_name.torque [N m]"
AWKWARD = "</script><b> & `x` *y* | [z](w) ~a~ \\"


@styled
def drawn(title: str = "title", label: str = "label") -> Figure:
    figure = Figure(figsize=(3.3, 2.7), layout="constrained")
    axes = figure.add_subplot(title=title, xlabel=label, ylabel=label)
    for n, _ in enumerate(LINES):
        axes.plot([1, 2], [n, n + 1], "o-", gid=f"line {n}")
    return figure


@pytest.mark.parametrize("text", ("short", LONG, "x" * 80))
def test_titles_and_labels_end_inside_their_figure(text):
    figure = drawn(text, text)
    inline(figure, "long")
    figure.draw_without_rendering()
    (axes,) = figure.axes
    shown = [x for x in (axes.xaxis.label, axes.yaxis.label, *axes.get_children())
             if hasattr(x, "get_fontsize") and x.get_text()]
    assert [x.get_text() for x in shown] == [text] * 3
    for x in shown:
        box = x.get_window_extent()
        assert min(box.x0, box.y0) > -2 and box.x1 < figure.bbox.x1 + 2, x
        assert box.y1 < figure.bbox.y1 + 2, x


def test_all_colours_of_a_figure_follow_the_theme():
    text = inline(drawn(), "colours")
    assert not re.findall(r"(?<!, )#[0-9a-f]{6}\b", text)
    names = set(re.findall(r"var\(--([0-9a-f]{6}), #\1\)", text))
    assert names == {light[1:] for light, _ in LINES} <= {light[1:] for light, _ in THEME}


def test_ids_of_two_figures_in_a_page_differ():
    results = []
    for label in ("one", "two & <three>"):
        root = ElementTree.fromstring(inline(drawn(), label, {"line 1": AWKWARD}))
        assert root.get("aria-label") == label
        results.append({x.get("id") for x in root.iter() if x.get("id")})
        used = {value.strip("#") for x in root.iter() for name, value in x.attrib.items()
                if name.endswith("href")}
        assert used and used <= results[-1]
        (mark,) = (x for x in root.iter() if x.get("data-mark"))
        assert [x.text for x in mark if x.tag.endswith("title")] == [AWKWARD]
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
    table = Table(("what", "n"), ((AWKWARD, "1"), ("two\nlines", "12")), ("above",), ("below",))
    tokens = MarkdownIt("commonmark", {"html": True}).enable("table").parse(table.markdown())
    cells = ["".join(child.content for child in x.children) for x in tokens if x.type == "inline"]
    assert cells == ["what", "n", AWKWARD, "1", "two lines", "12"]
    lines = table.text().splitlines()
    assert (lines[0], lines[-1]) == ("above", "below")
    assert lines[1].endswith("  n") and lines[3].endswith("  1")
