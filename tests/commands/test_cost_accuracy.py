"""Accuracies of coscrew cost: errors and bounds against rational arithmetic, states inside the
limits, a search that finds more than chance."""

import math
from dataclasses import replace
from fractions import Fraction
from statistics import median
from xml.etree import ElementTree

import numpy as np
import pytest

from coscrew_codegen import load_scene
from coscrew_codegen.backends.html.plots import drawn as drawn_panels
from coscrew_codegen.program.values.formats import DOUBLE
from coscrew_codegen.reports.cost import cost_measurement
from coscrew_codegen.reports.cost.cost_measurement import Costs
from coscrew_codegen.reports.cost.cost_request import CostRequest
from coscrew_codegen.reports.cost.error_states import Box, Values, box_of, searched
from coscrew_codegen.reports.cost.figures.cost_figure import functions, plot
from coscrew_codegen.reports.cost.measured import ACCURATE, CERTIFIED, Counts, Measured, TierChoice
from coscrew_codegen.reports.cost.measured import choices as choices_of
from coscrew_codegen.simulation.run_summary import RunOverrides
from coscrew_codegen.simulation.system import system
from tests.support.scenes import scene_texts as texts

MASS, STIFFNESS, DAMPING = Fraction("0.7"), Fraction("13.3"), Fraction("0.9")
FUNCTIONS = ("inverse_dynamics", "forward_dynamics", "mass_matrix")
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
    path = tmp_path_factory.mktemp("accuracy") / "spring.toml"
    path.write_text(TEXT)
    return load_scene(path, functions=["default"])


@pytest.fixture(scope="module")
def box(kernels) -> Box:
    return box_of(system(kernels, "double"), 1.0, 1e-3)


@pytest.fixture(scope="module")
def looked_at() -> dict[str, tuple[Measured, Values, tuple[str, ...]]]:
    """The states of each function, and what computes there."""
    return {}


@pytest.fixture(scope="module")
def costs(kernels, looked_at) -> Costs:
    original = Measured.states

    def remembered(function, *given):
        states, places = original(function, *given)
        looked_at[function.name] = function, states, places
        return states, places

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(Measured, "states", remembered)
        return cost_measurement.measure(kernels, RunOverrides(until=1.0), CostRequest(FUNCTIONS))


def true(function: str, states: Values, row: int) -> Fraction:
    """m a + d v + k q = tau of the spring and the damper, in rationals."""
    q, v, a, tau = (Fraction(float(states[name][row, 0])) for name in ("q", "v", "a", "tau"))
    pull = STIFFNESS * q + DAMPING * v
    return {"inverse_dynamics": MASS * a + pull, "forward_dynamics": (tau - pull) / MASS,
            "mass_matrix": MASS}[function]


def test_errors_and_bounds_are_those_of_rational_arithmetic(costs, looked_at):
    """All figures, at the states that were chosen, against results computed again."""
    assert [rows[0].function for rows in costs.accuracy] == list(FUNCTIONS)
    for rows in costs.accuracy:
        function, states, places = looked_at[rows[0].function]
        assert {places.count(x) for x in ("run", "limits", "search")} == {16, 32}
        exact = [true(function.name, states, n) for n in range(64)]
        for row, choice in zip(rows, choices_of(function.built, function.name), strict=True):
            result, *bounds = function.values(choice, states)
            errors = [abs(Fraction(float(x)) - y) for x, y in zip(result[:, 0], exact, strict=True)]
            (of,) = row.errors
            assert (row.tier, row.precision, row.states) == (
                choice.tier, choice.precision.name, 64)
            assert of.worst == pytest.approx(float(max(errors)), rel=1e-12)
            assert of.typical == pytest.approx(float(median(errors)), rel=1e-12)
            at = errors.index(max(errors))
            assert of.place == places[at]
            assert row.worst_at == {name: tuple(states[name][at].tolist()) for name in row.worst_at}
            assert of.largest == pytest.approx(float(max(map(abs, exact))), rel=1e-15)
            digits = [math.log10(abs(y) / x) for x, y in zip(errors, exact, strict=True) if x]
            assert of.worst_digits == pytest.approx(max(0, min(digits)), rel=1e-12)
            if bounds:
                stated = [Fraction(float(x)) for x in bounds[0][:, 0]]
                assert all(x <= y for x, y in zip(errors, stated, strict=True))
                ratios = [float(y / x) for x, y in zip(errors, stated, strict=True) if x]
                assert (of.bounds.least_ratio, of.bounds.typical_ratio,
                        of.bounds.worst_ratio) == pytest.approx(
                            (min(ratios), median(ratios), max(ratios)), rel=1e-12)
                assert of.bounds.worst == float(max(stated)) and of.bounds.least_ratio >= 1


