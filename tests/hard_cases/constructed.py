"""Constructed hard cases: the numbers in tests/hard_cases that were not found by a search.

`python -m tests.hard_cases.constructed` puts them into the corpus: the same numbers on every
machine, since they are computed in 60 digits and rounded once.
"""

from collections.abc import Callable, Iterator, Sequence

import mpmath as mp
import numpy as np

from coscrew_codegen.algebra.exact import is_polynomial
from coscrew_codegen.algebra.operations import Operation
from coscrew_codegen.program.values.formats import DOUBLE, PRECISIONS, Precision
from coscrew_codegen.program.values.quantity import FRACTION, ROTATION, TURN, UNIT_VECTOR, Argument
from tests.hard_cases.corpus import TABLE, Case, load, save, size
from tests.support.truth.attack import TIERED, exact_functions
from tests.support.truth.motions import (
    DIGITS,
    Matrix,
    exponential_series,
    hstack,
    norm,
    quaternion_exp,
    skew,
)

Numbers = Sequence[mp.mpf | float]
Described = tuple[str, list[Numbers]]  # (origin, the components of each input)

ORIGIN = "constructed:"
SKEWED = (3, -5, 7)
AXES = ((1, 0, 0), (0, -1, 0), (0, 0, 1), (1, 1, 0), (0, 1, -1), (1, 2, 3), (-2, 1, 2),
        (1, mp.mpf(2)**-30, mp.mpf(2)**-70))
ANGLES: dict[str, Callable[[], mp.mpf]] = {
    "0": lambda: mp.mpf(0), "1e-30": lambda: mp.mpf("1e-30"), "1e-12": lambda: mp.mpf("1e-12"),
    "1e-5": lambda: mp.mpf("1e-5"), "0.1": lambda: mp.mpf("0.1"), "π/2": lambda: mp.pi / 2,
    "2": lambda: mp.mpf(2), "2 + 2^-20": lambda: 2 + mp.mpf(2)**-20, "3": lambda: mp.mpf(3),
    "π - 1e-4": lambda: mp.pi - mp.mpf("1e-4"), "π - 1e-8": lambda: mp.pi - mp.mpf("1e-8"),
    "π - 1e-12": lambda: mp.pi - mp.mpf("1e-12"), "π": lambda: +mp.pi}
FAR: dict[str, Callable[[], mp.mpf]] = {  # the last two are next to multiples of π/2
    "4": lambda: mp.mpf(4), "2π": lambda: 2 * mp.pi,
    "2π + 1e-6": lambda: 2 * mp.pi + mp.mpf("1e-6"),
    "40": lambda: mp.mpf(40), "1e3": lambda: mp.mpf(1000), "99999": lambda: mp.mpf(99999),
    "31831 π": lambda: 31831 * mp.pi, "63661 π/2": lambda: 63661 * mp.pi / 2}
SERIES: dict[str, Callable[[], mp.mpf]] = {  # where those of the accurate tier end
    "1 - 2^-20": lambda: 1 - mp.mpf(2)**-20, "1 + 2^-20": lambda: 1 + mp.mpf(2)**-20,
    "2 - 2^-20": lambda: 2 - mp.mpf(2)**-20}
FARTHER: dict[str, Callable[[], mp.mpf]] = {  # in double precision
    "1e6": lambda: mp.mpf(10)**6, "636619 π/2": lambda: 636619 * mp.pi / 2,
    "1e10": lambda: mp.mpf(10)**10, "9.9e12": lambda: mp.mpf("9.9e12")}


def constructed() -> Iterator[Case]:
    """All cases, in both precisions."""
    with mp.workdps(DIGITS):
        for operation in TABLE.values():
            for origin, inputs in _described(operation):
                for precision in PRECISIONS:
                    yield _case(operation, precision, origin, inputs)
            if any(a.domain == TURN for a in operation.inputs):
                for origin, inputs in _motions(operation, FARTHER):
                    yield _case(operation, DOUBLE, origin, inputs)
            for precision in PRECISIONS:
                yield from _of_range(operation, precision)


def _case(operation: Operation, precision: Precision, origin: str, inputs: list[Numbers]) -> Case:
    dtype = np.dtype(precision.numpy_type)
    flat = tuple(float(dtype.type(float(x))) for numbers in inputs for x in numbers)
    if len(flat) != size(operation):
        raise ValueError(f"{operation.name}, {origin}: {len(flat)} of {size(operation)} components")
    return Case(operation, precision, flat, f"{ORIGIN} {origin}")


