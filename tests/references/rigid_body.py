"""A body that turns freely, by elliptic functions and Legendre's third integral, to 50 digits.

Euler's equations I ω' + ω × I ω = 0 with I1 < I2 < I3.  Where L² < 2 T I2,
ω1 = C dn u, ω2 = B sn u, ω3 = A cn u; where L² > 2 T I2 the first and the third change places.
The attitude is Rz(φ) Rx(θ) Rz(ψ) in a frame whose z axis is L: I ω / L = (sin θ sin ψ, sin θ cos ψ,
cos θ) and φ' = L (2 T - I3 ω3²) / (L² - I3² ω3²), whose integral is Legendre's Π.
"""

from collections.abc import Iterator
from dataclasses import dataclass

from mpmath import matrix, mp, mpf

from tests.references.figures import DIGITS, Figure, figure, printed

NUT = (("1e-4", "2e-4", "2.5e-4"), ("0.1", "10", "0"))
"""Moments of inertia and angular velocity at the start of examples/scenes/wingnut.toml."""
NUT_VELOCITY = "0.02"
TOP = (("1", "2", "4"), ("0.7", "0.2", "1.1"))
"""The same of a body that turns about its largest moment of inertia."""
TIMES = ("0.5", "1", "2", "3", "5", "7", "10")


@dataclass(frozen=True)
class Solution:
    """ω(t) of three moments of inertia, ascending, with L² and 2 T as they are at the start."""

    I: tuple[mpf, mpf, mpf]
    L2: mpf
    T2: mpf
    swapped: bool  # L² < 2 T I2: dn belongs to axis 1
    A: mpf  # of cn
    B: mpf  # of sn, with sign
    C: mpf  # of dn
    rate: mpf  # u' with its sign
    m: mpf
    u0: mpf

    def omega(self, t: mpf) -> tuple[mpf, mpf, mpf]:
        """In the body's axes."""
        u = self.u0 + self.rate * t
        cn, sn, dn = (mp.ellipfun(name, u, m=self.m) for name in ("cn", "sn", "dn"))
        first, second, third = self.A * cn, self.B * sn, self.C * dn
        return (third, second, first) if self.swapped else (first, second, third)

    @property
    def flip(self) -> mpf:
        """From one reversal of ω2 to the next, in s."""
        return 2 * mp.ellipk(self.m) / abs(self.rate)


def solution(moments: tuple[str, ...], start: tuple[str, ...]) -> Solution:
    """The solution for moments I1 < I2 < I3 and ω at t = 0, where ω along dn's axis is positive."""
    I, w = tuple(map(mpf, moments)), tuple(map(mpf, start))
    L2, T2 = (sum(i**n * x**2 for i, x in zip(I, w, strict=True)) for n in (2, 1))
    swapped = T2 * I[1] > L2
    a, b, c = (I[2], I[1], I[0]) if swapped else I
    wa, wb, _ = (w[2], w[1], w[0]) if swapped else w
    A = mp.sqrt((T2 * c - L2) / (a * (c - a)))
    B = mp.sqrt((T2 * c - L2) / (b * (c - b)))
    C = mp.sqrt((L2 - T2 * a) / (c * (c - a)))
    m = (b - a) * (T2 * c - L2) / ((c - b) * (L2 - T2 * a))
    rate = mp.sqrt((c - b) * (L2 - T2 * a) / (a * b * c))
    # three of the signs of A, B, C and u' are free; here B follows from the equations
    sign = mp.sign((c - a) * A * C / (b * B * rate)) * (-1 if swapped else 1)
    B *= sign
    turned = mp.atan2(wb / B, wa / A)
    return Solution(I, L2, T2, swapped, A, B, C, rate, m, mp.ellipf(turned, m))


def attitude(body: Solution, t: mpf) -> matrix:
    """R of the body's axes in those that it has at t = 0.  (3, 3)."""
    start, now = _in_frame_of_L(body, mpf(0), mpf(0)), _in_frame_of_L(body, t, _precession(body, t))
    return start.T * now


def _in_frame_of_L(body: Solution, t: mpf, phi: mpf) -> matrix:
    n = [i * w / mp.sqrt(body.L2) for i, w in zip(body.I, body.omega(t), strict=True)]
    return _about_z(phi) * _about_x(mp.acos(n[2])) * _about_z(mp.atan2(n[0], n[1]))


def _precession(body: Solution, t: mpf) -> mpf:
    """∫ φ' dt from 0 to t, in closed form: φ' = L/I3 + L (2 T - L²/I3) / (L² - I3² ω3²)."""
    L, I3 = mp.sqrt(body.L2), body.I[2]
    if body.swapped:  # ω3² = A² (1 - sn²)
        base, n = body.L2 - (I3 * body.A)**2, -(I3 * body.A)**2
    else:  # ω3² = C² (1 - m sn²)
        base, n = body.L2 - (I3 * body.C)**2, -body.m * (I3 * body.C)**2
    n /= base
    ends = [_legendre(n, body.u0 + body.rate * x, body.m) for x in (mpf(0), t)]
    return L * t / I3 + L * (body.T2 - body.L2 / I3) / base * (ends[1] - ends[0]) / body.rate


def _legendre(n: mpf, u: mpf, m: mpf) -> mpf:
    """∫ du / (1 - n sn² u) from 0."""
    half = 2 * mp.ellipk(m)
    turns = mp.nint(u / half)
    rest = u - turns * half
    sn, cn = (mp.ellipfun(name, rest, m=m) for name in ("sn", "cn"))
    return 2 * turns * mp.ellippi(n, m) + mp.ellippi(n, mp.atan2(sn, cn), m)


def _about_z(angle: mpf) -> matrix:
    s, c = mp.sin(angle), mp.cos(angle)
    return matrix([[c, -s, 0], [s, c, 0], [0, 0, 1]])


def _about_x(angle: mpf) -> matrix:
    s, c = mp.sin(angle), mp.cos(angle)
    return matrix([[1, 0, 0], [0, c, -s], [0, s, c]])


def figures_of(body: Solution, joint: str, name: str, first: int) -> Iterator[Figure]:
    """Angular velocity, from component `first` of v on, and attitude; also at reversals of ω2."""
    for t in (*map(mpf, TIMES), body.flip, 2 * body.flip):
        for i, w in enumerate(body.omega(t)):
            yield figure(f"v.{joint}.{first + i}", t, w)
        R = attitude(body, t)
        for i in range(3):
            for k in range(3):
                yield figure(f"pose.{name}.{4 * i + k}", t, R[i, k])


def figures() -> Iterator[Figure]:
    """The wing nut's; and an Euler top's: joint j0 and body b0, as tests name them."""
    mp.dps = DIGITS
    yield from figures_of(solution(*NUT), "base", "nut", 3)
    for t in TIMES:
        yield figure("position.nut.0", t, mpf(NUT_VELOCITY) * mpf(t))
    yield from figures_of(solution(*TOP), "j0", "b0", 0)


if __name__ == "__main__":
    printed("rigid_body", "Jacobi's elliptic functions, 50 digits, rounded to 30.", figures())
