"""The table and the figure of how certified bounds are calibrated."""

import sys
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest

from coscrew_codegen.program.values.formats import DOUBLE, PRECISIONS
from tests.benchmarks import certified_scenes
from tests.benchmarks.calibration import Calibration, figure
from tests.support.truth.wide import IS_WIDE


def test_curves_are_parts_of_the_outputs():
    """Two of the four are at most 1.01."""
    result = Calibration("arm", "mass_matrix", DOUBLE, np.array([1, 1.001, 1.1, 3]))
    assert [result.percent(x) for x in (1, 1.01, 2, 3)] == [25, 50, 75, 100]
    line, = (x for x in figure([result]).axes[0].lines if x.get_gid() == "arm mass_matrix double")
    x, y = line.get_data()
    assert y[0] == 25 and y[-1] == 100 and 1 + x[-1] >= 3
    assert np.interp(0.01, x, y) == 50


@pytest.mark.skipif(not IS_WIDE, reason="numbers of 113 bits are libquadmath's, of x86")
def test_the_command_draws_each_function_and_precision(tmp_path: Path, monkeypatch, capsys):
    path = tmp_path / "calibration.svg"
    monkeypatch.setattr(sys, "argv", ["", *f"--robot ur5 --calibration --outputs 72 --plot {path}"
                                      .split()])
    certified_scenes.main()
    ids = {x.get("id") for x in ElementTree.parse(path).getroot().iter()}
    names = {f"ur5 {name} {p.name}" for name in certified_scenes.FUNCTIONS for p in PRECISIONS}
    assert names <= ids
    rows = capsys.readouterr().out.splitlines()[2:]
    assert {" ".join(x.split()[:3]) for x in rows} == names
