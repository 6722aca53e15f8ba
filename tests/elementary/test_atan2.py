"""atan2 against MPFR: special values, all magnitudes, the ends of its pieces, worst cases found."""

from itertools import product

import numpy as np

from coscrew_codegen.program.elementary import atan2
from coscrew_codegen.program.values.formats import Precision
from tests.support.each import each_precision
from tests.support.truth.elementary import errors, quotients, same, values


def angles(precision: Precision, y: np.ndarray, x: np.ndarray) -> np.ndarray:
    return values(atan2.kernel(precision), precision, y, x)[0]


@each_precision
def test_special_values(precision: Precision):
    """Zeros, infinities, NaN and ordinary numbers in all pairs, as C99's Annex F has them."""
    least, largest = (float(precision.limit(x)) for x in ("smallest_subnormal", "max"))
    special = [s * x for s in (1, -1) for x in (0.0, least, 1.0, largest, np.inf)]
    y, x = np.array(list(product([*special, np.nan], repeat=2)), precision.numpy_type).T
    with np.errstate(all="ignore"):
        want = np.arctan2(y.astype(np.longdouble), x).astype(precision.numpy_type)
    assert np.isnan(want).sum() == 21
    assert same(angles(precision, y, x), want)
    zero, pi = (np.array([z], precision.numpy_type) for z in (0.0, np.pi))
    assert same(angles(precision, zero, -zero), pi) and same(angles(precision, -zero, -zero), -pi)



@each_precision
def test_errors_are_below_the_proved_bound(precision: Precision):
    """Below a normal result the bound is half an ulp of the least subnormal number and a little."""
    y, x = (a.astype(precision.numpy_type) for a in quotients(precision))
    finite = np.isfinite(y) & np.isfinite(x)
    y, x = y[finite], x[finite]
    got = angles(precision, y, x)
    result = errors("atan2", precision, got, y, x)
    normal = np.abs(got) >= float(precision.limit("smallest_normal"))
    assert normal.sum() > 20000 and (~normal).sum() > 50
    assert result[normal].max() <= float(atan2.FUNCTION.error(precision))
    assert result[~normal].max() <= 0.5001


@each_precision
def test_atan2_is_symmetric(precision: Precision):
    """atan2(-y, x) = -atan2(y, x), also where products have no exact error."""
    y, x = (np.abs(a).astype(precision.numpy_type) for a in quotients(precision))
    for side in (1, -1):
        assert same(angles(precision, -y, side * x), -angles(precision, y, side * x))