def test_accurate_results_are_the_nearest_numbers(costs):
    """Half a unit of the last of 53 or 24 digits at most."""
    for rows in costs.accuracy:
        for row in rows:
            if row.tier == "accurate":
                bits = {"double": 53, "single": 24}[row.precision]
                assert row.errors[0].worst_digits >= (bits - 0.01) * math.log10(2)
    worst = {x.name: x.errors[0].worst for x in costs.accuracy[0]}
    for precision in ("double", "single"):
        assert worst[f"{precision} plain"] > worst[f"{precision} accurate"]
        assert worst[f"{precision} plain"] == worst[f"{precision} certified"]


# states

def test_states_are_inside_the_limits_and_numbers_of_single_precision(box):
    states = box.drawn(np.random.default_rng(0), 2000)
    near = box.near(np.random.default_rng(0), states, 0.5, 3)
    for some in (states, near):
        for name, low, high in (("q", -0.5, 1.5), ("v", -4, 4), ("a", -40, 40), ("tau", -8, 8),
                                ("t", 0, 1)):
            assert low <= some[name].min() < low + 0.1 * (high - low)
            assert high - 0.1 * (high - low) < some[name].max() <= high
        assert all(np.array_equal(x, x.astype(np.float32)) for x in some.values())
        assert np.array_equal(some["phi"], np.float32(np.float32(1e-3) * some["v"]))
    assert len(near["q"]) == 6000


def test_states_of_a_run_have_the_accelerations_that_torques_cause(costs, looked_at):
    _, states, places = looked_at["inverse_dynamics"]
    for row in range(places.count("run")):
        wanted = float(true("forward_dynamics", states, row))
        assert states["a"][row, 0] == pytest.approx(wanted, rel=2.0**-22, abs=1e-5)
    assert len(set(states["tau"][:16, 0])) == 16 and len(set(states["t"][:16])) == 16


def test_the_search_finds_a_peak_that_chance_misses(box):
    def score(states: Values) -> np.ndarray:
        away = (states["q"] - 0.625)**2 + (states["v"] + 1.5)**2 + (states["a"] - 3)**2
        return -away[:, 0]

    result = searched(box, score, 4)
    by_chance = score(box.drawn(np.random.default_rng(5), 40_000)).max()
    assert score(result).min() > by_chance
    assert len(result["q"]) == 4


def test_the_search_climbs_the_errors_of_each_choice(costs, looked_at, box):
    """The search's states have the worst error of a choice or, if it is certified, the worst bound;
    the errors of accurate results in double are exact."""
    function, states, places = looked_at["inverse_dynamics"]
    chance = box.drawn(np.random.default_rng(7), 4000)
    for choice in choices_of(function.built, function.name):
        (unit,) = function.different_units
        bad, others = (function.badness(choice, unit, x) for x in (states, chance))
        searched_for = [n for n, place in enumerate(places) if place == "search"]
        assert bad[searched_for].max() == bad.max() >= 0.99 * others.max(), choice.name
        if choice.tier == CERTIFIED:
            assert bad.max() == function.values(choice, states)[1].max()
        if choice == TierChoice(ACCURATE,
                                DOUBLE):  # half a unit of the last digit of the largest ones
            result, = function.values(choice, states)
            assert bad.tolist() == pytest.approx([
                float(abs(Fraction(float(result[n, 0])) - true(function.name, states, n)))
                for n in range(len(bad))], rel=1e-15, abs=1e-48)


