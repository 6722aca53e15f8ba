"""Benchmarks end with one table of bars; the compared functions are equal."""

import re
import subprocess
import sys
from fractions import Fraction
from importlib import import_module
from importlib.util import find_spec
from types import SimpleNamespace

import numpy as np
import pytest

from coscrew_codegen.reports.timing.intervals import Interval
from tests.benchmarks import bars, gufuncs, pinocchio_loops
from tests.benchmarks.__main__ import NAMES, ROOT
from tests.benchmarks.bars import MET, MISSED, UNCLEAR, UNMEASURED, Bar
from tests.support.scenes.robots import model_of, path_of


@pytest.mark.parametrize("low, high, most, met", (
    (5, 6, False, MET), (5.1, 6, False, MET), (4.9, 5.1, False, UNCLEAR), (4, 4.9, False, MISSED),
    (4, 5, False, UNCLEAR), (4, 5, True, MET), (4.9, 5.1, True, UNCLEAR), (5.1, 6, True, MISSED),
    (5, 6, True, UNCLEAR)))
def test_a_bar_is_met_if_its_whole_interval_is(low, high, most, met):
    bar = Bar("ours", 5, Interval((low + high) / 2, low, high), most)
    assert bar.met == met
    assert bar.row[1] == ("≤ 5" if most else "≥ 5")


def test_a_bar_without_a_rival_tells_the_reason():
    bar = Bar("rival / ours", 30, note="no rival: pip install rival")
    assert bar.row == ("rival / ours", "≥ 30", "no rival: pip install rival", UNMEASURED)


def test_of_each_bar_that_of_our_least_time_is_shown():
    slow, fast, other = (Bar(what, 1, note=note) for what, note in
                         (("a", "gcc"), ("a", "clang"), ("b", "gcc")))
    assert bars.fastest([(2.0, slow), (1.0, fast), (3.0, other)]) == [fast, other]


def test_the_table_is_written_with_machine_and_count(tmp_path, monkeypatch):
    monkeypatch.setattr(bars, "FILE", tmp_path / "build" / "benchmarks.md")
    bars.write([Bar("a", 2, Interval(3, 2.5, 3.5), note="gcc"), Bar("b", 2, Interval(1, 1, 1))])
    text = bars.FILE.read_text()
    assert "| a      | ≥ 2      | 3 (2.5–3.5), gcc" in text and "load of " in text
    assert text.endswith("\n\n1 met, 1 missed\n")


@pytest.mark.parametrize("name", NAMES)
def test_every_benchmark_runs_alone(name):
    assert 'if __name__ == "__main__":' in (ROOT / "tests/benchmarks" / f"{name}.py").read_text()
    assert find_spec(f"tests.benchmarks.{name}")


@pytest.mark.parametrize("dtype", ("float64", "float32"))
def test_what_is_timed_of_gufuncs_is_refused_by_none(dtype):
    for cases in gufuncs._cases(dtype).values():
        for _, call in cases:
            assert np.isfinite(call()).all()


def test_an_unknown_benchmark_is_refused():
    done = subprocess.run([sys.executable, "-m", "tests.benchmarks", "dynamics", "many_state"],
                          cwd=ROOT, capture_output=True, text=True)
    assert done.returncode == 2
    assert "no benchmark many_state; there are header_kernels, " in done.stderr


def test_loops_of_pinocchio_know_the_joints_of_their_robots():
    """The kinds that pinocchio_model.h numbers, in its order."""
    text = pinocchio_loops.HEADER.read_text()
    assert tuple(re.findall(r"return pinocchio::(JointModel\w+)\(\)", text)) \
        == pinocchio_loops.KINDS
    for name in pinocchio_loops.ROBOTS:
        model = pinocchio_loops.pinocchio_model(name)
        assert {x.shortname() for x in list(model.joints)[1:]} <= set(pinocchio_loops.KINDS)


def test_a_panda_with_fixed_fingers_is_pinocchios_with_locked_ones():
    """Both libraries' models have the masses of the file."""
    model = pinocchio_loops.pinocchio_model("panda7")
    whole = model_of(*pinocchio_loops.ROBOTS["panda7"])
    assert (model.nv, whole.nv) == (7, 9)
    text = path_of(pinocchio_loops.ROBOTS["panda7"][0]).read_text()
    masses = [Fraction(x) for x in re.findall(r'<mass value="([^"]+)"', text)]
    scene = pinocchio_loops.scene_named("panda7")
    assert sum(x.inertia.mass for x in scene.model.bodies if x.inertia) == sum(masses)
    assert abs(sum(x.mass for x in model.inertias) / float(sum(masses)) - 1) < 1e-15


@pytest.mark.parametrize("factor, refused", ((1, False), (1 + 1e-13, False), (1 + 1e-11, True),
                                             (float("nan"), True)))
def test_times_of_other_results_are_refused(factor, refused):
    values = np.random.default_rng(0).normal(size=(5, 7))
    rival = SimpleNamespace(values=lambda name: values,
                            robot=SimpleNamespace(functions=SimpleNamespace(name="arm")))
    result = values.copy()
    result[3] *= factor
    if refused:
        with pytest.raises(ValueError, match="of arm: our results and those of Simple"):
            pinocchio_loops.refuse_others([result], rival, "inverse_dynamics")
    else:
        pinocchio_loops.refuse_others([result], rival, "inverse_dynamics")


def test_frax_is_compared_too():
    module = import_module("tests.benchmarks.arrays_on_a_core")
    own = np.ones((module.STATES, 2))
    module.compare("mass_matrix", own, own)
    with pytest.raises(ValueError, match="mass_matrix: frax's results differ from ours by 1.0e-08"):
        module.compare("mass_matrix", own + 1e-8, own)


def test_what_a_rival_lacks_is_told(monkeypatch):
    assert pinocchio_loops.library("no-such-clang") == (None, "no no-such-clang")
    monkeypatch.setattr(pinocchio_loops, "EIGEN", ())
    result, missing = pinocchio_loops.library("cc")
    assert result is None and missing.startswith("no Eigen: pip install cmeel-eigen")
