# Made by `coscrew generate`; changes are overwritten.
"""Vectors of three components.

In single precision, accurate tier.
"""

from coscrew._kernel import wide_kernel as kernel


@kernel("(3),()->(3)")
def vec3_scale(self, a):
    """self = a self.

    (3),()->(3).  self: vector; a: number.
    3 mul.  Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula;
    barring over- and underflow.
    """
    self_0, self_1, self_2 = self
    self_0_new = self_0 * a
    self_1_new = self_1 * a
    self_2_new = self_2 * a
    return (self_0_new, self_1_new, self_2_new)


@kernel("(),(3),(3)->(3)")
def axpy_vv(a, x, y):
    """y = a x + y.

    (),(3),(3)->(3).  a: number; x, y: vector.
    3 mul, 3 add.  Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    x_0, x_1, x_2 = x
    y_0, y_1, y_2 = y
    y_0_new = a * x_0 + y_0
    y_1_new = a * x_1 + y_1
    y_2_new = a * x_2 + y_2
    return (y_0_new, y_1_new, y_2_new)


@kernel("(3),(3)->(3)")
def xpy_vv(x, y):
    """y = x + y.

    (3),(3)->(3).  x, y: vector.
    3 add.  Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula;
    barring over- and underflow.
    """
    x_0, x_1, x_2 = x
    y_0, y_1, y_2 = y
    y_0_new = x_0 + y_0
    y_1_new = x_1 + y_1
    y_2_new = x_2 + y_2
    return (y_0_new, y_1_new, y_2_new)


@kernel("(3),(3)->(3)")
def nxpy_vv(x, y):
    """y = -x + y.

    (3),(3)->(3).  x, y: vector.
    3 add.  Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula;
    barring over- and underflow.
    """
    x_0, x_1, x_2 = x
    y_0, y_1, y_2 = y
    y_0_new = y_0 - x_0
    y_1_new = y_1 - x_1
    y_2_new = y_2 - x_2
    return (y_0_new, y_1_new, y_2_new)


@kernel("(),(3)->(3)")
def product_av(a, vi):
    """vo = a vi.

    (),(3)->(3).  a: number; vi, vo: vector.
    3 mul.  Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula;
    barring over- and underflow.
    """
    vi_0, vi_1, vi_2 = vi
    vo_0 = a * vi_0
    vo_1 = a * vi_1
    vo_2 = a * vi_2
    return (vo_0, vo_1, vo_2)


@kernel("(3),(3)->(3)")
def add_vv(v1, v2):
    """vo = v1 + v2.

    (3),(3)->(3).  v1, v2, vo: vector.
    3 add.  Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula;
    barring over- and underflow.
    """
    v1_0, v1_1, v1_2 = v1
    v2_0, v2_1, v2_2 = v2
    vo_0 = v1_0 + v2_0
    vo_1 = v1_1 + v2_1
    vo_2 = v1_2 + v2_2
    return (vo_0, vo_1, vo_2)


@kernel("(3),(3)->(3)")
def subtract_vv(v1, v2):
    """vo = v1 - v2.

    (3),(3)->(3).  v1, v2, vo: vector.
    3 add.  Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula;
    barring over- and underflow.
    """
    v1_0, v1_1, v1_2 = v1
    v2_0, v2_1, v2_2 = v2
    vo_0 = v1_0 - v2_0
    vo_1 = v1_1 - v2_1
    vo_2 = v1_2 - v2_2
    return (vo_0, vo_1, vo_2)


@kernel("(3),()->(3)")
def vec3_scaled(v, k):
    """vo = k v.

    (3),()->(3).  v, vo: vector; k: number.
    3 mul.  Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula;
    barring over- and underflow.
    """
    v_0, v_1, v_2 = v
    vo_0 = v_0 * k
    vo_1 = v_1 * k
    vo_2 = v_2 * k
    return (vo_0, vo_1, vo_2)


@kernel("(3),(3)->()")
def dot_vv(v1, v2):
    """v1·v2.

    (3),(3)->().  v1, v2: vector; dot: number.
    3 mul, 2 add.  Error <= u |result| + 3/32 u^2 S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    v1_0, v1_1, v1_2 = v1
    v2_0, v2_1, v2_2 = v2
    dot = v1_0 * v2_0 + v1_1 * v2_1 + v1_2 * v2_2
    return dot