def test_every_choice_and_unit_has_its_search(costs, looked_at):
    """At least one state; sixteen of six choices in one unit."""
    for function, _, places in looked_at.values():
        assert len(choices_of(function.built, function.name)) == 6
        assert places.count("search") == 16


def test_a_function_has_the_tiers_that_have_it(costs, looked_at):
    function, *_ = looked_at["inverse_dynamics"]
    accurate, certified = function.built.tiers
    without = replace(accurate, in_precisions=tuple(
        (p, replace(x, functions=tuple(f for f in x.functions if f.name != function.name)))
        for p, x in accurate.in_precisions))
    result = replace(function.built, tiers=(without, certified))
    assert {x.tier for x in choices_of(result, function.name)} == {"plain", CERTIFIED}
    assert {x.tier for x in choices_of(result, "mass_matrix")} == {"plain", ACCURATE, CERTIFIED}


def test_tiers_that_the_scene_selects_are_measured_too(tmp_path):
    """Pairs are of single precision alone, and as accurate there as the accurate tier."""
    path = tmp_path / "spring.toml"
    path.write_text('tiers = ["pairs"]\n' + TEXT)
    result = cost_measurement.measure(load_scene(path, functions=["default"]),
                                      RunOverrides(until=0.1),
                                      CostRequest(("forward_dynamics",), Counts.of(16)))
    (rows,) = result.accuracy
    assert [x.name for x in rows] == [
        "double plain", "single plain", "double accurate", "single accurate", "double certified",
        "single certified", "single pairs"]
    errors = {x.name: x.errors[0] for x in rows}
    pairs, accurate = errors["single pairs"], errors["single accurate"]
    assert pairs.worst_digits >= 23.99 * math.log10(2) and pairs.bounds is None
    assert pairs.worst < 2 * accurate.worst
    plot(result, tmp_path / "costs.svg")
    drawn = (tmp_path / "costs.svg").read_text()
    assert 'id="forward_dynamics single pairs"' in drawn
    (axes,) = drawn_panels((*functions(result),)).axes
    labels = [x.get_text() for x in axes.get_legend().get_texts()]
    assert labels == ["plain", "accurate", "certified", "pairs", "double", "single",
                      "recommended"]


@pytest.mark.parametrize("total", (4, 7, 64))
def test_states_are_as_many_as_asked_for(total):
    counts = Counts.of(total)
    assert counts.run + counts.limits + counts.search == total
    assert Counts.of(64) == Counts()


def test_parameters_and_settings_are_rounded_to_single(tmp_path):
    path = tmp_path / "scene.toml"
    path.write_text(texts.SPRING)
    its = load_scene(path, functions=["default"])
    result = cost_measurement.measure(its, RunOverrides(settings=(("block.mass", 0.1),)),
                                      CostRequest(("mass_matrix",), Counts.of(4)))
    for row in result.accuracy[0]:
        assert row.errors[0].worst == 0 and row.worst_at["p"] == (float(np.float32(0.1)),)


# figure

def test_the_figure_has_a_mark_for_each_function_tier_and_precision(costs, tmp_path):
    plot(costs, tmp_path / "costs.svg")
    root = ElementTree.parse(tmp_path / "costs.svg").getroot()
    ids = {x.get("id") for x in root.iter()}
    assert {f"{x.function} {x.name}" for rows in costs.accuracy for x in rows} <= ids
    assert sum(str(x).startswith("inverse_dynamics ") and str(x).endswith(" recommended")
               for x in ids) == 1
