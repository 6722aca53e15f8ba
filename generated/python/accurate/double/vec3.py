# Made by `coscrew generate`; changes are overwritten.
"""Vectors of three components.

In double precision, accurate tier.
"""

from coscrew._exact import product_error, product_rest
from coscrew._kernel import double_kernel as kernel


@kernel("(3),()->(3)")
def vec3_scale(self, a):
    """self = a self.

    (3),()->(3).  self: vector; a: number.
    3 mul, 3 add, 3 product error.  Error <= u |result|, barring over- and underflow.
    """
    self_0, self_1, self_2 = self
    self_0_new = self_0 * a
    self_1_new = self_1 * a
    self_2_new = self_2 * a
    self_0_new_rounded = self_0_new + product_error(self_0, a, self_0_new)
    self_1_new_rounded = self_1_new + product_error(self_1, a, self_1_new)
    self_2_new_rounded = self_2_new + product_error(self_2, a, self_2_new)
    return (self_0_new_rounded, self_1_new_rounded, self_2_new_rounded)


@kernel("(),(3),(3)->(3)")
def axpy_vv(a, x, y):
    """y = a x + y.

    (),(3),(3)->(3).  a: number; x, y: vector.
    3 mul, 18 add, 3 product rest.  Error <= u |result| + 3 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """
    x_0, x_1, x_2 = x
    y_0, y_1, y_2 = y
    y_0_new_a = a * x_0
    y_0_new = y_0_new_a + y_0
    y_0_new_right = y_0_new - y_0_new_a
    y_0_new_lo = product_rest(a, x_0, y_0_new_a, y_0_new - y_0_new_right) + (y_0 - y_0_new_right)
    y_1_new_a = a * x_1
    y_1_new = y_1_new_a + y_1
    y_1_new_right = y_1_new - y_1_new_a
    y_1_new_lo = product_rest(a, x_1, y_1_new_a, y_1_new - y_1_new_right) + (y_1 - y_1_new_right)
    y_2_new_a = a * x_2
    y_2_new = y_2_new_a + y_2
    y_2_new_right = y_2_new - y_2_new_a
    y_2_new_lo = product_rest(a, x_2, y_2_new_a, y_2_new - y_2_new_right) + (y_2 - y_2_new_right)
    y_0_new_rounded = y_0_new + y_0_new_lo
    y_1_new_rounded = y_1_new + y_1_new_lo
    y_2_new_rounded = y_2_new + y_2_new_lo
    return (y_0_new_rounded, y_1_new_rounded, y_2_new_rounded)


@kernel("(3),(3)->(3)")
def xpy_vv(x, y):
    """y = x + y.

    (3),(3)->(3).  x, y: vector.
    21 add.  Error <= u |result|, barring over- and underflow.
    """
    x_0, x_1, x_2 = x
    y_0, y_1, y_2 = y
    y_0_new = x_0 + y_0
    y_0_new_right = y_0_new - x_0
    y_1_new = x_1 + y_1
    y_1_new_right = y_1_new - x_1
    y_2_new = x_2 + y_2
    y_2_new_right = y_2_new - x_2
    y_0_new_rounded = y_0_new + (x_0 - (y_0_new - y_0_new_right) + (y_0 - y_0_new_right))
    y_1_new_rounded = y_1_new + (x_1 - (y_1_new - y_1_new_right) + (y_1 - y_1_new_right))
    y_2_new_rounded = y_2_new + (x_2 - (y_2_new - y_2_new_right) + (y_2 - y_2_new_right))
    return (y_0_new_rounded, y_1_new_rounded, y_2_new_rounded)


@kernel("(3),(3)->(3)")
def nxpy_vv(x, y):
    """y = -x + y.

    (3),(3)->(3).  x, y: vector.
    21 add.  Error <= u |result|, barring over- and underflow.
    """
    x_0, x_1, x_2 = x
    y_0, y_1, y_2 = y
    y_0_new = y_0 - x_0
    y_0_new_right = y_0 - y_0_new
    y_1_new = y_1 - x_1
    y_1_new_right = y_1 - y_1_new
    y_2_new = y_2 - x_2
    y_2_new_right = y_2 - y_2_new
    y_0_new_rounded = y_0_new + (y_0 - (y_0_new + y_0_new_right) - (x_0 - y_0_new_right))
    y_1_new_rounded = y_1_new + (y_1 - (y_1_new + y_1_new_right) - (x_1 - y_1_new_right))
    y_2_new_rounded = y_2_new + (y_2 - (y_2_new + y_2_new_right) - (x_2 - y_2_new_right))
    return (y_0_new_rounded, y_1_new_rounded, y_2_new_rounded)