@kernel("(),(3)->(3)")
def product_avinv(k, v):
    """vo = k (-v).

    (),(3)->(3).  k: number; v, vo: vector.
    3 mul, 3 neg.  Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    v_0, v_1, v_2 = v
    vo_0 = -(k * v_0)
    vo_1 = -(k * v_1)
    vo_2 = -(k * v_2)
    return (vo_0, vo_1, vo_2)


@kernel("(3),(3)->(3)")
def cross_vv(v1, v2):
    """vo = v1 × v2.  Exactly zero for v1 = v2, unless products overflow.

    (3),(3)->(3).  v1, v2, vo: vector.
    6 mul, 3 add.  Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    v1_0, v1_1, v1_2 = v1
    v2_0, v2_1, v2_2 = v2
    vo_0 = v1_1 * v2_2 - v1_2 * v2_1
    vo_1 = v1_2 * v2_0 - v1_0 * v2_2
    vo_2 = v1_0 * v2_1 - v1_1 * v2_0
    return (vo_0, vo_1, vo_2)


@kernel("(3),(3)->(3)")
def cross_vvinv(v1, v2):
    """vo = v1 × (-v2).

    (3),(3)->(3).  v1, v2, vo: vector.
    6 mul, 3 add.  Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    v1_0, v1_1, v1_2 = v1
    v2_0, v2_1, v2_2 = v2
    vo_0 = v1_2 * v2_1 - v1_1 * v2_2
    vo_1 = v1_0 * v2_2 - v1_2 * v2_0
    vo_2 = v1_1 * v2_0 - v1_0 * v2_1
    return (vo_0, vo_1, vo_2)


@kernel("(3),()->(3)")
def add_vvx(v, k):
    """vo = v + k e_x.

    (3),()->(3).  v, vo: vector; k: number.
    1 add.  Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula;
    barring over- and underflow.
    """
    v_0, v_1, v_2 = v
    vo_0 = v_0 + k
    return (vo_0, v_1, v_2)


@kernel("(3),()->(3)")
def add_vvxinv(v, k):
    """vo = v - k e_x.

    (3),()->(3).  v, vo: vector; k: number.
    1 add.  Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula;
    barring over- and underflow.
    """
    v_0, v_1, v_2 = v
    vo_0 = v_0 - k
    return (vo_0, v_1, v_2)


@kernel("(3),()->(3)")
def add_vvy(v, k):
    """vo = v + k e_y.

    (3),()->(3).  v, vo: vector; k: number.
    1 add.  Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula;
    barring over- and underflow.
    """
    v_0, v_1, v_2 = v
    vo_1 = v_1 + k
    return (v_0, vo_1, v_2)


@kernel("(3),()->(3)")
def add_vvyinv(v, k):
    """vo = v - k e_y.

    (3),()->(3).  v, vo: vector; k: number.
    1 add.  Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula;
    barring over- and underflow.
    """
    v_0, v_1, v_2 = v
    vo_1 = v_1 - k
    return (v_0, vo_1, v_2)


@kernel("(3),()->(3)")
def add_vvz(v, k):
    """vo = v + k e_z.

    (3),()->(3).  v, vo: vector; k: number.
    1 add.  Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula;
    barring over- and underflow.
    """
    v_0, v_1, v_2 = v
    vo_2 = v_2 + k
    return (v_0, v_1, vo_2)


@kernel("(3),()->(3)")
def add_vvzinv(v, k):
    """vo = v - k e_z.

    (3),()->(3).  v, vo: vector; k: number.
    1 add.  Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula;
    barring over- and underflow.
    """
    v_0, v_1, v_2 = v
    vo_2 = v_2 - k
    return (v_0, v_1, vo_2)
