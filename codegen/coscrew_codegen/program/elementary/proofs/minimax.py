"""Minimax polynomials with coefficients of a format, and proofs of their errors.  Fits are searched
with mpmath on Chebyshev points, with enough digits that every machine finds the same;

a proof is exact and independent of the search."""

from collections.abc import Callable, Sequence
from fractions import Fraction
from math import comb
from typing import Any, TypeAlias

Function: TypeAlias = Callable[[Any], Any]  # of mpmath's numbers
Coefficients: TypeAlias = Sequence[Fraction]  # of a polynomial, the constant first

_DIGITS = 80
_POINTS = 30  # an unknown
_LEVEL = 1.001  # the largest error to the least possible one


def fitted(function: Function, weight: Function, interval: tuple[Fraction, Fraction], degree: int,
           digits: int, given: Coefficients = ()) -> tuple[Fraction, ...]:
    """The polynomial for which the largest weight(x) |p(x) - function(x)| is least.

    Its first coefficients are given; the others are rounded to `digits` bits one after the other,
    the constant first; after each the remaining ones are fitted again."""
    import mpmath

    with mpmath.workdps(_DIGITS):
        points = _points(interval, _POINTS * (degree + 2))
        weights = [abs(weight(x)) for x in points]
        rest = [function(x) for x in points]
        results: list[Fraction] = []
        for index in range(degree + 1):
            if index < len(given):
                results.append(given[index])
            else:
                columns = [[x**i for x in points] for i in range(degree + 1 - index)]
                results.append(rounded(exact(_levelled(columns, rest, weights)[0]), digits))
            rest = [(r - _number(results[-1])) / x for r, x in zip(rest, points, strict=True)]
            weights = [w * abs(x) for w, x in zip(weights, points, strict=True)]
    return tuple(results)


def fitted_denominator(function: Function, weight: Function, interval: tuple[Fraction, Fraction],
                       degrees: tuple[int, int], digits: int) -> tuple[Fraction, ...]:
    """The denominator, 1 + …, of the fraction p/q for which the largest weight |p/q - function| is
    least; p is then to be fitted to function · q with weight / q."""
    import mpmath

    above, below = degrees
    with mpmath.workdps(_DIGITS):
        points = _points(interval, _POINTS * (above + below + 2))
        values = [function(x) for x in points]
        columns = [[x**i for x in points] for i in range(above + 1)]
        columns += [[-y * x**i for x, y in zip(points, values, strict=True)]
                    for i in range(1, below + 1)]
        denominator = [mpmath.mpf(1)] * len(points)
        for _ in range(8):
            weights = [abs(weight(x) / q) for x, q in zip(points, denominator, strict=True)]
            result = _levelled(columns, values, weights)[above + 1:]
            denominator = [1 + sum(c * x**i for i, c in enumerate(result, 1)) for x in points]
        return (Fraction(1), *(rounded(exact(c), digits) for c in result))


def exact(x: Any) -> Fraction:
    """An mpmath number as a fraction."""
    sign, mantissa, exponent, _ = x._mpf_
    return Fraction(-int(mantissa) if sign else int(mantissa)) * Fraction(2)**int(exponent)


def rounded(x: Fraction, digits: int) -> Fraction:
    """x to nearest, in so many significant bits, with no limit to the exponent."""
    if not x:
        return x
    exponent = abs(x.numerator).bit_length() - x.denominator.bit_length()
    exponent -= abs(x) < Fraction(2)**exponent  # 2^exponent <= abs(x) < 2^(exponent + 1)
    unit = Fraction(2)**(exponent + 1 - digits)
    return round(x / unit) * unit


def supremum(p: Coefficients, below: Coefficients, interval: tuple[Fraction, Fraction],
             pieces: int = 64) -> Fraction:
    """A proved bound of |p(x)| / below(x) over the interval, below > 0: on every piece a polynomial
    lies between its least and its largest Bernstein coefficient."""
    lower, upper = interval
    step = (upper - lower) / pieces
    worst = Fraction(0)
    for i in range(pieces):
        piece = lower + i * step, lower + (i + 1) * step
        least = min(bernstein(below, piece))
        if least <= 0:
            raise ValueError("the denominator may not be positive")
        worst = max(worst, max(map(abs, bernstein(p, piece))) / least)
    return worst


