"""The report's Markdown and figures, read by parsers."""

import math
import os
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree

import pytest
from markdown_it import MarkdownIt

from coscrew_codegen.backends.emit import EmitError
from coscrew_codegen.reports.kernels.pages.overview import formatted
from coscrew_codegen.reports.kernels.pages.report_page import write
from tests.support.sample_report import SHOWN_FIRST, layout_name, same, sample_report, variant

REPORT = sample_report()


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    folder = tmp_path_factory.mktemp("report")
    write(REPORT, folder)
    return folder


def markdown_rows(text):
    """The cells of all rows of all tables, as a Markdown reader sees them."""
    result, row = [], None
    for token in MarkdownIt("commonmark", {"html": True}).enable("table").parse(text):
        if token.type == "tr_open":
            row = []
        elif token.type == "inline" and row is not None:
            row.append("".join(child.content for child in token.children))
        elif token.type == "tr_close":
            result, row = [*result, row], None
    return result


def shown(x):
    """The number that a cell shows."""
    text = x.split()[0]
    return {"–": math.nan, "∞": math.inf}.get(text) if text in "–∞" else float(text)


def test_markdown_says_the_same_numbers(folder):
    by_kernel = {" ".join(row[:3]): row
                 for row in markdown_rows((folder / "report.md").read_text()) if len(row) == 10}
    for entry in REPORT.entries:
        row = by_kernel[variant(entry)]
        time = next((t for t in entry.times if layout_name(t) == SHOWN_FIRST), None)
        wanted = (entry.benign and entry.benign.worst, entry.hard and entry.hard.worst,
                  entry.bound and entry.bound.worst_ratio, entry.flops, time and time.ns,
                  time and time.ratio)
        for cell, value in zip(row[3:9], wanted, strict=True):
            value = math.nan if value is None else value
            assert same(shown(cell), value) or math.isclose(shown(cell), value, rel_tol=0.005), row
        for cell, ends in zip(row[7:9], ((time.low, time.high), (time.ratio_low, time.ratio_high))
                              if time else (), strict=False):
            assert cell.endswith("({}–{})".format(*map(formatted, ends))) or cell == "–", row
        assert row[9] == ("–" if not time else
                          "○ dominated" if time.dominated else "● undominated")


def test_markdown_shows_awkward_text_as_it_is(folder):
    rows = markdown_rows((folder / "report.md").read_text())
    assert all(len(row) in (2, 6, 7, 10) for row in rows)
    command = next(row[1] for row in rows if row[0] == "command")
    assert "</script><script>alert(1)</script> <b> & \"ω~\" 'τ' | `x` *y* <!--" in command
    assert "<script" not in (folder / "report.md").read_text()


def test_figures_are_whole_and_hold_a_mark_for_each_variant(folder):
    names = sorted(path.name for path in folder.glob("*.svg"))
    assert names == ["condition-cross_sc.svg", "condition-product_CoAdc.svg", "headline.svg",
                     "pareto-cross_sc.svg", "pareto-product_CoAdc.svg"]
    for path in folder.glob("*.svg"):
        ids = [element.get("id") for element in ElementTree.parse(path).iter()]
        operations = {"headline.svg": ("product_CoAdc", "cross_sc")}.get(
            path.name, (path.stem.removeprefix("pareto-"),))
        wanted = [variant(e) for e in REPORT.entries
                  if e.operation in operations]
        for end in ("", " interval"):
            assert sorted(name for name in ids if name in {f"{x}{end}" for x in wanted}) == (
                [] if "condition" in path.name else sorted(f"{x}{end}" for x in wanted))


def test_operations_have_figures_on_demand(tmp_path):
    written = write(REPORT, tmp_path / "new" / "folder", ("vec3_l2norm", "dc", "vec3_copy"))
    assert all(path.stat().st_size > 1000 for path in written)
    assert sorted(path.name for path in written if path.suffix == ".svg") == [
        "condition-vec3_copy.svg", "headline.svg", "pareto-dc.svg", "pareto-vec3_copy.svg",
        "pareto-vec3_l2norm.svg"]


def test_all_files_are_the_same_bytes_in_another_process(folder, tmp_path):
    program = ("import sys; from pathlib import Path;"
               "from coscrew_codegen.reports.kernels.pages.report_page import write;"
               "from tests.support.sample_report import sample_report;"
               "write(sample_report(), Path(sys.argv[1]))")
    subprocess.run([sys.executable, "-c", program, str(tmp_path)], check=True,
                   cwd=Path(__file__).parents[2], env={**os.environ, "PYTHONHASHSEED": "7"})
    for path in folder.iterdir():
        assert (tmp_path / path.name).read_bytes() == path.read_bytes(), path.name


def test_what_cannot_be_written_is_refused_and_nothing_changes(tmp_path):
    (tmp_path / "report.md").mkdir()
    with pytest.raises(EmitError, match="report.md: it is a folder; nothing was changed"):
        write(REPORT, tmp_path)
    assert [path.name for path in tmp_path.iterdir()] == ["report.md"]
