"""Lengths of vectors that are turned: no state has a longer one, or a longer error; what is no turn
is not taken for one; bounds of chains are sharper; certificates that state lengths without a proof
are refused."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

import coscrew
from coscrew_codegen.accuracy.float_rounding import FloatRounding
from coscrew_codegen.accuracy.range_proofs import of_plain, values
from coscrew_codegen.accuracy.rounding_rules import ValueBounds
from coscrew_codegen.accuracy.vector_lengths import VectorLengths
from coscrew_codegen.dynamics import derive
from coscrew_codegen.program import Constant, Input, Instruction, Op, Operand, Program, Ref
from coscrew_codegen.program.interpreter import by_operation, exactly, interpreter
from coscrew_codegen.program.scene_functions import FunctionProgram
from coscrew_codegen.program.values.formats import SINGLE
from coscrew_codegen.runtime.load import kernels_for
from tests.support.scenes.certificate_checks import refuses
from tests.support.scenes.range_search import Search
from tests.support.scenes.ranged import SCENES, ranged
from tests.support.scenes.robots import scene_of
from tests.support.scenes.small_programs import ANGLE, X, Y, program
from tests.support.scenes.tiers import components
from tests.support.truth.condition import ARRAYS

NAME = "inverse_dynamics"
PLAIN = by_operation(lambda x: np.float32(SINGLE.rounded(x.single)), {
    **exactly(np), Op.SIN: coscrew.sin, Op.COS: coscrew.cos})
SIN, COS = (Op.SIN, ANGLE, None), (Op.COS, ANGLE, None)
A, B = Ref("a"), Ref("b")


@cache
def function(scene: str) -> FunctionProgram:
    return derive(replace(SCENES[scene](), functions=(NAME,))).named(NAME)


def lengths(bounds: ValueBounds) -> VectorLengths:
    assert bounds.lengths
    return bounds.lengths


@pytest.mark.parametrize("scene, known", (("panda", 400), ("floating", 60)))
def test_no_state_has_a_longer_vector_or_error(scene, known):
    its = function(scene)
    kernels = kernels_for(replace(SCENES[scene](), functions=(NAME,)))
    search = Search(kernels, its, SINGLE, of_plain(its, SINGLE))
    given = [np.concatenate(x) for x in zip(
        search.states(2000, 1), search.states(2000, 2, 1.0), strict=True)]
    named = tuple(Ref(x.name) for x in its.program.instructions)
    whole, rows = replace(its.program, results=named), components(its.program, given)
    got = interpreter(whole, PLAIN)([[x.astype(np.float32) for x in row] for row in rows])
    true = interpreter(whole, ARRAYS)([[x.astype(float) for x in row] for row in rows])
    exact = dict(zip(named, true, strict=True))
    lost = {x: abs(y.astype(float) - exact[x]) for x, y in zip(named, got, strict=True)}
    inside = lengths(values(its.program, its.ranges, SINGLE, FloatRounding(SINGLE)))
    assert len(inside.known) >= known
    part = 0.0
    for vector, length in inside.known.items():
        inner = [x for x in vector if isinstance(x, Ref)]
        size = np.sqrt(sum((exact[x]**2 for x in inner), np.zeros(4000))).max()
        error = np.sqrt(sum((lost[x]**2 for x in inner), np.zeros(4000))).max()
        assert size <= length.size * (1 + 1e-12) and error <= length.error, vector
        part = max(part, size / length.size)
    assert part > 0.99


TURN = ((Op.MUL, X, A), (Op.MUL, Y, B), (Op.ADD, Ref("c"), Ref("d")))  # s x + c y
SECOND = {
    "turn": (((Op.MUL, X, B), (Op.MUL, Y, A), (Op.SUB, Ref("f"), Ref("g"))), True),
    "the other way": (((Op.MUL, Y, A), (Op.MUL, X, B), (Op.SUB, Ref("f"), Ref("g"))), True),
    "two sums": (((Op.MUL, X, B), (Op.MUL, Y, A), (Op.ADD, Ref("f"), Ref("g"))), False),
    "the same factors": (((Op.MUL, X, A), (Op.MUL, Y, B), (Op.SUB, Ref("f"), Ref("g"))), False),
    "another vector": (((Op.MUL, X, B), (Op.MUL, X, A), (Op.SUB, Ref("f"), Ref("g"))), False)}


@pytest.mark.parametrize("name", SECOND)
def test_only_both_components_of_a_turn_keep_lengths(name):
    steps, turn = SECOND[name]
    small = program(SIN, COS, *TURN, *steps)
    bounds = ValueBounds(small, [(3.0, 4.0, np.inf)], FloatRounding(SINGLE))
    length = lengths(bounds).length((Ref("e"), Ref("h")))
    angle = np.linspace(0, 7, 999)
    s, c = np.sin(angle), np.cos(angle)
    second = {"turn": 3 * c - 4 * s, "the other way": 4 * s - 3 * c, "two sums": 3 * c + 4 * s,
              "the same factors": 3 * s - 4 * c, "another vector": 3 * c - 3 * s}[name]
    assert np.hypot(3 * s + 4 * c, second).max() <= length.size
    assert (length.size == pytest.approx(5)) == turn


@pytest.mark.parametrize("steps, size", (
    (((Op.MUL, X, A), (Op.MUL, X, B)), 3.0),  # multiples of sine and cosine
    (((Op.MUL, ANGLE, X), (Op.MUL, ANGLE, Y)), 10.0),  # of a vector
    (((Op.ADD, X, A), (Op.SUB, Y, B)), 6.0),  # sums of vectors
    (((Op.ADD, X, A), (Op.SUB, Y, A)), None)))  # of one number twice: no vector
def test_lengths_of_multiples_and_sums(steps, size):
    small = program(SIN, COS, *steps)
    bounds = ValueBounds(small, [(3.0, 4.0, 2.0)], FloatRounding(SINGLE))
    length = lengths(bounds).length((Ref("c"), Ref("d")))
    assert length.size == pytest.approx(np.hypot(4, 5) if size is None else size)


@pytest.mark.parametrize("file, sizes, most", (
    ("ur_description/urdf/ur5_robot.urdf", {"a": "20"}, 6.4e-4),  # by component 1.4e-3
    ("g1_description/urdf/g1_29dof_rev_1_0.urdf", {"v": "2", "a": "10"}, 9.1e-3)))  # 4.1e-2
def test_chains_have_sharper_bounds(file, sizes, most):
    its = derive(replace(ranged(scene_of(file), sizes), functions=(NAME,))).named(NAME)
    assert most / 1.02 < max(x.error for x in of_plain(its, SINGLE)) <= most


@pytest.mark.parametrize("axes, size", (
    ([(n % 3, (n + 1) % 3) for n in range(1000)], 3),
    ([(0, 1)] * 1000 + [(1, 2)], np.hypot(4, 1))))  # (x, y, z) would be followed down to the first
def test_chains_of_any_length_are_followed(axes, size):
    """Turns, each by another angle."""
    made: list[Instruction] = []

    def step(op: Op, *operands: Operand) -> Ref:
        made.append(Instruction(f"n{len(made)}", op, operands, "y"))
        return Ref(made[-1].name)

    vector: list[Operand] = [X, Y, Constant(1, 1)]
    for n, (i, j) in enumerate(axes):
        sine, cosine = step(Op.SIN, Input(1, n)), step(Op.COS, Input(1, n))
        p, q = vector[i], vector[j]
        vector[i] = step(Op.SUB, step(Op.MUL, cosine, p), step(Op.MUL, sine, q))
        vector[j] = step(Op.ADD, step(Op.MUL, sine, p), step(Op.MUL, cosine, q))
    small = Program("small", (), (), tuple(made), tuple(vector))
    bounds = ValueBounds(small, [(2.0, 2.0), (np.inf,) * 1001], FloatRounding(SINGLE))
    assert max(x.size for x in bounds.results) <= size * (1 + 1e-9)


GIVEN = ["53 -1022 103/125", "input x 0x1p0 0x0p0 0x0p0", "input y 0x1p0 0x0p0 0x0p0",
         "sin s x 0x1p0 0x1p-52 0x1p-52", "cos c x 0x1p0 0x1p-52 0x1p-52",
         "input_length s,c circle 0x1p0 0x1.8p-52 0x0p0",
         "input_length x,y components 0x1.7p0 0x0p0 0x0p0",
         "mul a s x 0x1p0 0x1p-50 0x1p-53", "mul b c y 0x1p0 0x1p-50 0x1p-53",
         "input_length t, result x,y s,c 0x1.7p0 0x1p-50 0x0p0",
         "add t a b t, 0x1.7p0 0x1.4p-50 0x1p-53"]


@pytest.mark.parametrize("line, changed", (
    (5, "input_length s,c circle 0x1.8p-1 0x1.8p-52 0x0p0"),
    (5, "input_length s,c circle 0x1p0 0x1p-52 0x0p0"),
    (5, "input_length s,y circle 0x1p0 0x1.8p-52 0x0p0"),
    (6, "input_length x,y components 0x1.6p0 0x0p0 0x0p0"),
    (6, "input_length x,x components 0x1.7p0 0x0p0 0x0p0"),
    (6, "input_length x,y sum x,y  0x1.7p0 0x0p0 0x0p0"),
    (6, "input_length x,y known 0x1.7p0 0x0p0 0x0p0"),
    (9, "input_length t, result x,z s,c 0x1.7p0 0x1p-50 0x0p0"),
    (9, "input_length t, result x,y x,c 0x1.7p0 0x1p-50 0x0p0"),
    (9, "input_length t, turn x,y s,c 0x1.7p0 0x1p-50 0x0p0"),
    (9, "input_length t, result x,y s,c 0x1.6p0 0x1p-50 0x0p0"),
    (9, "input_length t, result x,y s,c 0x1.7p0 0x1p-53 0x0p0"),
    (10, "mul t a b t, 0x1.7p0 0x1.4p-50 0x1p-53"),
    (10, "add t a b a 0x1p0 0x1.4p-50 0x1p-53"),
    (10, "add t a b t, 0x1.6p0 0x1.4p-50 0x1p-53")))
def test_lengths_without_a_proof_are_refused(line, changed):
    assert not refuses(GIVEN)
    assert refuses([*GIVEN[:line], changed, *GIVEN[line + 1:]])
