# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Elementary functions, with the same bits on every machine.

In single precision, certified tier.  A twin(f, …) is f of double precision with these constants.
"""

from coscrew import _elementary_single as elementary
from coscrew._twins import single_twins
from coscrew.certified import double

twin = single_twins(__name__, elementary=elementary, quiet=True)

sincos = twin(double.sincos, c1=1.0800312e-12,
    doc="""s = sin x, c = cos x, x in rad; |error of s| <= s_bound, |error of c| <= c_bound unless inf
or NaN.

()->(),(),(),().  x, s, c, s_bound, c_bound: number.
65 mul, 100 add, 8 product error, 1 div, 5 abs, 1 less, 1 select.
""")
sin = twin(double.sin, c1=1.0800312e-12,
    doc="""s = sin x, x in rad; |error of s| <= s_bound unless inf or NaN.

()->(),().  x, s, s_bound: number.
65 mul, 99 add, 8 product error, 1 div, 4 abs, 1 less, 1 select.
""")
cos = twin(double.cos, c1=1.0800312e-12,
    doc="""c = cos x, x in rad; |error of c| <= c_bound unless inf or NaN.

()->(),().  x, c, c_bound: number.
65 mul, 99 add, 8 product error, 1 div, 4 abs, 1 less, 1 select.
""")
exp = twin(double.exp, c1=3.308722450212111e-24, c2=1.0800314e-12,
    doc="""y = e^x; |error of y| <= y_bound unless inf or NaN.

()->(),().  x, y, y_bound: number.
52 mul, 98 add, 8 product error, 5 power of two, 2 abs, 7 less, 1 equal, 9 select.
""")
tanh = twin(double.tanh, c1=3.308722450212111e-24, c2=1.0800314e-12,
    doc="""y = tanh x; |error of y| <= y_bound unless inf or NaN.

()->(),().  x, y, y_bound: number.
60 mul, 122 add, 9 product error, 2 div, 2 power of two, 6 abs, 2 copysign, 5 less, 11
select.
""")
atan2 = twin(double.atan2, c1=3.308722450212111e-24, c2=1.0800314e-12,
    doc="""angle of the vector (x, y) to the x axis, in rad, from -π to π; |error of angle| <=
angle_bound unless inf or NaN.

(),()->(),().  y, x, angle, angle_bound: number.
89 mul, 155 add, 14 product error, 2 div, 1 neg, 10 abs, 4 copysign, 13 less, 3 equal, 23
select.
""")
