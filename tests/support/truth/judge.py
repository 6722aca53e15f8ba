"""Errors relative to the stated bounds: proven, normwise, relative.

Truth is exact rationals for polynomial operations (attack.py) and 60 digits for all others
(truths.py).  Where numbers leave the range of the precision, what rounding to subnormal numbers
may add is allowed, and infinities or NaN where an intermediate result may overflow.
"""

import functools
import math
from collections.abc import Sequence
from dataclasses import dataclass

import mpmath as mp
import numpy as np
from gmpy2 import mpq

from coscrew_codegen.accuracy.tiers import tier_named
from coscrew_codegen.algebra.exact import UNIT, exact_functions
from coscrew_codegen.algebra.operations import OPERATIONS, Operation
from coscrew_codegen.program import Program
from coscrew_codegen.program.values.formats import Precision
from tests.support.domains import angle, defect
from tests.support.truth import backward
from tests.support.truth.attack import TIERED, bounds, plain_program
from tests.support.truth.motions import DIGITS
from tests.support.truth.truths import (
    ROUNDED,
    Components,
    of_given,
    other_way,
    truth,
)

# k of |x̂ - x| <= k u |x| in the plain tier: n squares and their sum have an error of n u, the root
# half of that and its own rounding, a quotient one rounding more.
_PARTS = {"vec3": 3, "screw": 3, "coscrew": 3, "quaternion": 4}
RELATIVE: dict[str, float] = {
    "product_ainvv": 1, "dc": 2, "angle_vv": 4, "vec3_l2norm": 2.5,
    **{f"{kind}_norm": n / 2 + 1 for kind, n in _PARTS.items()},
    **{f"{kind}_{verb}": n / 2 + 2 for kind, n in _PARTS.items()
       for verb in ("normalize", "normalized")}}
FLOOR = {("angle_vv", "plain"): 1.0}  # a cross product cancels; the accurate tier's does not
DEFECT = 4  # a result may be this many times as far from a rotation as its input
FREE = 8  # defect in u that k of the plain tier covers


@dataclass(frozen=True)
class Group:
    """A bound of (k + θ slope) u M on the error of each of the output components `places`, where M
    is the largest of them, of these components of inputs, and of `floor`."""

    places: tuple[int, ...]
    k: float
    inputs: tuple[int, ...] = ()
    floor: float = 0
    slope: float = 0


JUDGED = tuple(op for op in OPERATIONS if op in TIERED or op.normwise
               or op.name in RELATIVE or op.name in backward.BACKWARD)


@functools.cache
def tier_program(operation: Operation, precision: Precision, tier: str) -> Program:
    """The tier's program."""
    return tier_named(tier).program(plain_program(operation), precision)


@functools.cache
def groups(operation: Operation, tier: str) -> tuple[Group, ...]:
    """The bounds of an operation that is not polynomial."""
    size = sum(a.quantity.size for a in operation.outputs)
    if operation.name in RELATIVE:
        k = 1 if tier == "accurate" else RELATIVE[operation.name]
        floor = FLOOR.get((operation.name, tier), 0)
        return tuple(Group((i,), k, floor=floor) for i in range(size))
    names = [{a.name, a.quantity.parts[a.quantity.place(*place)[0]].name}
             for a in operation.outputs for place in a.quantity.indices]
    inputs = [f"{a.name}.{a.quantity.parts[a.quantity.place(*place)[0]].name}"
              for a in operation.inputs for place in a.quantity.indices]
    return tuple(Group(tuple(i for i in range(size) if bound.part in names[i]), bound.k,
                       tuple(i for i, name in enumerate(inputs) if name in bound.beside),
                       slope=1 / bound.per_angle if bound.per_angle else 0)
                 for bound in tier_named(tier).operation(operation).normwise)


def ratio(operation: Operation, precision: Precision, tier: str, given: Sequence[float],
          got: Sequence[float]) -> float:
    """The largest error of a row relative to its bound.  Certified kernels return plain's results,
    then their bounds."""
    if tier == "certified":
        half = len(got) // 2
        return max(ratio(operation, precision, "plain", given, got[:half]),
                   _certified(operation, precision, given, got[:half], got[half:]))
    if operation in TIERED:
        return _polynomial(operation, precision, tier, given, got)
    if operation.name in backward.BACKWARD:
        slack = DEFECT * _defect_in_u(operation, precision, given)
        return backward.ratio(operation, precision, given, got, slack)
    try:
        expected = truth(operation, precision, tuple(given))
    except ZeroDivisionError:
        return 0.0  # there is no bound for division by zero
    result = _normwise(operation, precision, tier, given, got, expected)
    if result > 1:
        near = 32 + DEFECT * _defect_in_u(operation, precision, given)
        other = other_way(operation, given, near * float(UNIT[precision.name]))
        if other is not None:
            result = min(result, _normwise(operation, precision, tier, given, got, other))
    return result


