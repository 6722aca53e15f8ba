"""Bounds over stated ranges: no search breaks one, in any tier and precision that has one; they are
at most RoboPrec's; comments, docstrings and tiers state them, with reasons where there are none."""

import csv
from dataclasses import replace
from fractions import Fraction
from functools import cache
from math import inf, isfinite

import numpy as np
import pytest

from coscrew_codegen.accuracy.float_rounding import FloatRounding
from coscrew_codegen.accuracy.precision_tuning.choice import AccuracyError, chosen
from coscrew_codegen.accuracy.range_proofs import (
    ResultBound,
    of_accurate,
    of_mixture,
    of_plain,
    values,
)
from coscrew_codegen.accuracy.rounding_rules import ValueBounds
from coscrew_codegen.accuracy.scene_tiers import in_tier
from coscrew_codegen.accuracy.tiers import tier_named
from coscrew_codegen.accuracy.tiers.mixed import Mixture
from coscrew_codegen.backends.output_files import scene_files
from coscrew_codegen.dynamics import derive
from coscrew_codegen.program import Input, Instruction, Op, Program, Ref, constant
from coscrew_codegen.program.scene_functions import FunctionProgram
from coscrew_codegen.program.values.formats import BY_NAME, DOUBLE, PRECISIONS, SINGLE
from coscrew_codegen.reports.cost.measured import TierChoice
from coscrew_codegen.reports.cost.needs.proved import over_ranges
from coscrew_codegen.runtime.load import Kernels, kernels_for
from coscrew_codegen.scene.scene import Tolerance
from tests.support.scenes.generated_scenes import argument
from tests.support.scenes.range_search import Search
from tests.support.scenes.ranged import FUNCTIONS, SCENES, WORST, floating, panda, ranged

NAME = "inverse_dynamics"
CASES = [(scene, name) for scene, names in FUNCTIONS.items() for name in names]
ROBOPREC = {("inverse_dynamics", "double"): 5.9e-13, ("inverse_dynamics", "single"): 3.3e-4,
            ("inverse_dynamics_derivatives", "double"): 9.2e-13,
            ("inverse_dynamics_derivatives", "single"): 5.1e-4}
"""Figures that the bounds must reach on the Panda's box: RoboPrec states 5e-11, 2.5e-2 and, of
derivatives, 5e-4 and 2.6e5."""


@cache
def kernels(scene: str) -> Kernels:
    return kernels_for(replace(SCENES[scene](), functions=FUNCTIONS[scene]))


def function(scene: str, name: str) -> FunctionProgram:
    return kernels(scene).functions.named(name)


@pytest.mark.parametrize("precision", PRECISIONS, ids=lambda p: p.name)
@pytest.mark.parametrize("scene, name", CASES)
def test_no_search_breaks_a_bound(scene, name, precision):
    its = function(scene, name)
    search = Search(kernels(scene), its, precision, of_plain(its, precision))
    assert all(isfinite(x.error) for x in search.bounds)
    worst = list(search.climb(1000, 6, 1))
    assert max(x.part for x in worst) <= 1
    moved = [x.part for x in worst if x.error > 0]
    assert max(moved) > 0.005, "a bound as far from the errors says little"


@pytest.mark.parametrize("name, precision", ROBOPREC)
def test_figures_on_the_box_of_roboprec(name, precision):
    bounds = of_plain(function("panda", name), BY_NAME[precision])
    assert max(x.error for x in bounds) <= ROBOPREC[name, precision]


@pytest.mark.parametrize("scene, name", CASES)
def test_sizes_hold(scene, name):
    its = function(scene, name)
    search = Search(kernels(scene), its, DOUBLE, of_plain(its, DOUBLE))
    results = abs(search.computed(search.states(4000, 3))).max(axis=0)
    sizes = np.array([x.size + x.error for x in search.bounds])
    assert (results <= sizes).all() and results.max() > sizes.max() / 400


@pytest.mark.parametrize("scene", SCENES)
def test_the_accurate_tier_in_single_precision_is_bounded(scene):
    tiers = kernels_for(replace(SCENES[scene](), functions=(NAME,), tiers=("accurate",)))
    its = tiers.functions.named(NAME)
    bounds = of_accurate(its, SINGLE)
    search = Search(tiers.accurate, its, SINGLE, bounds)
    assert 0.2 < max(x.part for x in search.climb(1000, 4, 1)) <= 1
    assert max(x.error for x in bounds) < max(x.error for x in of_plain(its, SINGLE)) / 8


def test_worst_cases_are_within_their_bounds():
    """States that searches found: each has the error that it had, to the bit."""
    rows = list(csv.DictReader(WORST.open(encoding="utf-8")))
    assert len(rows) >= 8
    for row in rows:
        its, precision = function(row["scene"], row["function"]), BY_NAME[row["precision"]]
        search = Search(kernels(row["scene"]), its, precision, of_plain(its, precision))
        numbers = iter([float.fromhex(x) for x in row["state"].split()])
        state = [np.array([next(numbers) for _ in range(a.quantity.size)],
                          precision.numpy_type) for a in its.program.inputs]
        worst = search.judged(int(row["component"]), state)
        assert worst.error == float.fromhex(row["error"]) and worst.part <= 1