def _described(operation: Operation) -> Iterator[Described]:
    if operation.normwise or not is_polynomial(operation) and any(
            a.domain == ROTATION for a in operation.inputs):
        far = FAR if any(a.domain == TURN for a in operation.inputs) else {}
        yield from _motions(operation, ANGLES | far | SERIES, AXES)
        yield from _no_rotations(operation)
    if operation.name in _CANCELLING:
        yield from _CANCELLING[operation.name]()


# Motions: all sizes of angles, half turns about axes and between them, no rotations.


def _motions(operation: Operation, angles: dict[str, Callable[[], mp.mpf]],
             half_turns: Sequence[Numbers] = ()) -> Iterator[Described]:
    turns = [(name, angle(), AXES[i % len(AXES)]) for i, (name, angle) in enumerate(angles.items())]
    turns += [("π", +mp.pi, axis) for axis in half_turns]
    for number, (name, angle, axis) in enumerate(turns):
        unit = mp.matrix(axis) / norm(mp.matrix(axis))
        lever = mp.matrix(SKEWED) * (1, mp.mpf(10)**6, mp.mpf(10)**-6)[number % 3]
        inputs = [_turned(operation, a, unit, angle, lever, i)
                  for i, a in enumerate(operation.inputs)]
        yield f"θ = {name}, axis {', '.join(map(mp.nstr, axis))}", inputs


def _no_rotations(operation: Operation) -> Iterator[Described]:
    """Matrices that differ from rotations by more and by less than rounding errors."""
    if {a.quantity.name for a in operation.inputs} & {"mat3x3", "SE3"}:
        for digits in (2, 4, 8, 12):
            yield f"R off by 1e-{digits}", [_spoiled(operation, a, mp.mpf(10)**-digits)
                                            for a in operation.inputs]


def _turned(operation: Operation, argument: Argument, unit: Matrix, angle: mp.mpf, lever: Matrix,
            number: int) -> Numbers:
    """The inputs for a rotation by this angle; of two displacements or quaternions the first is
    arbitrary, and the second is rotated by the angle from it."""
    pair = len(operation.inputs) == 3
    first = mp.matrix([1, -2, 2]) / 3
    R = mp.chop(exponential_series(skew(unit * angle)), 1e-40)  # half a turn leaves zeros
    q = mp.chop(quaternion_exp(unit * angle), 1e-40)
    if pair and number == 0:
        R, q = exponential_series(skew(first)), mp.matrix([0, 0, 0, 1])
    elif pair and number == 1:
        R = exponential_series(skew(first)) * R
    return {"vec3": lambda: unit if argument.domain == UNIT_VECTOR else unit * angle,
            "scalar": lambda: [mp.mpf("0.375") if argument.domain == FRACTION else angle],
            "mat3x3": lambda: R, "SE3": lambda: hstack(R, lever * (1 + number)),
            "screw": lambda: [*lever, *(unit * angle)],
            "quaternion": lambda: q}[argument.quantity.name]()


def _spoiled(operation: Operation, argument: Argument, by: mp.mpf) -> Numbers:
    noise = mp.matrix([[1, -2, 3], [2, 1, -1], [-3, 1, 2]]) * by / 3
    R = exponential_series(skew(mp.matrix([1, -2, 0.5]))) + noise
    return {"mat3x3": lambda: R, "SE3": lambda: hstack(R, mp.matrix(SKEWED)),
            "scalar": lambda: [mp.mpf("0.375")]}[argument.quantity.name]()


# Results that cancel.


def _lever_arms(matrix: bool, sign: int, screw: bool) -> Iterator[Described]:
    """|t| = 1e6 m and τ = ∓ t × f, rounded: the new moment nearly vanishes."""
    R = exponential_series(skew(mp.matrix([0.3, -1.1, 0.7]))) if matrix else mp.eye(3)
    for length in (10**3, 10**6, 10**9):
        t = mp.matrix([2, -1, 2]) * length / 3
        f = mp.matrix(SKEWED) / 7
        turned = (R if sign < 0 else mp.eye(3)) * f
        moment = sign * skew(t) * turned
        moment = R.T * moment if sign < 0 else moment
        pair = [*moment, *f] if screw else [*f, *moment]
        where = hstack(R, t) if matrix else t
        yield f"lever arm {length:.0e} m, moment = {'∓±'[sign > 0]} t × f", [where, pair]


