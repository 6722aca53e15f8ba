"""The report's figures, read by a parser; its files, whole or not at all."""

import os
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree

import pytest

from coscrew_codegen.backends.emit import EmitError
from coscrew_codegen.reports.kernels.report_page import write
from tests.support.sample_report import sample_report, variant

REPORT = sample_report()


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    folder = tmp_path_factory.mktemp("report")
    write(REPORT, folder)
    return folder


def test_figures_are_whole_and_hold_a_mark_for_each_variant(folder):
    names = sorted(path.name for path in folder.glob("*.svg"))
    precisions, operations = ("double", "single"), ("cross_sc", "product_CoAdc")
    assert names == [
        *(f"error-of-{x.lower()}-against-condition.svg" for x in operations),
        *(f"time-against-worst-error-of-{x.lower()}.svg" for x in operations),
        *(f"what-accuracy-costs-in-{x}-precision.svg" for x in precisions)]
    for path in folder.glob("*.svg"):
        ids = [element.get("id") for element in ElementTree.parse(path).iter()]
        wanted = [variant(e) for e in REPORT.entries if e.operation in operations
                  and (e.operation.lower() in path.stem or e.precision in path.stem)]
        for end in ("", " interval") if "condition" not in path.name else ("",):
            assert sorted(name for name in ids if name in {f"{x}{end}" for x in wanted}) == sorted(
                f"{x}{end}" for x in wanted)


def test_operations_have_figures_on_demand(tmp_path):
    written = write(REPORT, tmp_path / "new" / "folder", ("vec3_l2norm", "dc", "vec3_copy"))
    assert all(path.stat().st_size > 1000 for path in written)
    assert sorted(path.stem for path in written if path.suffix == ".svg") == [
        "error-of-vec3_copy-against-condition", "time-against-worst-error-of-dc",
        "time-against-worst-error-of-vec3_copy", "time-against-worst-error-of-vec3_l2norm",
        "what-accuracy-costs-in-double-precision", "what-accuracy-costs-in-single-precision"]


def test_all_files_are_the_same_bytes_in_another_process(folder, tmp_path):
    program = ("import sys; from pathlib import Path;"
               "from coscrew_codegen.reports.kernels.report_page import write;"
               "from tests.support.sample_report import sample_report;"
               "write(sample_report(), Path(sys.argv[1]))")
    subprocess.run([sys.executable, "-c", program, str(tmp_path)], check=True,
                   cwd=Path(__file__).parents[2], env={**os.environ, "PYTHONHASHSEED": "7"})
    for path in folder.iterdir():
        assert (tmp_path / path.name).read_bytes() == path.read_bytes(), path.name


def test_what_cannot_be_written_is_refused_and_nothing_changes(tmp_path):
    (tmp_path / "report.html").mkdir()
    with pytest.raises(EmitError, match="report.html: it is a folder; nothing was changed"):
        write(REPORT, tmp_path)
    assert [path.name for path in tmp_path.iterdir()] == ["report.html"]