@kernel("(),(3)->(3)")
def product_av(a, vi):
    """vo = a vi.

    (),(3)->(3).  a: number; vi, vo: vector.
    3 mul, 3 add, 3 product error.  Error <= u |result|, barring over- and underflow.
    """
    vi_0, vi_1, vi_2 = vi
    vo_0 = a * vi_0
    vo_1 = a * vi_1
    vo_2 = a * vi_2
    vo_0_rounded = vo_0 + product_error(a, vi_0, vo_0)
    vo_1_rounded = vo_1 + product_error(a, vi_1, vo_1)
    vo_2_rounded = vo_2 + product_error(a, vi_2, vo_2)
    return (vo_0_rounded, vo_1_rounded, vo_2_rounded)


@kernel("(3),(3)->(3)")
def add_vv(v1, v2):
    """vo = v1 + v2.

    (3),(3)->(3).  v1, v2, vo: vector.
    21 add.  Error <= u |result|, barring over- and underflow.
    """
    v1_0, v1_1, v1_2 = v1
    v2_0, v2_1, v2_2 = v2
    vo_0 = v1_0 + v2_0
    vo_0_right = vo_0 - v1_0
    vo_1 = v1_1 + v2_1
    vo_1_right = vo_1 - v1_1
    vo_2 = v1_2 + v2_2
    vo_2_right = vo_2 - v1_2
    vo_0_rounded = vo_0 + (v1_0 - (vo_0 - vo_0_right) + (v2_0 - vo_0_right))
    vo_1_rounded = vo_1 + (v1_1 - (vo_1 - vo_1_right) + (v2_1 - vo_1_right))
    vo_2_rounded = vo_2 + (v1_2 - (vo_2 - vo_2_right) + (v2_2 - vo_2_right))
    return (vo_0_rounded, vo_1_rounded, vo_2_rounded)


@kernel("(3),(3)->(3)")
def subtract_vv(v1, v2):
    """vo = v1 - v2.

    (3),(3)->(3).  v1, v2, vo: vector.
    21 add.  Error <= u |result|, barring over- and underflow.
    """
    v1_0, v1_1, v1_2 = v1
    v2_0, v2_1, v2_2 = v2
    vo_0 = v1_0 - v2_0
    vo_0_right = v1_0 - vo_0
    vo_1 = v1_1 - v2_1
    vo_1_right = v1_1 - vo_1
    vo_2 = v1_2 - v2_2
    vo_2_right = v1_2 - vo_2
    vo_0_rounded = vo_0 + (v1_0 - (vo_0 + vo_0_right) - (v2_0 - vo_0_right))
    vo_1_rounded = vo_1 + (v1_1 - (vo_1 + vo_1_right) - (v2_1 - vo_1_right))
    vo_2_rounded = vo_2 + (v1_2 - (vo_2 + vo_2_right) - (v2_2 - vo_2_right))
    return (vo_0_rounded, vo_1_rounded, vo_2_rounded)


@kernel("(3),()->(3)")
def vec3_scaled(v, k):
    """vo = k v.

    (3),()->(3).  v, vo: vector; k: number.
    3 mul, 3 add, 3 product error.  Error <= u |result|, barring over- and underflow.
    """
    v_0, v_1, v_2 = v
    vo_0 = v_0 * k
    vo_1 = v_1 * k
    vo_2 = v_2 * k
    vo_0_rounded = vo_0 + product_error(v_0, k, vo_0)
    vo_1_rounded = vo_1 + product_error(v_1, k, vo_1)
    vo_2_rounded = vo_2 + product_error(v_2, k, vo_2)
    return (vo_0_rounded, vo_1_rounded, vo_2_rounded)