def _parallel(size: int) -> Iterator[Described]:
    """The second vector is the first, perturbed by 1e-5, 1e-8, 1e-16, 0."""
    for gap in ("1e-5", "1e-8", "1e-16", "0"):
        a = [mp.mpf(x) / 3 for x in (2, 5, -7, 11, -13, 17)][:size]
        yield f"parallel except for {gap}", [a, [x * (1 + (-1)**i * mp.mpf(gap) * (i + 1))
                                              for i, x in enumerate(a)]]


def _multiples(size: int) -> Iterator[Described]:
    """Parallel and antiparallel, rounded: cross products that are zero except for rounding errors.
    """
    yield from _parallel(size)
    for numbers in ((1, 2, 3, -5, 8, 2), (7, -11, 13, 1, 5, -3), (2, 5, -7, 3, 1, 9)):
        a = numbers[:size]
        yield "one is -1 of the other", [a, [-v for v in a]]
        for k in (3, -7, mp.mpf(1) / 3, -mp.mpf(1) / 11):
            x = [mp.mpf(v) / 3 for v in a]
            yield f"one is {mp.nstr(mp.mpf(k), 3)} of the other, except for roundings", [
                x, [k * float(v) for v in x]]


def _perpendicular(size: int) -> Iterator[Described]:
    for gap in ("1e-8", "1e-16", "0"):
        a = [mp.mpf(x) / 3 for x in (2, 5, -7, 11, -13, 17)][:size]
        b = [mp.mpf(x) / 7 for x in (3, 1, 2, -1, 5, 0)][:size]
        b[-1] = -mp.fsum(x * y for x, y in zip(a[:-1], b[:-1], strict=True)) / a[-1]
        b[0] *= 1 + mp.mpf(gap)
        yield f"perpendicular except for {gap}", [a, b]


def _singular() -> Iterator[Described]:
    """Rows of rank 2, perturbed by the gap: the condition is at least its inverse."""
    for gap in ("1e-8", "1e-16", "0"):
        x, y = [mp.mpf(v) / 7 for v in (1, 2, 3)], [mp.mpf(v) / 3 for v in (4, -5, 6)]
        z = [(a + b) * (1 + mp.mpf(gap) * (i + 1)) for i, (a, b) in
             enumerate(zip(x, y, strict=True))]
        yield f"third row is the sum of two except for {gap}", [[*x, *y, *z]]


def _sheared() -> Iterator[Described]:
    """Far from rotations: nearly dependent rows; rows of very different lengths; left-handed rows.
    """
    yield from _singular()
    yield "2^-30 R", [exponential_series(skew(mp.matrix([1, -2, 2]))) * mp.mpf(2)**-30]
    yield "a reflection", [[1, 0, 0, 0, 1, 0, 0, 0, -1]]
    yield "a reflection, turned", [-exponential_series(skew(mp.matrix([1, -2, 2])))]
    for gap in ("1e-3", "1e-7", "1e-14"):
        third = mp.mpf(gap)
        yield f"rows parallel except for {gap}", [
            [1, 2, 3, 1 + third, 2 - third, 3, -1, -2, -3 - third]]
    yield "rows of length 1e-12, 1, 1e12", [
        [mp.mpf(x) * mp.mpf(10)**e for e, row in
         ((-12, (1, 2, 3)), (0, (-3, 1, 2)), (12, (2, -1, 5))) for x in row]]


def _opposite() -> Iterator[Described]:
    """Quaternions of one rotation with both signs, except for rounding errors: no rotation between
    them."""
    for k in ("0.375", "1"):
        q = quaternion_exp(mp.matrix([1, -2, 2]) / 3)
        yield f"q = -p, k = {k}", [q, -q, [mp.mpf(k)]]
        near = quaternion_exp(mp.matrix([1, -2, 2]) * (1 + mp.mpf("1e-9")) / 3)
        yield f"q = -p except for 1e-9, k = {k}", [q, -near, [mp.mpf(k)]]


def _cancelled(k: int) -> Iterator[Described]:
    """a x + y = 0, exactly or except for a rounding error."""
    x = [mp.mpf(2 * i + 3) for i in range(k)]
    yield "a x + y = 0", [[mp.mpf(3)], x, [-3 * v for v in x]]
    yield "a x + y = 0 except for roundings", [[mp.mpf(1) / 3], x, [-v / 3 for v in x]]