def test_comments_docstrings_and_tiers_state_bounds():
    scene = derive(replace(panda(), functions=(NAME,), tiers=("accurate", "certified")))
    files = {name: " ".join(text.split()) for name, text in scene_files(scene).items()}
    words = scene.named(NAME).rounding
    assert words.startswith(
        "Proved for every q in the scene's ranges, |v| <= 0.5 and |a| <= 1: rounding moves tau by "
        "at most 5.9e-13 in double and 3.3e-4 in single precision, and |tau| <= 150; by component "
        "5.9e-13, ")
    for name in ("panda.h", "panda.c", "panda/double.py", "panda/single.py"):
        assert words in files[name], name
    for tier, single in (("accurate", "2.9e-14 in double and 8.6e-6"),
                         ("certified", "5.9e-13 in double and 3.3e-4")):
        own = dict(in_tier(scene, tier_named(tier)).in_precisions)[SINGLE].named(NAME).rounding
        assert f"rounding moves tau by at most {single} in single precision" in own
        assert own in files[f"panda_{tier}.h"] and own in files[f"panda/{tier}/single.py"]


def test_forward_dynamics_points_to_its_residual():
    whole = derive(replace(panda(), functions=("forward_dynamics",))).named("forward_dynamics")
    assert whole.rounding == (
        "Nothing is proved of a: [ranges] states no range of tau.  The certified tier returns a "
        "bound of a at each state; inverse_dynamics of the result judges it: the residual tau - "
        "inverse_dynamics(q, v, a) is known to within 5.9e-13 in double and 3.3e-4 in single "
        "precision and its own rounding, for every q in the scene's ranges, |v| <= 0.5 and "
        "|a| <= 1.")


@pytest.mark.parametrize("sizes, name, words", (
    ({"v": "1"}, "inverse_dynamics", "Nothing is proved of tau: [ranges] states no range of a."),
    ({"v": "1", "tau": "9"}, "forward_dynamics",
     "Nothing is proved of a: no bound of its quotients is known.")))
def test_the_reason_is_stated_where_nothing_is_proved(sizes, name, words):
    scene = ranged(replace(panda(), functions=(name,), ranges=None), sizes)
    assert words in derive(scene).named(name).rounding


def test_components_with_a_bound_are_stated_beside_others_without():
    scene = floating()
    scene = replace(ranged(scene, {}), functions=("body_poses",))
    words = derive(scene).named("body_poses").rounding
    assert words.startswith("Proved for every q (quaternions with 0.999 <= |q|^2 <= 1.001): "
                            "rounding moves 27 of the 36 components of D")
    assert words.endswith("Nothing is proved of other components of D: [ranges] states no range of "
                          "q.")


def test_costs_have_the_bounds_of_each_tier_that_has_one():
    its = function("panda", NAME)
    for tier, precision, bounds in (
            ("plain", DOUBLE, of_plain), ("certified", SINGLE, of_plain),
            ("accurate", SINGLE, of_accurate)):
        expected = tuple(x.error for x in bounds(its, precision))
        assert over_ranges(its, TierChoice(tier, precision)) == expected
    assert over_ranges(replace(its, ranges=None), TierChoice("plain", DOUBLE)) is None


# rules that stated ranges add


X, Y, Z, W = (Input(0, n) for n in range(4))


def small(*steps: tuple[Op, object, object]) -> Program:
    """Instructions a, b, c, …, the last the result; x has four components."""
    made = tuple(Instruction("abcdefghij"[n], op, (x, y), "y")
                 for n, (op, x, y) in enumerate(steps))
    return Program("small", (argument("x", 4),), (argument("y"),), made, (Ref(made[-1].name),))


SQUARES = ((Op.MUL, X, X), (Op.MUL, Y, Y), (Op.MUL, Z, Z), (Op.MUL, W, W),
           (Op.ADD, Ref("a"), Ref("b")), (Op.ADD, Ref("c"), Ref("d")),
           (Op.ADD, Ref("e"), Ref("f")))
INVERSE = small(*SQUARES, (Op.DIV, constant(Fraction(1)), Ref("g")))
PAIRS = small((Op.MUL, X, Y), (Op.MUL, Z, W), (Op.SUB, Ref("a"), Ref("b")))
SIZES = [[1.0005] * 4]


def result(program: Program, quaternion: bool):
    quaternions = ((X, Y, Z, W),) * quaternion
    return ValueBounds(program, SIZES, FloatRounding(SINGLE), quaternions).results[0]