def _polynomial(operation: Operation, precision: Precision, tier: str, given: Sequence[float],
                got: Sequence[float]) -> float:
    u, values, worst = UNIT[precision.name], [mpq(x) for x in given], 0.0
    magnitudes = [abs(x) for x in values]
    largest = [max(mpq(1), x) for x in magnitudes]
    lost = _underflow(operation, precision, tier, magnitudes)
    for bound, (exact, absolute), result in zip(bounds(operation, precision, tier),
                                                exact_functions(operation), got, strict=True):
        if not math.isfinite(result):
            worst = max(worst, 0.0 if absolute(*largest) >= _limit(precision) else math.inf)
            continue
        error = abs(mpq(result) - exact(*values))
        allowed = ((u * abs(mpq(result)) if bound.rounded else 0) + lost
                   + (mpq(bound.c1) * u + mpq(bound.c2) * u * u) * absolute(*magnitudes)
                   * (1 + 1024 * u))
        if error:
            worst = max(worst, float(error / allowed) if allowed else math.inf)
    return worst


def _certified(operation: Operation, precision: Precision, given: Sequence[float],
               got: Sequence[float], bounds: Sequence[float]) -> float:
    """A bound that is not finite makes no statement."""
    values, worst = [mpq(x) for x in given], 0.0
    if operation not in TIERED:
        return max(in_bounds(operation, precision, given, got, bounds), default=0.0)
    for (exact, _), result, bound in zip(exact_functions(operation), got, bounds, strict=True):
        if math.isfinite(bound):
            error = abs(mpq(result) - exact(*values))
            worst = max(worst, float(error / mpq(bound)) if bound else math.inf if error else 0.0)
    return worst


def in_bounds(operation: Operation, precision: Precision, given: Sequence[float],
              got: Sequence[float], bounds: Sequence[float]) -> list[float]:
    """The errors of components with a finite bound, as parts of it."""
    with mp.workdps(DIGITS):
        true = of_given(operation, precision, tuple(given))
        if any(map(mp.isnan, true)):
            return []
        own = mp.mpf(2)**-96 * max(map(abs, (*true, *given))) if any(
            a.domain in ROUNDED for a in operation.inputs) else 0  # the truth's, of series
        return [float(error / bound) if bound else math.inf if error else 0.0
                for x, y, bound in zip(true, got, bounds, strict=True) if math.isfinite(bound)
                and not _is_other_sign(x, y) for error in [max(abs(x - y) - own, mp.mpf(0))]]


def _is_other_sign(x: mp.mpf, y: float) -> bool:
    """Returns whether these are π and -π: the sign of a zero says which, and exact zeros have none.
    """
    return bool(abs(abs(x) - mp.pi) < 1e-6 and abs(x + y) < 1e-6)


def _limit(precision: Precision) -> mpq:
    """Below it nothing overflows, nor a number split by a factor of 2^27 + 1."""
    return mpq(float(np.finfo(precision.numpy_type).max)) / 2**30


def _underflow(operation: Operation, precision: Precision, tier: str,
               magnitudes: Sequence[mpq]) -> mpq:
    """The error that rounding to subnormal numbers may add.  It is zero if no product of inputs
    comes near them, even after cancellation and in rounding errors."""
    info, u = np.finfo(precision.numpy_type), UNIT[precision.name]
    degree = max(len(m) for bound in bounds(operation, precision, "plain") for m in bound.terms)
    smallest = min([mpq(1), *filter(None, magnitudes)])
    if smallest**degree * u**(2 * degree) > mpq(float(info.tiny)):
        return mpq(0)
    steps = 4 * len(tier_program(operation, precision, tier).instructions)
    return steps * mpq(float(info.smallest_subnormal)) * max(1, *magnitudes)**degree


def _normwise(operation: Operation, precision: Precision, tier: str, given: Sequence[float],
              got: Sequence[float], expected: Components) -> float:
    info, u, worst = np.finfo(precision.numpy_type), float(UNIT[precision.name]), 0.0
    free = 0 if tier == "accurate" else FREE
    slack = DEFECT * _defect_in_u(operation, precision, given, free) if operation.normwise else 0.0
    lost = 16 * mp.mpf(float(info.smallest_subnormal))
    for group in groups(operation, tier):
        size = max(group.floor, *(abs(expected[i]) for i in group.places),
                   *(abs(given[i]) for i in group.inputs))
        k = group.k + group.slope * angle(operation, given)
        allowed = (k + slack) * u * (1 + 1024 * u) * size + lost
        for i in group.places:
            if math.isfinite(got[i]):
                worst = max(worst, float(abs(mp.mpf(got[i]) - expected[i]) / allowed))
            elif size < info.max / 64:
                return math.inf
    return worst


def _defect_in_u(operation: Operation, precision: Precision, given: Sequence[float],
                 free: float = FREE) -> float:
    """The defect of rotations and unit vectors among the inputs, beyond the allowed one."""
    return max(0.0, defect(operation, given) / float(UNIT[precision.name]) - free)
