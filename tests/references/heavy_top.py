"""The heavy top, as a Taylor series to 50 digits.

A top on a fixed point: 15 kg, centre of mass 1 m along its axis y, moments of inertia
J1 = J3 = 15.234375 and J2 = 0.46875 kg m² about the point, g = 9.81 m/s² along -z; it starts with
its axis level and ω = (0, 150, -4.61538) rad/s.  With n its axis and L its angular momentum in
space, ω2 is constant,

n' = L × n / J1, L' = m g l e_z × n, r' = (L / J1; 0) r / 2,

and the top's attitude is r exp(y β t / 2), β = ω2 (1 - J2/J1): the frame r does not see the spin,
so that everything that is integrated is slow, and a product of two series.
"""

from collections.abc import Iterator

from mpmath import mp, mpf

from tests.references.figures import DIGITS, Figure, figure, printed

MASS, LENGTH, GRAVITY = "15", "1", "9.81"
ABOUT_CENTRE = ("0.234375", "0.46875", "0.234375")
START = ("0", "150", "-4.61538")
TIMES = ("0.1", "0.2", "0.5", "1", "1.5", "2")
_ORDER, _STEP = 60, "0.1"

Series = list[mpf]


def figures() -> Iterator[Figure]:
    """Euler parameters and speeds of joint j0, position of the centre of mass, x in n."""
    mp.dps = DIGITS
    J = [mpf(x) for x in ABOUT_CENTRE]
    J1, J2, spin = J[0] + mpf(MASS) * mpf(LENGTH)**2, J[1], mpf(START[1])
    torque = mpf(MASS) * mpf(GRAVITY) * mpf(LENGTH)
    momentum = (J1 * mpf(START[0]), J2 * spin, J1 * mpf(START[2]))
    state = [mpf(x) for x in (0, 1, 0, *momentum, 0, 0, 0, 1)]
    t, beta = mpf(0), spin * (1 - J2 / J1)
    for time in TIMES:
        while t < mpf(time):
            h = min(mpf(_STEP), mpf(time) - t)
            state, t = _moved(state, h, J1, torque), t + h
        n, L = state[:3], state[3:6]
        half = beta * t / 2
        q = _quaternions(state[6:], [mpf(0), mp.sin(half), mpf(0), mp.cos(half)])
        rate = [x / J1 + spin * (1 - J2 / J1) * y for x, y in zip(L, n, strict=True)]
        for name, values in (("q.j0", q), ("v.j0", _in_body(q, rate)), ("n", n)):
            for i, value in enumerate(values):
                yield figure(f"{name}.{i}", time, value)


def _moved(state: list[mpf], h: mpf, J1: mpf, torque: mpf) -> list[mpf]:
    """The state after a time h, by its Taylor series."""
    s: list[Series] = [[x] for x in state]
    n, L, r = s[:3], s[3:6], s[6:]
    for order in range(_ORDER):
        pull = (-torque * n[1][order], torque * n[0][order], mpf(0))
        turn = [x / (2 * J1) for x in _products([*L, [mpf(0)] * (order + 1)], r, order)]
        new = [*(x / J1 for x in _crossed(L, n, order)), *pull, *turn]
        for series, x in zip(s, new, strict=True):
            series.append(x / (order + 1))
    return [sum(c * h**k for k, c in enumerate(series)) for series in s]


def _product(a: Series, b: Series, order: int) -> mpf:
    return mp.fdot(a[:order + 1], b[order::-1] if order else b[:1])


def _crossed(a: list[Series], b: list[Series], order: int) -> list[mpf]:
    return [_product(a[i], b[j], order) - _product(a[j], b[i], order)
            for i, j in ((1, 2), (2, 0), (0, 1))]


def _products(a: list[Series], b: list[Series], order: int) -> list[mpf]:
    """The quaternion product a b, both (x, y, z, w)."""
    p = [[_product(x, y, order) for y in b] for x in a]
    return [p[3][0] + p[0][3] + p[1][2] - p[2][1], p[3][1] + p[1][3] + p[2][0] - p[0][2],
            p[3][2] + p[2][3] + p[0][1] - p[1][0], p[3][3] - p[0][0] - p[1][1] - p[2][2]]


def _quaternions(a: list[mpf], b: list[mpf]) -> list[mpf]:
    return _products([[x] for x in a], [[x] for x in b], 0)


def _in_body(q: list[mpf], v: list[mpf]) -> list[mpf]:
    """q* (v; 0) q, |q| = 1."""
    conjugate = [-q[0], -q[1], -q[2], q[3]]
    return _quaternions(_quaternions(conjugate, [*v, mpf(0)]), q)[:3]


if __name__ == "__main__":
    printed("heavy_top", "a Taylor series, 50 digits, rounded to 30.", figures())