@kernel("(3),(3)->()")
def dot_vv(v1, v2):
    """v1·v2.

    (3),(3)->().  v1, v2: vector; dot: number.
    3 mul, 11 add, 3 product rest.  Error <= u |result| + 11 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """
    v1_0, v1_1, v1_2 = v1
    v2_0, v2_1, v2_2 = v2
    dot_a = v1_0 * v2_0
    dot_b = v1_1 * v2_1
    dot_c = dot_a + dot_b
    dot_c_right = dot_c - dot_a
    dot_c_left_rest = product_rest(v1_0, v2_0, dot_a, dot_c - dot_c_right)
    dot_c_lo = dot_c_left_rest + product_rest(v1_1, v2_1, dot_b, dot_c_right)
    dot_d = v1_2 * v2_2
    dot = dot_c + dot_d
    dot_right = dot - dot_c
    dot_lo1 = dot_c - (dot - dot_right) + product_rest(v1_2, v2_2, dot_d, dot_right)
    dot_lo = dot_lo1 + dot_c_lo
    dot_rounded = dot + dot_lo
    return dot_rounded


@kernel("(),(3)->(3)")
def product_avinv(k, v):
    """vo = k (-v).

    (),(3)->(3).  k: number; v, vo: vector.
    3 mul, 3 add, 3 product error, 6 neg.  Error <= u |result|, barring over- and underflow.
    """
    v_0, v_1, v_2 = v
    vo_0a = k * v_0
    vo_0 = -vo_0a
    vo_1a = k * v_1
    vo_1 = -vo_1a
    vo_2a = k * v_2
    vo_2 = -vo_2a
    vo_0_rounded = vo_0 + -product_error(k, v_0, vo_0a)
    vo_1_rounded = vo_1 + -product_error(k, v_1, vo_1a)
    vo_2_rounded = vo_2 + -product_error(k, v_2, vo_2a)
    return (vo_0_rounded, vo_1_rounded, vo_2_rounded)


@kernel("(3),(3)->(3)")
def cross_vv(v1, v2):
    """vo = v1 × v2.  Exactly zero for v1 = v2, unless products overflow.

    (3),(3)->(3).  v1, v2, vo: vector.
    6 mul, 15 add, 6 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """
    v1_0, v1_1, v1_2 = v1
    v2_0, v2_1, v2_2 = v2
    vo_0a = v1_1 * v2_2
    vo_0b = v1_2 * v2_1
    vo_0 = vo_0a - vo_0b
    vo_0_right = vo_0a - vo_0
    vo_0_left_rest = product_rest(v1_1, v2_2, vo_0a, vo_0 + vo_0_right)
    vo_0_lo = vo_0_left_rest - product_rest(v1_2, v2_1, vo_0b, vo_0_right)
    vo_1a = v1_2 * v2_0
    vo_1b = v1_0 * v2_2
    vo_1 = vo_1a - vo_1b
    vo_1_right = vo_1a - vo_1
    vo_1_left_rest = product_rest(v1_2, v2_0, vo_1a, vo_1 + vo_1_right)
    vo_1_lo = vo_1_left_rest - product_rest(v1_0, v2_2, vo_1b, vo_1_right)
    vo_2a = v1_0 * v2_1
    vo_2b = v1_1 * v2_0
    vo_2 = vo_2a - vo_2b
    vo_2_right = vo_2a - vo_2
    vo_2_left_rest = product_rest(v1_0, v2_1, vo_2a, vo_2 + vo_2_right)
    vo_2_lo = vo_2_left_rest - product_rest(v1_1, v2_0, vo_2b, vo_2_right)
    vo_0_rounded = vo_0 + vo_0_lo
    vo_1_rounded = vo_1 + vo_1_lo
    vo_2_rounded = vo_2 + vo_2_lo
    return (vo_0_rounded, vo_1_rounded, vo_2_rounded)


