"""Statements on rounding errors between the joints' limits, derived without running: every rule
holds and is no more generous than it says; searches for the worst error never exceed the bound, and
come near it; where no useful bound is known nothing is stated."""

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from functools import cache

import numpy as np
import pytest

import coscrew
from coscrew_codegen.accuracy.float_rounding import FloatRounding
from coscrew_codegen.accuracy.rounding_rules import ValueBounds
from coscrew_codegen.backends.output_files import scene_files
from coscrew_codegen.dynamics import derive
from coscrew_codegen.program import Constant, Op, Program, Ref
from coscrew_codegen.program.interpreter import by_operation, exactly, interpreter
from coscrew_codegen.program.values.formats import PRECISIONS, SINGLE
from coscrew_codegen.runtime.load import Kernels, kernels_for
from coscrew_codegen.scene.mechanism.model import Model
from coscrew_codegen.scene.scene import Scene
from tests.support.scenes import mechanisms as m
from tests.support.scenes.arms import arm
from tests.support.scenes.kinds import Kind
from tests.support.scenes.small_programs import ANGLE, X, Y, program
from tests.support.scenes.worst_rounding import stated, worst_exactly, worst_found
from tests.support.truth.condition import ARRAYS

PLAIN = by_operation(lambda x: np.float32(SINGLE.rounded(x.single)), {
    **exactly(np), Op.SIN: coscrew.sin, Op.COS: coscrew.cos})
SMALL = ("body_poses", "gravity_torques", "mass_matrix", "energy", "bias_torques")
TENTH = Constant(Fraction("0.1"), Fraction("0.1"))


RULES: dict[str, tuple[Program, float]] = {  # and the part of the bound that is reached
    "sum": (program((Op.ADD, X, Y)), 0.98),
    "product": (program((Op.MUL, X, Y)), 0.98),
    "constant": (program((Op.MUL, X, TENTH)), 0.88),
    "errors of factors": (program((Op.ADD, X, Y), (Op.MUL, Ref("a"), Ref("a"))), 0.8),
    "sine": (program((Op.SIN, ANGLE, None)), 0.85),
    "turn": (program((Op.SIN, ANGLE, None), (Op.COS, ANGLE, None), (Op.MUL, X, Ref("a")),
                     (Op.MUL, Y, Ref("b")), (Op.SUB, Ref("d"), Ref("c"))), 0.5),
    "turn of errors": (program((Op.SIN, ANGLE, None), (Op.COS, ANGLE, None), (Op.ADD, X, Y),
                               (Op.MUL, Ref("c"), Ref("c")), (Op.MUL, Ref("d"), Ref("d")),
                               (Op.MUL, Ref("e"), Ref("a")), (Op.MUL, Ref("b"), Ref("e")),
                               (Op.ADD, Ref("f"), Ref("g"))), 0.4),
    "two angles": (program((Op.SIN, ANGLE, None), (Op.COS, Y, None), (Op.MUL, X, Ref("a")),
                           (Op.MUL, X, Ref("b")), (Op.SUB, Ref("d"), Ref("c"))), 0.4)}


@pytest.mark.parametrize("name", RULES)
def test_rules_hold_and_are_reached(name: str):
    small, reached = RULES[name]
    sizes = (1.7, 1.4, np.inf)
    result = ValueBounds(small, [sizes], FloatRounding(SINGLE)).results
    draw = np.random.default_rng(1)
    x, y = (draw.uniform(0.6 * size, size, 400_000) * draw.choice((-1, 1), 400_000)
            for size in sizes[:2])
    given = [z.astype(np.float32) for z in (x, y, draw.uniform(-4, 4, len(x)))]
    got, = interpreter(small, PLAIN)([given])
    true, = interpreter(small, ARRAYS)([[z.astype(float) for z in given]])
    worst = abs(got.astype(float) - true).max()
    assert got.dtype == np.float32 and abs(true).max() <= result[0].size
    assert reached * result[0].error <= worst <= result[0].error, worst / result[0].error


def limited(model: Model) -> Model:
    """With limits, and the last joint a slide."""
    *turning, last = model.joints
    ends = {"lower": Fraction("-2.9"), "upper": Fraction("2.8"), "velocity": Fraction("2.1")}
    slide = {**ends, "lower": Fraction(0), "upper": Fraction("0.04")}
    return replace(model, joints=(*(replace(j, **ends) for j in turning),
                                  replace(last, kind=Kind.PRISMATIC, **slide)))


@cache
def kernels() -> Kernels:
    return kernels_for(Scene("arm", limited(arm()), (m.gravity(),), functions=SMALL))


@pytest.mark.parametrize("name", SMALL)
def test_searches_find_no_more_and_not_much_less(name: str):
    function = kernels().functions.named(name)
    bounds = stated(function)
    assert {precision for _, precision in bounds} == {p.name for p in PRECISIONS}
    for (output, precision), bound in bounds.items():
        p = next(p for p in PRECISIONS if p.name == precision)
        assert worst_exactly(kernels(), function, output, 12, p) <= bound
        if p == SINGLE:
            result = worst_found(kernels(), function, output, 1000, 20)
            assert result <= bound <= 1000 * result, (bound, result)


def without(model: Model, **fields: object) -> Model:
    return replace(model, joints=tuple(replace(j, **fields) for j in model.joints))


@pytest.mark.parametrize("change, lost", (
    (lambda x: x, {"forward_dynamics", "inverse_dynamics"}),
    (lambda x: without(x, velocity=None), {"forward_dynamics", "inverse_dynamics", "energy"}),
    (lambda x: without(x, lower=None), {"forward_dynamics", "inverse_dynamics", "energy",
                                        "gravity_torques", "body_poses"})),
    ids=("quotients and accelerations", "velocities", "a slide without an end"))
def test_nothing_is_stated_where_nothing_is_known(change: Callable[[Model], Model],
                                                  lost: set[str]):
    names = ("body_poses", "gravity_torques", "energy", "inverse_dynamics", "forward_dynamics")
    result = derive(Scene("arm", change(limited(arm())), (m.gravity(),), functions=names))
    assert {f.name for f in result.functions if not f.rounding} == lost
    if not lost & {"body_poses"}:
        assert result.named("body_poses").rounding.endswith(
            "precision, for every q within the joints' limits.")


def test_angles_need_no_limits():
    scene = Scene("arm", arm(), (m.gravity(),), functions=("gravity_torques",), precisions=(
        "single",))
    words = derive(scene).named("gravity_torques").rounding
    assert words.startswith("Proved: rounding moves tau by at most ")
    assert words.endswith(" in single precision, for every q.")


def test_comments_and_docstrings_of_plain_functions_have_it():
    scene = derive(Scene("arm", arm(), (m.gravity(),), functions=("body_poses",),
                         tiers=("accurate",)))
    files = {name: " ".join(text.split()) for name, text in scene_files(scene).items()}
    words = scene.named("body_poses").rounding
    for name in ("arm.h", "arm.c", "arm/double.py", "arm/single.py"):
        assert words in files[name], name
    assert not any("Proved: rounding" in files[name] for name in files if "accurate" in name)
