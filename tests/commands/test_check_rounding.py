"""coscrew check says what rounding takes, and holds certified bounds against the errors."""

import math
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import mpmath
import numpy as np
import pytest
from gmpy2 import mpfr
from mpmath import mpf

from coscrew_codegen.__main__ import main
from coscrew_codegen.program.multiprecise import precise
from coscrew_codegen.program.scene_functions import SceneFunctions
from coscrew_codegen.program.values.formats import BY_NAME
from coscrew_codegen.runtime.load import Kernels
from coscrew_codegen.simulation.check import check_report, check_rounding
from coscrew_codegen.simulation.check.check_rounding import (
    DIGITS,
    STATES,
    Certified,
    RoundedResults,
    rounding,
)
from coscrew_codegen.simulation.plan import Trajectory
from coscrew_codegen.simulation.system import System, system
from tests.support.scenes import scene_texts as texts
from tests.support.scenes.selecting import checked

SWING = """name = "swing"
precision = "both"
[bodies.bob]
mass = 0.1
com = [0, 0.01, -0.3]
inertia = [0.02, 0.03, 0.04]
[joints.hinge]
type = "revolute"
child = "bob"
axis = [0, 1, 0]
[start.q]
hinge = 1.1
[effects.gravity]
[run]
duration = 0.1
step = 0.01
"""


CART = """name = "cart"
[bodies.cart]
mass = 1000.3
inertia = [1, 1, 1]
[bodies.bob]
mass = 0.1
com = [0, 0, -0.3]
inertia = [0.02, 0.03, 0.04]
[joints.rail]
type = "prismatic"
child = "cart"
axis = [1, 0, 0]
[joints.hinge]
type = "revolute"
parent = "cart"
child = "bob"
axis = [0, 1, 0]
[effects.gravity]
"""


@pytest.fixture(scope="module")
def path(tmp_path_factory: pytest.TempPathFactory) -> Path:
    made = tmp_path_factory.mktemp("swing") / "swing.toml"
    made.write_text(SWING)
    return made


@pytest.fixture(scope="module")
def kernels(path: Path) -> Kernels:
    return checked(path)


def runs(kernels: Kernels) -> Iterator[tuple[System, Trajectory]]:
    """Runs with as many states as are judged, in both precisions."""
    draw = np.random.default_rng(3)
    q, v = draw.uniform(-3, 3, (2, STATES, 1))
    for name in BY_NAME:
        its = system(kernels, name)
        yield its, Trajectory(np.arange(STATES) / 8, q.astype(its.dtype), v.astype(its.dtype), 0, 0)


def torque(q: mpf, a: mpf) -> mpf:
    """I a + m g l sin q, I about the hinge."""
    mass, length, g = mpf("0.1"), mpf("0.3"), mpf("9.81")
    return (mpf("0.03") + mass * length**2) * a + mass * g * length * mpmath.sin(q)


def test_errors_are_those_against_the_closed_form(kernels: Kernels):
    results = {(x.function, x.precision): x for x in rounding(kernels, [*runs(kernels)])}
    assert len(results) == 4
    for its, trajectory in runs(kernels):
        a = check_rounding._states(its, trajectory)["a"]
        tau = its.call("inverse_dynamics", q=trajectory.q, v=trajectory.v, a=a)
        with mpmath.workdps(50):
            true = [torque(*(mpf(float(x[0])) for x in row))
                    for row in zip(trajectory.q, a, strict=True)]
            errors = [float(abs(mpf(float(x[0])) - y)) for x, y in zip(tau, true, strict=True)]
        rounded, at = results["inverse_dynamics", its.precision.name], int(np.argmax(errors))
        assert (rounded.error, rounded.at, rounded.states) == (errors[at], trajectory.t[at], STATES)
        assert rounded.digits == pytest.approx(math.log10(abs(true[at]) / errors[at]), abs=1e-9)
        assert rounded.certified and rounded.certified.stated == rounded.certified.of == STATES
        assert rounded.certified.broken is None
        assert rounded.certified.ratio and 1 <= rounded.certified.ratio < 1.5
    for x in results.values():
        own = -math.log10(BY_NAME[x.precision].u)
        assert x.lost == max(0, own - x.digits) < 2


