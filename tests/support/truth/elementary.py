"""Elementary functions' Programs on NumPy's arrays, and their errors against MPFR."""

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from functools import cache, partial
from pathlib import Path
from typing import Any

import gmpy2
import numpy as np
from numpy.typing import NDArray

from coscrew_codegen.program import Constant, Op, Program
from coscrew_codegen.program.elementary import ELEMENTARY, ERRORS, Elementary
from coscrew_codegen.program.elementary.elementary_calls import FUNCTION_OF
from coscrew_codegen.program.elementary.sincos import FUNCTION as SINCOS
from coscrew_codegen.program.interpreter import Arithmetic, by_operation, exactly, interpreter
from coscrew_codegen.program.two_over_pi import chunks
from coscrew_codegen.program.values.formats import Precision

Array = NDArray[Any]
BITS = 240  # of the truth
EXP_ENDS = {"double": (-745.1332191019412, -708.3964185322641, 709.782712893384),
            "single": (-103.97208, -87.33654, 88.72284)}  # of results above 0, normal, finite
_CASES = Path(__file__).parents[2] / "elementary" / "worst_cases.txt"


def arithmetic(precision: Precision) -> Arithmetic[Any]:
    """NumPy's, every operation rounded to the precision."""
    number = getattr(np, precision.numpy_type)

    def constant(x: Constant) -> Any:
        value = precision.value(x)
        rounded = number(value.numerator / value.denominator)
        assert value == 0 or float(rounded).as_integer_ratio() == value.as_integer_ratio(), value
        return rounded

    table: Mapping[Op, Callable[..., Any]] = {
        **exactly(np), Op.COPYSIGN: np.copysign, Op.SELECT: np.where,
        Op.POWER: lambda a, b: _power(a, precision),
        Op.TWO_OVER_PI: lambda x, n, digits: _chunk(x, int(n), precision),
        Op.PRODUCT_ERROR: lambda a, b, p: _product_error(a, b, p, precision),
        **{op: partial(_called, op, precision) for op in FUNCTION_OF}}
    return by_operation(constant, table, number(np.nan))


def _called(op: Op, precision: Precision, *operands: Array) -> Array:
    """The results of our own function for this operation."""
    function = next(x for x in (*ELEMENTARY, *ERRORS) if x.name == FUNCTION_OF[op])
    if op in (Op.SIN_ERROR, Op.COS_ERROR):  # these take both results
        operands = operands[0], *results(SINCOS, precision, operands[0])
    return results(function, precision, *operands)[op in (Op.COS, Op.COS_ERROR)]


def _power(a: Array, precision: Precision) -> Array:
    """2^(a - b) by bits: those of b end in zeros, which the shift leaves."""
    kind = np.dtype(f"u{precision.bytes}").type
    bits = np.asarray(a).view(kind) << kind(precision.digits - 1)
    one = np.ones((), precision.numpy_type).view(kind)
    return (bits + one).view(precision.numpy_type)


def _chunk(x: Array, n: int, precision: Precision) -> Array:
    """The chunk of 2/π that is n after that with which x begins."""
    some = chunks(precision.digits)
    table = np.array([float(value) for value in some.values], precision.numpy_type)
    kind = np.dtype(f"u{precision.bytes}").type
    biased = np.asarray(x).view(kind) << kind(1) >> kind(precision.digits)
    return table[(biased - kind(1 - precision.least_exponent + some.offset)) // kind(some.bits)
                 + kind(n)]


