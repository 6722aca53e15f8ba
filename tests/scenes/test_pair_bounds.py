"""Bounds of pairs hi + lo: no value of random programs breaks those of its hi, its lo and its
error, quotients by norms of quaternions and sines of pairs included; nor does any mixture."""

from dataclasses import replace
from fractions import Fraction
from functools import cache

import numpy as np
import pytest

from coscrew_codegen.accuracy.pair_rounding import PairRounding
from coscrew_codegen.accuracy.precision_tuning.array_evaluation import evaluator
from coscrew_codegen.accuracy.range_proofs import of_mixture
from coscrew_codegen.accuracy.rounding_rules import ValueBounds
from coscrew_codegen.accuracy.tiers.accurate_scene import SCENES, rounded
from coscrew_codegen.accuracy.tiers.compensated import Carrier
from coscrew_codegen.accuracy.tiers.mixed import CARRYING, Mixture, mixed
from coscrew_codegen.program import ZERO, Input, Instruction, Op, Operand, Program, Ref, constant
from coscrew_codegen.program.interpreter import interpreter
from coscrew_codegen.program.scene_functions import ArgumentRanges
from coscrew_codegen.program.values.formats import SINGLE
from tests.support.scenes.generated_scenes import argument
from tests.support.scenes.range_search import LONG

QUATERNION = tuple(Input(0, n) for n in range(4))
OTHERS = tuple(Input(1, n) for n in range(3))
RANGES = ArgumentRanges((((-1.0005, 1.0005),) * 4, ((-3.0, 3.0),) * 3), (QUATERNION,))
CONSTANTS = tuple(constant(Fraction(x)) for x in ("0.1", "-1/3", "0.7", "2", "1/1024"))
OPS = (Op.ADD, Op.SUB, Op.MUL, Op.MUL, Op.DIV, Op.NEG, Op.SIN, Op.COS)
COUNT, SEEDS = 20_000, range(6)


@cache
def program(seed: int) -> Program:
    """Random instructions on a quaternion and three other numbers, 2/|q|² among them."""
    draw = np.random.default_rng(seed)
    steps: list[Instruction] = []

    def issue(op: Op, *operands: Operand) -> Ref:
        steps.append(Instruction(f"x{len(steps)}", op, operands, "y"))
        return Ref(steps[-1].name)

    squares = [issue(Op.MUL, x, x) for x in QUATERNION]
    norm = issue(Op.ADD, issue(Op.ADD, *squares[:2]), issue(Op.ADD, *squares[2:]))
    known: list[Operand] = [*QUATERNION, *OTHERS, *CONSTANTS, issue(Op.DIV, constant(Fraction(2)),
                                                                    norm)]
    for _ in range(30):
        op = OPS[draw.integers(len(OPS))]
        a, b = (known[draw.integers(len(known))] for _ in range(2))
        if op in (Op.NEG, Op.SIN, Op.COS):
            known.append(issue(op, a if not isinstance(a, type(ZERO)) else OTHERS[0]))
        elif op is Op.DIV:
            known.append(issue(op, a, (norm, CONSTANTS[1])[draw.integers(2)]))
        else:
            known.append(issue(op, a, b))
    return Program("random", (argument("q", 4), argument("x", 3)), (argument("y"),), tuple(steps),
                   (Ref(steps[-1].name),))


@cache
def given() -> list[list[np.ndarray]]:
    draw = np.random.default_rng(11)
    q = draw.normal(size=(4, COUNT))
    q *= np.sqrt(draw.uniform(0.9991, 1.0009, COUNT)) / np.linalg.norm(q, axis=0)
    x = np.where(draw.random((3, COUNT)) < 0.2, 3, draw.uniform(-3, 3, (3, COUNT)))
    return [[*q.astype(np.float32)], [*x.astype(np.float32)]]


def every(its: Program) -> Program:
    """The program with all its values as results."""
    return replace(its, outputs=(argument("y", len(its.instructions)),),
                   results=tuple(Ref(step.name) for step in its.instructions))


def exact(its: Program) -> np.ndarray:
    """The values in 64 bits."""
    rows = [[x.astype(np.longdouble) for x in each] for each in given()]
    return np.stack([np.broadcast_to(x, COUNT) for x in interpreter(every(its), LONG)(rows)])


@cache
def as_pairs(seed: int) -> tuple[np.ndarray, np.ndarray]:
    """hi and lo of all values."""
    its = program(seed)
    carrier = Carrier(its, SINGLE, SCENES)
    for step in its.instructions:
        carrier.carry(step)
    pairs = [(Ref(step.name), carrier.low(step, Ref(step.name)) or ZERO)
             for step in its.instructions]
    size = len(pairs)
    both = replace(its, instructions=tuple(carrier.steps), outputs=(argument("y", 2 * size),),
                   results=tuple(x for each in zip(*pairs, strict=True) for x in each))
    values = [np.broadcast_to(x, COUNT).astype(np.longdouble)
              for x in evaluator(rounded(both, SINGLE), SINGLE)(given())]
    return np.stack(values[:size]), np.stack(values[size:])


@pytest.mark.parametrize("seed", SEEDS)
def test_pairs_are_within_their_bounds(seed):
    its = program(seed)
    bounds = ValueBounds(its, RANGES.sizes(SINGLE), PairRounding(SINGLE), RANGES.quaternions)
    (hi, lo), true = as_pairs(seed), exact(its)
    for step, h, low, x in zip(its.instructions, hi, lo, true, strict=True):
        its_bounds = bounds.by_name[step.name]
        slack = np.longdouble(2)**-60 * its_bounds.size  # of the judge
        assert abs(x).max() <= its_bounds.size + slack, step
        assert abs(h).max() <= its_bounds.computed, step
        assert abs(low).max() <= its_bounds.low, step
        assert abs(h + low - x).max() <= its_bounds.error + slack, step


def test_bounds_of_pairs_are_not_far_from_what_occurs():
    ratios = []
    for seed in SEEDS:
        its = program(seed)
        bounds = ValueBounds(its, RANGES.sizes(SINGLE), PairRounding(SINGLE), RANGES.quaternions)
        (hi, lo), true = as_pairs(seed), exact(its)
        ratios += [float(abs(h + low - x).max() / bounds.by_name[step.name].error)
                   for step, h, low, x in zip(its.instructions, hi, lo, true, strict=True)
                   if bounds.by_name[step.name].error > 2.0**-56]
    assert len(ratios) > 100 and np.median(ratios) > 1e-3 and max(ratios) > 0.05


@pytest.mark.parametrize("seed", SEEDS)
def test_no_mixture_breaks_a_bound(seed):
    its, draw = program(seed), np.random.default_rng(seed)
    true, worst = exact(its)[-1], []
    for part in (0, 0.3, 0.6, 0.9):
        paired = frozenset(step.name for step in its.instructions if draw.random() < part)
        paired |= {step.name for step in its.instructions if step.op in (Op.SIN, Op.COS)
                   and paired & {x.name for x in its.instructions if x.operands == step.operands}}
        kept = frozenset((step.name, n) for step in its.instructions if step.op in CARRYING
                         for n in range(2) if draw.random() < 0.5)
        mixture = Mixture(paired, kept)
        bound, = of_mixture(its, RANGES, SINGLE, mixture)
        got, = evaluator(mixed(its, mixture), SINGLE)(given())
        worst.append(float(abs(got.astype(np.longdouble) - true).max() / bound.error))
    assert 0.05 < max(worst) <= 1, worst
