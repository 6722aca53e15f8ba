"""Toy formats: so few digits that errors of second order matter, and so few exponents that much
underflows.  Programs are evaluated in them on arrays of doubles, whose own rounding does
not matter there; the truth in long double.  Searches for the inputs where
errors come closest to certified bounds."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

from coscrew_codegen.program import Constant, Op, Program
from coscrew_codegen.program.interpreter import Arithmetic, by_operation, exactly, interpreter
from coscrew_codegen.program.values.formats import Format

Array = NDArray[Any]
KEPT, ROWS = 64, 512
WRONG = 250
"""What functions err by is wrong by so many u²."""


@dataclass(frozen=True)
class Toy(Format):
    """A format with the members of a precision that tiers use."""

    def value(self, constant: Constant) -> Fraction:
        """Its value, not yet rounded."""
        return constant.double

    def rounded(self, value: Fraction) -> float:
        """The nearest number."""
        return float(rounded(np.asarray(value.numerator / value.denominator), self))


def rounded(x: Array, toy: Format) -> Array:
    """To nearest, ties to even; subnormal numbers have fewer digits."""
    x = np.asarray(x, np.float64)
    exponent = np.maximum(np.frexp(x)[1] - 1, toy.least_exponent)
    near = np.ldexp(np.rint(np.ldexp(x, toy.digits - 1 - exponent)), exponent - toy.digits + 1)
    return np.where(np.isfinite(x), near, x)


def arithmetic(toy: Toy) -> Arithmetic[Any]:
    """Every operation rounded once, functions and their error functions, too."""
    def once(function: Callable[..., Any]) -> Callable[..., Any]:
        return lambda *operands: rounded(function(*operands), toy)

    def error(function: Callable[..., Any]) -> Callable[..., Any]:
        wrong = 1 + WRONG * float(toy.u)**2
        return once(lambda *x: function(*x[:-1]) * wrong - x[-1])

    table = {op: once(function) for op, function in exactly(np).items()}
    return by_operation(lambda x: np.float64(toy.rounded(x.double)), {
        **table, Op.LESS: np.less, Op.EQUAL: np.equal, Op.SELECT: np.where,
        Op.PRODUCT_ERROR: once(lambda a, b, p: a * b - p),
        Op.PRODUCT_REST: once(lambda a, b, p, h: a * b - h),
        Op.SIN_ERROR: error(np.sin), Op.COS_ERROR: error(np.cos), Op.EXP_ERROR: error(np.exp),
        Op.TANH_ERROR: error(np.tanh), Op.ATAN2: once(np.arctan2),
        Op.ATAN2_ERROR: error(np.arctan2)}, np.nan)


def _longdouble(x: Fraction) -> np.longdouble:
    return np.longdouble(x.numerator) / np.longdouble(x.denominator)


TRUE: Arithmetic[Any] = by_operation(
    lambda x: _longdouble(x.double + x.tail),
    {**exactly(np), Op.SELECT: np.where, Op.ATAN2: np.arctan2}, np.longdouble(np.nan))


@dataclass(frozen=True)
class Judged:
    """Error / bound of each result of each row; NaN without a statement."""

    ratios: Array
    same: bool  # whether results are the plain ones
    outputs: int  # with a statement

    @property
    def worst(self) -> float:
        return float(np.nanmax(self.ratios, initial=0))


def judge(plain: Program, certified: Program, toy: Toy) -> Callable[[Array], Judged]:
    """The function from inputs, one row a call, to errors in bounds."""
    runs = [interpreter(program, arithmetic(toy)) for program in (plain, certified)]
    true, count = interpreter(plain, TRUE), len(plain.results)
    stops = np.cumsum([a.quantity.size for a in plain.inputs])[:-1]

    def judged(rows: Array) -> Judged:
        def table(run: Any, kind: type) -> Array:
            parts: list[Array] = np.split(rows.T.astype(kind), stops)
            given = [list(part) for part in parts]
            return np.stack([np.broadcast_to(x, len(rows)) for x in run(given)])

        with np.errstate(all="ignore"):
            expected, result = (table(run, np.float64) for run in runs)
            results, bounds = result[:count], result[count:]
            errors = np.abs(table(true, np.longdouble) - results)
            stated = np.isfinite(bounds) & np.isfinite(errors)
            ratios = np.where(errors == 0, 0, errors / bounds)
        same = np.array_equal(expected, results, equal_nan=True)
        return Judged(np.where(stated, ratios, np.nan), same, int(stated.sum()))

    return judged


def climbs(judged: Callable[[Array], Judged], width: int, toy: Toy, seed: int, rounds: int
           ) -> Iterator[Judged]:
    """Rounds of a search: changed last bits, exponents, signs; numbers that cancel."""
    rng = np.random.default_rng(seed)
    parents, fitness = np.empty((0, width)), np.empty(0)
    for _ in range(rounds):
        fresh = _drawn(rng, width, toy)
        children = _changed(rng, parents, toy) if len(parents) else fresh[:0]
        rows = np.concatenate([fresh, children])
        result = judged(rows)
        yield result
        pool = np.concatenate([parents, rows])
        marks = np.concatenate([fitness, np.nan_to_num(result.ratios).max(axis=0, initial=0)])
        kept = np.argsort(-marks, kind="stable")[:KEPT]
        parents, fitness = pool[kept], marks[kept]


def _drawn(rng: np.random.Generator, width: int, toy: Toy) -> Array:
    """Numbers of every size; half of the rows of size 1; some 0 or 1/3, some next to others."""
    rows = rng.uniform(-2, 2, (ROWS // 2, width))
    wide = rows * 2.0**rng.integers(toy.least_exponent - toy.digits, 12, rows.shape)
    chosen = np.where(rng.random((len(rows), 1)) < 0.5, rows, wide)
    chosen[rng.random(chosen.shape) < 0.03] = 0
    chosen[rng.random(chosen.shape) < 0.03] = 1 / 3
    return rounded(_cancelling(rng, chosen, toy), toy)


def _cancelling(rng: np.random.Generator, rows: Array, toy: Toy) -> Array:
    near = rows[:, rng.permutation(rows.shape[1])] * rng.choice(
        (1, -1, 1 / 3, -1 / 3), rows.shape)
    near = near * (1 + rng.integers(-4, 5, rows.shape) * 2 * float(toy.u))
    return np.where(rng.random(rows.shape) < 0.3, near, rows)


def _changed(rng: np.random.Generator, parents: Array, toy: Toy) -> Array:
    rows = np.repeat(parents, ROWS // KEPT, axis=0)
    bits = 1 + rng.integers(-3, 4, rows.shape) * 2 * float(toy.u)
    scale = 2.0**rng.integers(-3, 4, rows.shape) * rng.choice((-1, 1), rows.shape)
    kind = rng.random(rows.shape)
    rows = rows * np.where(kind < 0.3, bits, np.where(kind < 0.4, scale, 1))
    return rounded(_cancelling(rng, rows, toy), toy)