_CANCELLING: dict[str, Callable[[], Iterator[Described]]] = {
    "product_CoAdc": lambda: _lever_arms(True, -1, False),
    "product_CoAdinvc": lambda: _lever_arms(True, 1, False),
    "product_CoAdtc": lambda: _lever_arms(False, -1, False),
    "product_CoAdtinvc": lambda: _lever_arms(False, 1, False),
    "product_Ads": lambda: _lever_arms(True, -1, True),
    "product_Adinvs": lambda: _lever_arms(True, 1, True),
    "product_Adts": lambda: _lever_arms(False, -1, True),
    "product_Adtinvs": lambda: _lever_arms(False, 1, True),
    "cross_vv": lambda: _multiples(3), "cross_vvinv": lambda: _multiples(3),
    "cross_ss": lambda: _multiples(6), "cross_sst": lambda: _multiples(6),
    "cross_sc": lambda: _multiples(6), "cross_sca": lambda: _multiples(6),
    "angle_vv": lambda: _multiples(3),
    "dot_vv": lambda: (*_perpendicular(3), *_multiples(3)),
    "dot_cs": lambda: (*_perpendicular(6), *_multiples(6)),
    "dot_qq": lambda: (*_perpendicular(4), *_multiples(4)),
    "reciprocal_product": lambda: (*_perpendicular(6), *_multiples(6)),
    "quaternion_interpolated": _opposite,
    "mat3x3_determinant": _singular, "mat3x3_normalize": _sheared,
    "mat3x3_normalized": _sheared,
    "axpy_vv": lambda: _cancelled(3), "axpy_ss": lambda: _cancelled(6),
    "axpy_cc": lambda: _cancelled(6),
}


# The ends of the range: subnormal and infinite results, norms of vectors whose squares overflow.


def _of_range(operation: Operation, precision: Precision) -> Iterator[Case]:
    info, n = np.finfo(precision.numpy_type), size(operation)
    signs = [(-1)**(i * i // 3) * (1 + mp.mpf(i) / 16) for i in range(n)]
    if operation in TIERED:
        yield from _scaled(operation, precision, signs)
        degree = max(2, _degree(operation))
        exponents = ((info.minexp - 12) // degree, (info.maxexp - 3) // degree + 1)
    elif operation.name == "mat3x3_from_quaternion":
        exponents = (-448, 509) if precision == DOUBLE else (-43, 61)
    elif operation.name in ("quaternion_log", "axis_angle_from_quaternion"):
        exponents = (info.minexp - info.nmant + 5, info.minexp, info.minexp + 20, info.maxexp - 6)
    elif operation.name == "angle_vv" or "norm" in operation.name:
        exponents = (info.minexp - info.nmant + 5, info.minexp, info.maxexp - 6)
    else:
        return
    for exponent in exponents:
        yield _case(operation, precision, f"components of size 2^{exponent}",
                    [[x * mp.mpf(2)**exponent for x in signs]])


def _scaled(operation: Operation, precision: Precision, signs: Numbers) -> Iterator[Case]:
    """The first input is so large that splitting it into halves of 26 bits would overflow, and the
    others are small; or the first is subnormal; and vice versa.  Products are of ordinary size."""
    first = operation.inputs[0].quantity.size
    large, subnormal = (1000, -1060) if precision == DOUBLE else (120, -140)
    if first == len(signs):
        return
    for one, other in ((large, -large), (-large, large), (subnormal, 0), (0, subnormal)):
        sizes = [one if i < first else other for i in range(len(signs))]
        yield _case(operation, precision, f"2^{one} {operation.inputs[0].name}, others 2^{other}",
                    [[x * mp.mpf(2)**e for x, e in zip(signs, sizes, strict=True)]])


def _degree(operation: Operation) -> int:
    """The largest number of inputs that a term of the result multiplies, found by doubling all
    inputs."""
    n, result = size(operation), 1
    for _, absolute in exact_functions(operation):
        one, two = absolute(*[1] * n), absolute(*[2] * n)
        while two > one * 2**result:
            result += 1
    return result


def main() -> None:
    """Replace the constructed cases in the corpus by these."""
    others = tuple(case for case in load() if not case.origin.startswith(ORIGIN))
    cases = tuple(constructed())
    save((*cases, *others))
    print(f"{len(cases)} cases constructed, {len(others)} others")


if __name__ == "__main__":
    main()