def test_units_are_told_apart(tmp_path: Path):
    """A cart of a tonne on a rail, and a pendulum of 0.1 kg on it."""
    path = tmp_path / "cart.toml"
    path.write_text(CART)
    kernels = checked(path)
    its, ones = system(kernels, "double"), np.ones((2, 2))
    rows = rounding(kernels, [(its, Trajectory(np.arange(2) / 8, 0.3 * ones, 0.7 * ones, 0, 0))])
    assert [(x.function, x.unit) for x in rows] == [
        ("inverse_dynamics", "N"), ("inverse_dynamics", "N m"),
        ("forward_dynamics", "m/s^2"), ("forward_dynamics", "rad/s^2")]
    assert all(x.certified and x.certified.of == 2 and not x.certified.broken for x in rows)
    force, torque, *_ = rows
    assert force.error > 100 * torque.error > 0


def test_the_command_says_so(path: Path, capsys: pytest.CaptureFixture[str]):
    assert main(["check", str(path)]) == 0
    out = capsys.readouterr().out
    assert out.count("all hold, 1.0") == 4
    assert "digits right    digits lost" in out


def test_exact_results_and_wide_bounds_are_called_so(kernels: Kernels):
    """Errors of 1e-45 are those of 50 digits: they are not compared with the bounds."""
    its, trajectory = next(runs(kernels))
    values = check_rounding._states(its, trajectory)
    tau = its.call("inverse_dynamics", **{x: values[x] for x in "qva"})

    def held(error: float, bound: float) -> Certified:
        stub = SimpleNamespace(double=SimpleNamespace(
            inverse_dynamics=lambda *_: (tau, np.full_like(tau, bound))))
        with precise(DIGITS):
            truth = [[mpfr(float(x)) + mpfr(error) for x in row] for row in tau]
        return check_rounding._held(its, stub, "inverse_dynamics", values, truth, [0])

    assert check_report._bounds(held(1e-45, 1e-13)) == "all hold, results are exact"
    assert check_report._bounds(held(0, 0)) == "all hold, results are exact"
    assert check_report._bounds(held(1e-18, 1e-13)) == (
        "all hold, over 1000 times the error (median)")
    assert check_report._bounds(held(1e-14, 2e-14)) == "all hold, 2.00 times the error (median)"


def test_a_bound_that_does_not_hold_fails(path: Path, capsys: pytest.CaptureFixture[str],
                                          monkeypatch: pytest.MonkeyPatch):
    """Halved, the bounds of forward dynamics are below the errors."""
    certified = check_rounding.in_tier_of

    def halved(kernels: Kernels, name: str, part: SceneFunctions) -> SimpleNamespace:
        made = certified(kernels, name, part)

        def forward(*given: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
            a, bound = made.double.forward_dynamics(*given)
            return a, bound / 2

        class Double(dict[str, object]):
            forward_dynamics = staticmethod(forward)
            inverse_dynamics = made.double.inverse_dynamics

        return SimpleNamespace(double=Double(dict.fromkeys(made.double)), single=made.single)

    monkeypatch.setattr(check_rounding, "in_tier_of", halved)
    assert main(["check", str(path)]) == 1
    out = capsys.readouterr().out
    assert "FALSE: double: forward_dynamics: component 0 at t = 0" in out
    assert "beyond its certified bound" in out
    assert out.count("BROKEN") == 1 and out.count("all hold") == 3


def test_large_functions_are_compiled_only_if_selected(kernels: Kernels,
                                                       monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(check_rounding, "MOST", 0)
    assert all(x.certified is None for x in rounding(kernels, [*runs(kernels)]))
    selected = replace(kernels, request=replace(kernels.request, functions=lambda: replace(
        kernels.functions, tiers=("certified",))))
    assert all(isinstance(x, RoundedResults) and x.certified for x in rounding(
        selected, [*runs(kernels)]))


def test_states_that_are_not_finite_are_left_out(tmp_path: Path,
                                                 capsys: pytest.CaptureFixture[str]):
    path = tmp_path / "unstable.toml"
    path.write_text(texts.UNSTABLE)
    assert main(["check", str(path)]) == 1
    assert "FALSE: double: inverse_dynamics" not in capsys.readouterr().out
