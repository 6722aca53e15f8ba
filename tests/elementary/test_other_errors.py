"""Errors of exp, tanh and atan2, against MPFR: with their errors they have twice the digits."""

from math import log2

import numpy as np
import pytest

from coscrew_codegen.program.elementary import (
    ELEMENTARY,
    ERRORS,
    Elementary,
    atan2,
    exp_error,
    tanh_error,
)
from coscrew_codegen.program.elementary.proofs.minimax import ln2
from coscrew_codegen.program.values.formats import Precision
from tests.support.each import each_precision
from tests.support.truth.elementary import (
    EXP_ENDS,
    Array,
    quotients,
    remaining,
    results,
    worst_cases,
)

OTHERS = [x for x in ERRORS if x.name != "sincos_error"]


def computed(error: Elementary, precision: Precision, *inputs: Array) -> tuple[Array, Array]:
    """A function's results and their computed errors."""
    function = next(x for x in ELEMENTARY if error.name == f"{x.name}_error")
    got, = results(function, precision, *inputs)
    rest, = results(error, precision, *inputs, got)
    return got, rest


def inputs(name: str, precision: Precision) -> tuple[Array, ...]:
    """Inputs of all magnitudes, next to the ends of pieces, and worst cases found."""
    rng = np.random.default_rng(12)
    if name == "atan2":
        y, x = (a.astype(precision.numpy_type)[::4] for a in quotients(precision))
        finite = np.isfinite(y) & np.isfinite(x)
        wide = 2.0**rng.uniform(precision.least_exponent, precision.bias, (2, 3000))
        more = (wide * rng.choice((-1, 1), wide.shape)).astype(precision.numpy_type)
        return np.concatenate([y[finite], more[0]]), np.concatenate([x[finite], more[1]])
    tiny = 2.0**rng.uniform(precision.least_exponent, 0, 2000) * rng.choice((-1, 1), 2000)
    ends = EXP_ENDS[precision.name] if name == "exp" else (-22, 22)
    switches = (rng.integers(-20, 20, 1000) + 0.5) * np.log(2) / (1 if name == "exp" else 2)
    x = np.concatenate([tiny, rng.uniform(-1, 1, 3000), rng.uniform(ends[0], ends[-1], 3000),
                        switches, np.nextafter(0.625, [0, 1]), *worst_cases(name, precision)])
    return x.astype(precision.numpy_type),


@each_precision
@pytest.mark.parametrize("error", OTHERS, ids=lambda x: x.name)
def test_results_with_their_errors_have_twice_the_digits(error: Elementary, precision: Precision):
    """Except for half the least subnormal number, where the error has no more digits."""
    name = error.name.removesuffix("_error")
    given = inputs(name, precision)
    got, rest = computed(error, precision, *given)
    known = np.isfinite(got) & (got != 0)
    given, got, rest = tuple(x[known] for x in given), got[known], rest[known]
    assert len(got) > 5000 and np.isfinite(rest).all()
    half = float(precision.eta) if precision.digits == 24 else 0
    result = remaining(name, got, rest, *given, slack=1.02 * half)
    if not half:  # the slack is no number of double precision: there, errors in its least binades
        large = np.abs(got) > float(precision.smallest_normal / precision.u**2)
        ulps = np.maximum(np.spacing(np.abs(got)), float(precision.limit("smallest_subnormal")))
        assert (np.abs(rest) <= ulps)[~large].all()
        result = result[large]
    stated = log2(error.error(precision))
    assert stated - 8 < result.max() <= stated
    assert stated < 7.5 - 2 * precision.digits


@each_precision
def test_special_values(precision: Precision):
    """0 where the result is exact, 0 or infinite; NaN where it is."""
    inf, nan = np.inf, np.nan
    tiny = float(precision.limit("smallest_subnormal"))
    cases = {"exp": [(x,) for x in (0, -0.0, inf, -inf, 1e4, -1e4, nan)],
             "tanh": [(x,) for x in (0, -0.0, inf, -inf, 1e4, tiny, -tiny, nan)],
             "atan2": [(0, 1), (-0.0, 1), (0, inf), (tiny, 1), (0, 0), (1, nan), (nan, inf)]}
    for error in OTHERS:
        given = np.array(cases[error.name.removesuffix("_error")], precision.numpy_type).T
        got, rest = computed(error, precision, *given)
        assert np.array_equal(np.isnan(rest), np.isnan(got)), error.name
        assert (rest[~np.isnan(got)] == 0).all(), error.name
    x = np.array([tiny, -tiny, 1e-30], precision.numpy_type)
    _, rest = computed(next(e for e in OTHERS if e.name == "exp_error"), precision, x)
    assert np.array_equal(rest, x), "e^x - 1"


@each_precision
def test_angles_of_axes_and_of_infinities(precision: Precision):
    """Multiples of π/4: their errors are those of the rounded multiples."""
    inf, most = np.inf, 2.0**precision.bias
    y, x = np.array([(1, 0), (0, -1), (inf, 1), (most, most), (inf, inf), (1, -inf), (-inf, -inf),
                     (-0.0, -0.0), (-1, 0)], precision.numpy_type).T
    _, rest = computed(atan2_error(), precision, y, x)
    eighths = [2, 4, 2, 1, 1, 4, -3, -4, -2]
    finite = np.array([(1, 0), (0, -1), (1, 0), (1, 1), (1, 1), (0, -1), (-1, -1), (-0.0, -1),
                       (-1, 0)], precision.numpy_type).T
    got, same = computed(atan2_error(), precision, *finite)
    assert np.array_equal(rest, same) and np.allclose(got * 4 / np.pi, eighths)
    assert remaining("atan2", got, rest, *finite).max() <= log2(atan2_error().error(precision))


def atan2_error() -> Elementary:
    return next(x for x in ERRORS if x.name == "atan2_error")


@each_precision
def test_parts_of_ln_2(precision: Precision):
    """Their sum is ln 2 to the stated bound; products with any k are exact."""
    data = exp_error.parts(precision)
    parts = data.first, data.second
    assert all(abs(x - sum(parts) - data.rest) <= data.missing for x in ln2())
    assert data.missing * data.most < precision.u**2 / 16
    for part in parts:
        assert part.numerator.bit_length() + data.most.bit_length() <= precision.digits


@each_precision
def test_tanh_is_1_beyond_its_end(precision: Precision):
    """To more than twice the digits."""
    assert 2 * np.exp(-2.0 * tanh_error.end(precision)) < float(precision.u**2)
    assert atan2.DATA[precision].least[0] > 0