def _product_error(a: Array, b: Array, p: Array, precision: Precision) -> Array:
    """a b - p rounded once: by Veltkamp's splitting, or where that underflows in rationals."""
    factor = getattr(np, precision.numpy_type)(2**((precision.digits + 1) // 2) + 1)

    def split(x: Array) -> tuple[Array, Array]:
        c = factor * x
        high = c - (c - x)
        return high, x - high

    (ah, al), (bh, bl) = split(a), split(b)
    result = np.array(al * bl - (((p - ah * bh) - al * bh) - ah * bl))
    small = (np.abs(p) < 2.0**(precision.least_exponent + 2 * precision.digits)) & (a != 0) & (
        b != 0) & np.isfinite(p)
    rows = zip(*(np.broadcast_to(x, result.shape)[small].tolist() for x in (a, b, p)), strict=True)
    result[small] = [float(precision.rounded(Fraction(x) * Fraction(y) - Fraction(z)))
                     for x, y, z in rows]
    return result


@cache
def _interpreted(program: Program, precision: Precision) -> Callable[..., list[Any]]:
    return interpreter(program, arithmetic(precision))


def values(program: Program, precision: Precision, *inputs: Array) -> list[Array]:
    """The results of a Program of scalars, one array each."""
    with np.errstate(all="ignore"):
        results = _interpreted(program, precision)([[x] for x in inputs])
    for x in results:
        assert x.dtype == precision.numpy_type
    return results


def results(function: Elementary, precision: Precision, *inputs: Array) -> list[Array]:
    """The function's results: its kernel's, after the reduction that the first input takes."""
    kernel = function.kernel(precision)
    if function.near is None or function.far is None or function.limit is None:
        return values(kernel, precision, *inputs)
    angle, *others = inputs
    reduced = values(function.near(precision), precision, angle)
    beyond = ~(np.abs(angle) <= float(function.limit(precision)))
    far = values(function.far(precision), precision, angle[beyond])
    for some, those in zip(reduced, far, strict=True):
        some[beyond] = those
    return values(kernel, precision, *reduced, *others)


def truth(name: str, inputs: Sequence[Any]) -> Any:
    """The true value to BITS bits."""
    return getattr(gmpy2, name)(*map(gmpy2.mpfr, inputs))


def errors(name: str, precision: Precision, got: Array, *inputs: Array) -> Array:
    """|got - true| in ulps of the true value, below the normal range in the least subnormals.

    Where the true value rounds to no finite number, infinity alone has error 0."""
    with gmpy2.context(precision=BITS, emax=10**6, emin=-10**6):
        least = precision.least_exponent
        far = gmpy2.mpfr(2)**(2 - least) - gmpy2.mpfr(2)**(1 - least - precision.digits)
        result = np.empty(len(got))
        for i, (value, *given) in enumerate(zip(got.tolist(), *(x.tolist() for x in inputs),
                                                strict=True)):
            true = truth(name, given)
            if abs(true) >= far:
                result[i] = 0 if value == gmpy2.sign(true) * np.inf else np.inf
                continue
            exponent = max(gmpy2.get_exp(true) - 1 if true else least, least)
            ulp = gmpy2.mpfr(2)**(exponent + 1 - precision.digits)
            error = float(abs(gmpy2.mpfr(value) - true) / ulp)
            result[i] = error if error == error else np.inf
    return result


def remaining(name: str, got: Array, rest: Array, *inputs: Array, slack: float = 0) -> Array:
    """log2 of |got + rest - true| / |true|: the error of a result and its error together, beyond an
    absolute slack."""
    with gmpy2.context(precision=2 * BITS, emax=10**6, emin=-10**6):
        result = np.empty(len(got))
        for i, (value, more, *given) in enumerate(zip(
                got.tolist(), rest.tolist(), *(x.tolist() for x in inputs), strict=True)):
            true = truth(name, given)
            error = abs(gmpy2.mpfr(value) + gmpy2.mpfr(more) - true) - gmpy2.mpfr(slack)
            result[i] = gmpy2.log2(error / abs(true)) if error > 0 else -np.inf
        return result


def same(got: Array, want: Array) -> bool:
    """Returns whether all bits agree, except the sign and the payload of NaN."""
    kind = f"u{want.dtype.itemsize}"
    agree = (got.view(kind) == want.view(kind)) | (np.isnan(got) & np.isnan(want))
    return got.dtype == want.dtype and bool(agree.all())


def worst_cases(name: str, precision: Precision) -> list[Array]:
    """The committed worst cases of a function, an array for each argument."""
    rows = [line.split() for line in _CASES.read_text().splitlines() if not line.startswith("#")]
    results = [[float.fromhex(x) for x in row[2:]] for row in rows
               if row[:2] == [name, precision.name]]
    return [np.array(column, precision.numpy_type) for column in zip(*results, strict=True)]


def quotients(precision: Precision) -> tuple[np.ndarray, np.ndarray]:
    """Quotients near 0, 1/2, 1 and 2; all magnitudes, so that results have all, too."""
    rng = np.random.default_rng(8)
    n, low = 4000, precision.least_exponent
    near = rng.choice((0.5, 1.0, 2.0), n) * (1 + rng.normal(0, 1, n) * 2.0**rng.uniform(-50, 0, n))
    ratios = np.concatenate([rng.uniform(0, 2.5, 4 * n), rng.uniform(0.4, 0.6, 3 * n), near,
                             2.0**rng.uniform(low, -low, 2 * n)])
    wide = rng.uniform(low - 10, -low, len(ratios) - 6 * n)
    scales = 2.0**np.concatenate([np.zeros(6 * n), wide])
    x = (rng.uniform(1, 2, len(ratios)) * scales).astype(precision.numpy_type)
    with np.errstate(all="ignore"):
        y = (x * ratios).astype(precision.numpy_type)
    x, y = (np.concatenate([a, b]) for a, b in zip(
        (x, y), worst_cases("atan2", precision)[::-1], strict=True))
    return y * rng.choice((-1, 1), len(y)), x * rng.choice((-1, 1), len(x))
