"""What coscrew cost says of rounding: errors against rational arithmetic, states inside the limits,
a search that finds more than chance."""

import math
from dataclasses import replace
from fractions import Fraction
from xml.etree import ElementTree

import numpy as np
import pytest

from coscrew_codegen import load_scene
from coscrew_codegen.cost import rounding
from coscrew_codegen.cost.measure import Costs
from coscrew_codegen.cost.plot import plot
from coscrew_codegen.cost.rounding import PLACES, Rounding, measured, variants
from coscrew_codegen.cost.states import Box, Values, box_of, searched
from coscrew_codegen.cost.table import roundings
from coscrew_codegen.native.intervals import Interval
from coscrew_codegen.simulate.plan import plan
from coscrew_codegen.simulate.run import integrate
from coscrew_codegen.simulate.system import system
from tests.support.scenes import scene_texts as texts

MASS, STIFFNESS, DAMPING = Fraction("0.7"), Fraction("13.3"), Fraction("0.9")
TEXT = f"""
precision = "both"
[bodies.block]
mass = {float(MASS)}
inertia = [0.02, 0.02, 0.02]
[joints.slide]
type = "prismatic"
child = "block"
axis = [1, 0, 0]
limits = {{ lower = -0.5, upper = 1.5, velocity = 4, effort = 8 }}
[effects.spring]
joints = "all"
k = {float(STIFFNESS)}
[effects.viscous]
joints = "all"
d = {float(DAMPING)}
[start.q]
slide = 0.1
"""


@pytest.fixture(scope="module")
def kernels(tmp_path_factory):
    path = tmp_path_factory.mktemp("rounding") / "spring.toml"
    path.write_text(TEXT)
    return load_scene(path, functions=["all"], tiers=["accurate"])


@pytest.fixture(scope="module")
def box(kernels) -> Box:
    return box_of(system(kernels, "double"), 1.0)


def no_times(function: str, found: list, states: Values) -> list[Interval]:
    return [Interval(n, n, n) for n in range(1, len(found) + 1)]


@pytest.fixture(scope="module")
def rows(kernels, box) -> list[Rounding]:
    its = system(kernels, "double")
    run = integrate(its, plan(its, 1.0, None, None, every=0.01))
    return measured(variants(kernels, {}), box, run, no_times)


def true(function: str, states: Values, row: int) -> Fraction:
    """m a + d v + k q = tau of the spring and the damper, in rationals."""
    q, v, a, tau = (Fraction(float(states[name][row, 0])) for name in ("q", "v", "a", "tau"))
    pull = STIFFNESS * q + DAMPING * v
    return {"inverse_dynamics": MASS * a + pull, "forward_dynamics": (tau - pull) / MASS,
            "mass_matrix": MASS}[function]


def test_errors_are_those_of_rational_arithmetic(kernels, box, monkeypatch):
    """All errors, typical and worst, at the states that were chosen."""
    chosen = {}

    def remembered(function, *given):
        chosen[function] = original(function, *given)
        return chosen[function]

    original = rounding._states
    monkeypatch.setattr(rounding, "_states", remembered)
    its = system(kernels, "double")
    run = integrate(its, plan(its, 1.0, None, None, every=0.01))
    found = variants(kernels, {})
    for row, of in zip(measured(found, box, run, no_times), 3 * found, strict=True):
        states = chosen[row.function]
        got = np.ravel(of.system.call(row.function, **states)).astype(float)
        got = np.broadcast_to(got, len(states["t"]))
        errors = sorted(float(abs(Fraction(float(x)) - true(row.function, states, n)))
                        for n, x in enumerate(got))
        assert (row.tier, row.precision) == (of.tier, of.system.precision.name)
        assert row.worst == pytest.approx(errors[-1], rel=1e-12)
        assert row.typical == pytest.approx(np.median(errors), rel=1e-12)


