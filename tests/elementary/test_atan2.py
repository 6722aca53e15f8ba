"""atan2 against MPFR: special values, all magnitudes, the ends of its pieces, worst cases found."""

from itertools import product

import numpy as np

from coscrew_codegen.elementary import atan2
from coscrew_codegen.formats import Precision
from tests.support.each import each_precision
from tests.support.truth.elementary import errors, same, values, worst_cases


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


def samples(precision: Precision) -> tuple[np.ndarray, np.ndarray]:
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


@each_precision
def test_errors_are_below_the_proved_bound(precision: Precision):
    """And below a normal result, of half an ulp of the least subnormal and a little."""
    y, x = (a.astype(precision.numpy_type) for a in samples(precision))
    finite = np.isfinite(y) & np.isfinite(x)
    y, x = y[finite], x[finite]
    got = angles(precision, y, x)
    found = errors("atan2", precision, got, y, x)
    normal = np.abs(got) >= float(precision.limit("smallest_normal"))
    assert normal.sum() > 20000 and (~normal).sum() > 50
    assert found[normal].max() <= float(atan2.FUNCTION.error(precision))
    assert found[~normal].max() <= 0.5001


@each_precision
def test_atan2_is_symmetric(precision: Precision):
    """atan2(-y, x) = -atan2(y, x), also where products have no exact error."""
    y, x = (np.abs(a).astype(precision.numpy_type) for a in samples(precision))
    for side in (1, -1):
        assert same(angles(precision, -y, side * x), -angles(precision, y, side * x))