@kernel("(3),(3)->(3)")
def cross_vvinv(v1, v2):
    """vo = v1 × (-v2).

    (3),(3)->(3).  v1, v2, vo: vector.
    6 mul, 15 add, 6 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """
    v1_0, v1_1, v1_2 = v1
    v2_0, v2_1, v2_2 = v2
    vo_0a = v1_2 * v2_1
    vo_0b = v1_1 * v2_2
    vo_0 = vo_0a - vo_0b
    vo_0_right = vo_0a - vo_0
    vo_0_left_rest = product_rest(v1_2, v2_1, vo_0a, vo_0 + vo_0_right)
    vo_0_lo = vo_0_left_rest - product_rest(v1_1, v2_2, vo_0b, vo_0_right)
    vo_1a = v1_0 * v2_2
    vo_1b = v1_2 * v2_0
    vo_1 = vo_1a - vo_1b
    vo_1_right = vo_1a - vo_1
    vo_1_left_rest = product_rest(v1_0, v2_2, vo_1a, vo_1 + vo_1_right)
    vo_1_lo = vo_1_left_rest - product_rest(v1_2, v2_0, vo_1b, vo_1_right)
    vo_2a = v1_1 * v2_0
    vo_2b = v1_0 * v2_1
    vo_2 = vo_2a - vo_2b
    vo_2_right = vo_2a - vo_2
    vo_2_left_rest = product_rest(v1_1, v2_0, vo_2a, vo_2 + vo_2_right)
    vo_2_lo = vo_2_left_rest - product_rest(v1_0, v2_1, vo_2b, vo_2_right)
    vo_0_rounded = vo_0 + vo_0_lo
    vo_1_rounded = vo_1 + vo_1_lo
    vo_2_rounded = vo_2 + vo_2_lo
    return (vo_0_rounded, vo_1_rounded, vo_2_rounded)


@kernel("(3),()->(3)")
def add_vvx(v, k):
    """vo = v + k e_x.

    (3),()->(3).  v, vo: vector; k: number.
    7 add.  Error <= u |result|, barring over- and underflow.
    """
    v_0, v_1, v_2 = v
    vo_0 = v_0 + k
    vo_0_right = vo_0 - v_0
    vo_0_rounded = vo_0 + (v_0 - (vo_0 - vo_0_right) + (k - vo_0_right))
    return (vo_0_rounded, v_1, v_2)


@kernel("(3),()->(3)")
def add_vvxinv(v, k):
    """vo = v - k e_x.

    (3),()->(3).  v, vo: vector; k: number.
    7 add.  Error <= u |result|, barring over- and underflow.
    """
    v_0, v_1, v_2 = v
    vo_0 = v_0 - k
    vo_0_right = v_0 - vo_0
    vo_0_rounded = vo_0 + (v_0 - (vo_0 + vo_0_right) - (k - vo_0_right))
    return (vo_0_rounded, v_1, v_2)


@kernel("(3),()->(3)")
def add_vvy(v, k):
    """vo = v + k e_y.

    (3),()->(3).  v, vo: vector; k: number.
    7 add.  Error <= u |result|, barring over- and underflow.
    """
    v_0, v_1, v_2 = v
    vo_1 = v_1 + k
    vo_1_right = vo_1 - v_1
    vo_1_rounded = vo_1 + (v_1 - (vo_1 - vo_1_right) + (k - vo_1_right))
    return (v_0, vo_1_rounded, v_2)


@kernel("(3),()->(3)")
def add_vvyinv(v, k):
    """vo = v - k e_y.

    (3),()->(3).  v, vo: vector; k: number.
    7 add.  Error <= u |result|, barring over- and underflow.
    """
    v_0, v_1, v_2 = v
    vo_1 = v_1 - k
    vo_1_right = v_1 - vo_1
    vo_1_rounded = vo_1 + (v_1 - (vo_1 + vo_1_right) - (k - vo_1_right))
    return (v_0, vo_1_rounded, v_2)


@kernel("(3),()->(3)")
def add_vvz(v, k):
    """vo = v + k e_z.

    (3),()->(3).  v, vo: vector; k: number.
    7 add.  Error <= u |result|, barring over- and underflow.
    """
    v_0, v_1, v_2 = v
    vo_2 = v_2 + k
    vo_2_right = vo_2 - v_2
    vo_2_rounded = vo_2 + (v_2 - (vo_2 - vo_2_right) + (k - vo_2_right))
    return (v_0, v_1, vo_2_rounded)


@kernel("(3),()->(3)")
def add_vvzinv(v, k):
    """vo = v - k e_z.

    (3),()->(3).  v, vo: vector; k: number.
    7 add.  Error <= u |result|, barring over- and underflow.
    """
    v_0, v_1, v_2 = v
    vo_2 = v_2 - k
    vo_2_right = v_2 - vo_2
    vo_2_rounded = vo_2 + (v_2 - (vo_2 + vo_2_right) - (k - vo_2_right))
    return (v_0, v_1, vo_2_rounded)