def bernstein(p: Coefficients, interval: tuple[Fraction, Fraction]) -> list[Fraction]:
    """The coefficients of p in the Bernstein basis of the interval."""
    lower, upper = interval
    shifted = list(p)
    for i in range(len(p)):  # Horner's scheme, again and again: the Taylor coefficients at lower
        for j in range(len(p) - 2, i - 1, -1):
            shifted[j] += lower * shifted[j + 1]
    n = len(p) - 1
    scaled = [c * (upper - lower)**i for i, c in enumerate(shifted)]
    return [sum((Fraction(comb(k, i), comb(n, i)) * scaled[i] for i in range(k + 1)), Fraction(0))
            for k in range(n + 1)]


def product(p: Coefficients, q: Coefficients) -> list[Fraction]:
    """p q"""
    result = [Fraction(0)] * (len(p) + len(q) - 1)
    for i, a in enumerate(p):
        for j, b in enumerate(q):
            result[i + j] += a * b
    return result


def difference(p: Coefficients, q: Coefficients) -> list[Fraction]:
    """p - q"""
    size = max(len(p), len(q))
    a, b = ([*x, *[Fraction(0)] * (size - len(x))] for x in (p, q))
    return [x - y for x, y in zip(a, b, strict=True)]


def _number(x: Fraction) -> Any:
    import mpmath

    return mpmath.mpf(x.numerator) / x.denominator


def _points(interval: tuple[Fraction, Fraction], count: int) -> list[Any]:
    """Chebyshev's points: none is an end and, for an even number of points, none is 0 in the
    middle."""
    import mpmath

    lower, upper = map(_number, interval)
    count += count % 2
    return [(lower + upper) / 2 - (upper - lower) / 2 * mpmath.cospi(mpmath.mpf(2 * i + 1)
                                                                    / (2 * count))
            for i in range(count)]


def _levelled(columns: Sequence[Sequence[Any]], target: Sequence[Any], weights: Sequence[Any]
              ) -> list[Any]:
    """The c for which the largest weight |Σ c_j column_j - target| is least: Remez' exchange."""
    import mpmath

    unknowns, count = len(columns), len(target)
    chosen = [round(i * (count - 1) / unknowns) for i in range(unknowns + 1)]
    for _ in range(40):
        rows = [[*(column[k] for column in columns), (-1)**n / weights[k]]
                for n, k in enumerate(chosen)]
        *result, level = mpmath.lu_solve(mpmath.matrix(rows),
                                         mpmath.matrix([target[k] for k in chosen]))
        errors = [w * (t - sum(c * column[k] for c, column in zip(result, columns, strict=True)))
                  for k, (t, w) in enumerate(zip(target, weights, strict=True))]
        if max(map(abs, errors)) <= abs(level) * _LEVEL:
            return list(result)
        chosen = _extrema(errors, unknowns + 1)
    raise ArithmeticError("the exchange of points does not end")


def _extrema(errors: Sequence[Any], count: int) -> list[int]:
    """Returns `count` places where errors of alternating signs are largest."""
    results: list[int] = []
    for k, error in enumerate(errors):
        if not results or (error < 0) != (errors[results[-1]] < 0):
            results.append(k)
        elif abs(error) > abs(errors[results[-1]]):
            results[-1] = k
    while len(results) > count:
        sizes = [abs(errors[k]) for k in results]
        least, last = sizes.index(min(sizes)), len(results) - 1
        if least in (0, last) or len(results) == count + 1:
            del results[0 if sizes[0] < sizes[-1] else last]
        else:  # with its smaller neighbour, so that signs alternate
            start = least if sizes[least + 1] < sizes[least - 1] else least - 1
            del results[start:start + 2]
    if len(results) < count:
        raise ArithmeticError("the error has too few extrema: more digits, or a higher degree")
    return results


def ln2() -> tuple[Fraction, Fraction]:
    """Fractions below and above ln 2, 2^-300 apart at most: 2 artanh 1/3."""
    return _odd_series(Fraction(1, 3), 1, 2)


def pi() -> tuple[Fraction, Fraction]:
    """Fractions below and above π, 2^-300 apart at most: 16 arctan 1/5 - 4 arctan 1/239."""
    (a, b), (c, d) = (_odd_series(Fraction(1, n), -1, scale) for n, scale in ((5, 16), (239, 4)))
    return a - d, b - c


def _odd_series(x: Fraction, sign: int, scale: int) -> tuple[Fraction, Fraction]:
    """Bounds of scale Σ sign^i x^(2i+1) / (2i+1), 0 < x <= 1/3: the rest is less than a term."""
    total, power, i = Fraction(0), x, 0
    while scale * power > Fraction(1, 2**310):
        total += sign**i * power / (2 * i + 1)
        power, i = power * x * x, i + 1
    rest = power
    return scale * (total - rest), scale * (total + rest)
