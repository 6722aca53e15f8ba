"""tanh against MPFR: special values, every binade, the ends of its pieces, worst cases found."""

import numpy as np

from coscrew_codegen.program.elementary import tanh
from coscrew_codegen.program.values.formats import Precision
from tests.support.each import each_precision
from tests.support.truth.elementary import errors, same, values, worst_cases


@each_precision
def test_special_values(precision: Precision):
    """Among them that small arguments are their own results, signs of zeros included."""
    nan, inf = np.nan, np.inf
    least, normal, largest = (float(precision.limit(x)) for x in (
        "smallest_subnormal", "smallest_normal", "max"))
    cases = [(0.0, 0.0), (inf, 1), (nan, nan), (least, least), (normal, normal), (largest, 1),
             (normal - least, normal - least), (tanh.DATA[precision].one, 1), (1e-9, 1e-9)]
    x, y = (np.array(column, precision.numpy_type) for column in zip(*cases, strict=True))
    for sign in (1, -1):
        assert same(values(tanh.kernel(precision), precision, sign * x)[0], sign * y)


@each_precision
def test_errors_are_below_the_proved_bound(precision: Precision):
    rng = np.random.default_rng(6)
    lowest = precision.least_exponent
    every = 2.0**np.arange(lowest, 5)[:, None] * rng.uniform(1, 2, (1, 20))
    switches = np.nextafter(np.array([0.625, 10, 20], precision.numpy_type)[:, None],
                            np.array([0, 30], precision.numpy_type))
    x = np.concatenate([every.ravel(), switches.ravel(), rng.uniform(0, 0.625, 10000),
                        rng.uniform(0.625, 1, 20000), rng.uniform(1, 20, 10000),
                        *worst_cases("tanh", precision)]).astype(precision.numpy_type)
    x[::2] *= -1
    result = errors("tanh", precision, values(tanh.kernel(precision), precision, x)[0], x)
    assert result.max() <= float(tanh.FUNCTION.error(precision))


@each_precision
def test_tanh_is_odd(precision: Precision):
    x = (2.0**np.random.default_rng(7).uniform(-30, 6, 1000)).astype(precision.numpy_type)
    up, down = (values(tanh.kernel(precision), precision, y)[0] for y in (x, -x))
    assert same(up, -down) and (up <= 1).all()
