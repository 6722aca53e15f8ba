# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Elementary functions, with the same bits on every machine.

In single precision, plain tier.  A twin(f, …) is f of double precision with these constants.
"""

from coscrew import _elementary_single as elementary
from coscrew._twins import single_twins
from coscrew import double

twin = single_twins(__name__, elementary=elementary)

sincos = twin(double.sincos,
    doc="""s = sin x, c = cos x, x in rad.

()->(),().  x, s, c: number.
22 mul, 27 add, 1 abs.  Error <= 0.824 ulp, in single precision 0.85 ulp, unless a result is
subnormal; proved.
""")
sin = twin(double.sin,
    doc="""s = sin x, x in rad.

()->().  x, s: number.
22 mul, 27 add, 1 abs.  Error <= 0.824 ulp, in single precision 0.85 ulp, unless a result is
subnormal; proved.
""")
cos = twin(double.cos,
    doc="""c = cos x, x in rad.

()->().  x, c: number.
22 mul, 27 add, 1 abs.  Error <= 0.824 ulp, in single precision 0.85 ulp, unless a result is
subnormal; proved.
""")
exp = twin(double.exp,
    doc="""y = e^x.

()->().  x, y: number.
12 mul, 15 add, 1 power of two, 3 less, 4 select.  Error <= 0.755 ulp, in single precision
0.757 ulp, unless a result is subnormal; proved.
""")
tanh = twin(double.tanh,
    doc="""y = tanh x.

()->().  x, y: number.
20 mul, 23 add, 1 div, 1 power of two, 1 abs, 1 copysign, 2 less, 5 select.  Error <= 0.979
ulp, in single precision 0.967 ulp, unless a result is subnormal; proved.
""")
atan2 = twin(double.atan2,
    doc="""angle of the vector (x, y) to the x axis, in rad, from -π to π.

(),()->().  y, x, angle: number.
22 mul, 29 add, 1 div, 1 neg, 2 abs, 2 copysign, 6 less, 1 equal, 14 select.  Error <= 0.934
ulp, in single precision 0.896 ulp, unless a result is subnormal; proved.
""")
