"""exp against MPFR: special values, every binade, the ends of its pieces, worst cases found."""

import numpy as np

from coscrew_codegen.program.elementary import exp
from coscrew_codegen.program.values.formats import Precision
from tests.support.each import each_precision
from tests.support.truth.elementary import EXP_ENDS, errors, same, values, worst_cases


@each_precision
def test_special_values(precision: Precision):
    nan, inf = np.nan, np.inf
    least, largest = (float(precision.limit(x)) for x in ("smallest_subnormal", "max"))
    zero, _, overflow = EXP_ENDS[precision.name]
    cases = [(0.0, 1), (-0.0, 1), (inf, inf), (-inf, 0), (nan, nan), (-nan, nan), (least, 1),
             (-least, 1), (largest, inf), (-largest, 0), (overflow + 1e-4, inf), (zero * 1.01, 0)]
    x, y = (np.array(column, precision.numpy_type) for column in zip(*cases, strict=True))
    assert same(values(exp.kernel(precision), precision, x)[0], y)


@each_precision
def test_errors_are_below_the_proved_bound(precision: Precision):
    """Below a normal result the bound is larger by half an ulp of the least subnormal number."""
    rng = np.random.default_rng(5)
    zero, normal, overflow = EXP_ENDS[precision.name]
    tiny = 2.0**np.arange(-precision.digits - 2, 11)[:, None] * rng.uniform(1, 2, (1, 60))
    tiny = np.clip(tiny * rng.choice((-1, 1), tiny.shape), normal, overflow).ravel()
    switches = (rng.integers(normal, overflow, 2000) + 0.5) * np.log(2)
    x = np.concatenate([rng.uniform(normal, overflow, 20000), rng.uniform(-0.35, 0.35, 20000), tiny,
                        np.clip(switches, normal, overflow), EXP_ENDS[precision.name][1:],
                        *worst_cases("exp", precision)]).astype(precision.numpy_type)
    x = x[x > normal]
    bound = float(exp.FUNCTION.error(precision))
    assert errors("exp", precision, values(exp.kernel(precision), precision, x)[0], x
                  ).max() <= bound
    x = rng.uniform(zero * 1.02, normal, 5000).astype(precision.numpy_type)
    assert errors("exp", precision, values(exp.kernel(precision), precision, x)[0], x
                  ).max() <= 0.5 + bound / 2