def test_norms_bound_squares_and_products_of_a_quaternion():
    assert result(INVERSE, True).size == pytest.approx(1 / 0.999)
    assert result(INVERSE, False).size == inf
    assert result(PAIRS, True).size == pytest.approx(0.5005)
    assert result(PAIRS, False).size > 2


def test_differences_of_squares_have_no_lower_bound():
    program = small(*SQUARES[:-1], (Op.SUB, Ref("e"), Ref("f")),
                    (Op.DIV, constant(Fraction(1)), Ref("g")))
    assert result(program, True).size == inf
    program = small(*SQUARES[:5], (Op.DIV, constant(Fraction(1)), Ref("e")))
    assert result(program, True).size == inf


def test_quotients_err_by_no_more_than_stated():
    draw = np.random.default_rng(1)
    q = draw.normal(size=(4, 400_000))
    q *= np.sqrt(draw.uniform(0.999, 1.001, q.shape[1])) / np.linalg.norm(q, axis=0)
    near = q.astype(np.float32)
    squares = near * near
    got = 1 / ((squares[0] + squares[1]) + (squares[2] + squares[3]))
    true = 1 / (near.astype(float)**2).sum(axis=0)
    worst = abs(got - true).max()
    assert got.dtype == np.float32
    assert 0.3 * result(INVERSE, True).error <= worst <= result(INVERSE, True).error


def test_powers_of_two_count_to_the_binade_below():
    """x + y up to 1 errs by at most u/2, not by u."""
    program = small((Op.ADD, X, Y))
    values = ValueBounds(program, [[0.5] * 4], FloatRounding(SINGLE)).results[0]
    assert values.error == SINGLE.u / 2 and values.computed == 1


# values carried in pairs


@cache
def paired(scene: str = "panda") -> Kernels:
    """A scene's functions in all tiers that carry values in pairs."""
    return kernels_for(replace(
        SCENES[scene](), functions=(NAME, "body_poses"), tiers=("accurate", "mixed", "pairs"),
        accuracy=(Tolerance(NAME, "", 1e-4 if scene == "panda" else 1e-3),)))


@pytest.mark.parametrize("name", (NAME, "body_poses"))
@pytest.mark.parametrize("tier, precision", (("accurate", DOUBLE), ("pairs", SINGLE)))
@pytest.mark.parametrize("scene", SCENES)
def test_pairs_err_by_hardly_more_than_their_last_rounding(scene, tier, precision, name):
    its = paired(scene).functions.named(name)
    bounds = tier_named(tier).proof(its, precision)
    sizes = [x.size for x in bounds]
    assert max(x.error for x in bounds) <= 1.01 * float(precision.u) * max(sizes)
    worst = [*Search(getattr(paired(scene), tier), its, precision, bounds).climb(500, 3, 1)]
    assert 0.2 < max(x.part for x in worst) <= 1


def test_mixtures_with_quotients_are_proved():
    its = paired("floating").functions.named(NAME)
    choice = chosen(its.program, its.accuracy)
    assert Op.DIV in its.program.counts and 0.9e-3 < max(choice.worst) <= 1e-3
    bounds = tuple(ResultBound(1.0, x) for x in choice.worst)
    search = Search(paired("floating").mixed, its, SINGLE, bounds)
    assert 0.02 < max(x.part for x in search.climb(1000, 6, 1)) <= 1


def test_a_mixture_over_ranges_is_proved():
    its = paired().functions.named(NAME)
    choice = chosen(its.program, its.accuracy)
    bounds = tuple(ResultBound(1.0, x) for x in choice.worst)
    assert 0.9e-4 < max(choice.worst) <= 1e-4
    assert 0.02 < max(x.part for x in Search(paired().mixed, its, SINGLE, bounds).climb(
        1000, 6, 1)) <= 1
    words = dict(in_tier(paired().functions, tier_named("mixed")).in_precisions)[SINGLE].named(NAME)
    assert words.rounding.startswith(
        "Proved for every q in the scene's ranges, |v| <= 0.5 and |a| <= 1: rounding moves tau by "
        "at most 9.9e-5 (asked: 0.0001).  Of 713 instructions ")


def test_mixtures_that_cannot_be_proved_are_refused():
    its = paired().functions.named(NAME)
    tight = replace(its.accuracy, tolerances=(1e-5,) * 7)
    with pytest.raises(AccuracyError, match=r"even pairs of floats, rounded at the end, err by up"):
        chosen(its.program, tight)


def test_single_instructions_of_a_mixture_err_as_in_the_plain_tier_or_more():
    """Without any pair a mixture is the plain program, whose own rule is sharper, also without the
    lengths of vectors."""
    its = paired().functions.named("body_poses")
    rule = FloatRounding(SINGLE)
    rule.turns = False
    plain = values(its.program, its.ranges, SINGLE, rule).results
    none = of_mixture(its.program, its.ranges, SINGLE, Mixture(frozenset(), frozenset()))
    assert all(a.error <= b.error <= 1.5 * a.error + 2e-8 for a, b in zip(
        plain, none, strict=True))