def test_accurate_results_are_the_nearest_numbers(rows):
    """Half a unit of the last of 53 or 24 digits at most: digits that are right of the largest
    component."""
    for row in rows:
        if row.tier == "accurate":
            bits = {"double": 53, "single": 24}[row.precision]
            assert row.digits >= (bits - 0.01) * math.log10(2)
    worst = {(x.tier, x.precision): x.worst for x in rows if x.function == "inverse_dynamics"}
    for precision in ("double", "single"):
        assert worst["plain", precision] > worst["accurate", precision]


def test_states_are_inside_the_limits_and_numbers_of_single_precision(box):
    states = box.drawn(np.random.default_rng(0), 2000)
    near = box.near(np.random.default_rng(0), states, 0.5, 3)
    for some in (states, near):
        for name, low, high in (("q", -0.5, 1.5), ("v", -4, 4), ("a", -40, 40), ("tau", -8, 8),
                                ("t", 0, 1)):
            assert low <= some[name].min() < low + 0.1 * (high - low)
            assert high - 0.1 * (high - low) < some[name].max() <= high
            assert np.array_equal(some[name], some[name].astype(np.float32))
    assert len(near["q"]) == 6000


def test_the_search_finds_a_peak_that_chance_misses(box):
    def score(states: Values) -> np.ndarray:
        away = (states["q"] - 0.625)**2 + (states["v"] + 1.5)**2 + (states["a"] - 3)**2
        return -away[:, 0]

    found = searched(box, score, 4)
    by_chance = score(box.drawn(np.random.default_rng(5), 40_000)).max()
    assert score(found).min() > by_chance
    assert len(found["q"]) == 4


def costs(rows: list[Rounding]) -> Costs:
    return Costs("spring", "a compiler", (), None, (), tuple(rows))


def timed(rows: list[Rounding], *medians: float) -> list[Rounding]:
    return [replace(x, time=Interval(t, 0.99 * t, 1.01 * t))
            for x, t in zip(rows, medians, strict=True)]


def test_the_table_marks_what_nothing_beats_and_says_what_steps_gain():
    row = Rounding("inverse_dynamics", "plain", "double", 1e-15, 1e-14, 15, "search",
                   Interval(1, 1, 1))
    some = [row, replace(row, precision="single", worst=1e-5),
            replace(row, tier="accurate", worst=1e-15),
            replace(row, tier="accurate", precision="single", worst=1e-6)]
    text = roundings(timed(some, 100, 90, 500, 110))
    lines = {tuple(x.split()[:2]): x.split() for x in text.splitlines()
             if x.startswith(("double", "single")) and "instead" not in x}
    assert [lines[pair][-1] == "*" for pair in (
        ("double", "plain"), ("single", "plain"), ("double", "accurate"),
        ("single", "accurate"))] == [True, True, True, False]
    assert ("double plain instead of single plain: 1e+09 times less error in 1.11 times the time"
            in text)
    assert "double accurate instead of double plain: 10 times less error in 5.00 times" in text
    assert f"{PLACES['run']} states of the run" in text


def test_the_figure_has_a_point_for_each_function_tier_and_precision(rows, tmp_path):
    plot(costs(rows), tmp_path / "costs.svg")
    root = ElementTree.parse(tmp_path / "costs.svg").getroot()
    ids = {x.get("id") for x in root.iter()}
    assert {f"rounding {x.function} {x.tier} {x.precision}" for x in rows} <= ids


def test_parameters_and_settings_are_rounded_to_single(tmp_path):
    path = tmp_path / "scene.toml"
    path.write_text(texts.SPRING)
    found = variants(load_scene(path, tiers=["accurate"]), {"block.mass": 0.1})
    assert {x.system.p for x in found} == {(float(np.float32(0.1)),)}
    assert [(x.tier, x.precision) for x in found] == [
        ("plain", "double"), ("plain", "single"), ("accurate", "double"), ("accurate", "single")]
