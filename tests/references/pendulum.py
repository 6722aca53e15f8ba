"""The pendulum released from the horizontal, by Jacobi's elliptic functions, to 50 digits.

With θ from the lowest point, l θ'' = -g sin θ and θ(0) = -θ0 at rest:
sin(θ/2) = -k cd(u), cos(θ/2) = k' nd(u), θ' = 2 ω k k' sd(u); k = sin(θ0/2), ω = √(g/l), u = ω t.
"""

from collections.abc import Iterator

from mpmath import mp, mpf

from tests.references.figures import DIGITS, Figure, figure, printed

TIMES = tuple(str(x) for x in (0.25, 0.5, 1, 2, 3, 5, 7, 10))


class Pendulum:
    """A point mass of 1 kg on a rod of l = 1 m, g = 9.81 m/s², let go at θ = -π/2."""

    def __init__(self) -> None:
        self.g, self.start = mpf("9.81"), mp.pi / 2
        self.k, self.rate = mp.sin(self.start / 2), mp.sqrt(self.g)
        self.m = self.k**2
        self.period = 4 * mp.ellipk(self.m) / self.rate

    def at(self, t: mpf) -> tuple[mpf, mpf]:
        """θ and θ'."""
        u = self.rate * t
        cd, nd, sd = (mp.ellipfun(name, u, m=self.m) for name in ("cd", "nd", "sd"))
        other = mp.sqrt(1 - self.m)
        theta = 2 * mp.atan2(-self.k * cd, other * nd)
        return theta, 2 * self.rate * self.k * other * sd


def figures() -> Iterator[Figure]:
    """Angle, speed, position of the mass, force along the rod; also at quarters of the period."""
    mp.dps = DIGITS
    pendulum = Pendulum()
    quarters = [i * pendulum.period / 4 for i in (1, 2, 3, 4)]
    for t in (*map(mpf, TIMES), *quarters):
        theta, rate = pendulum.at(t)
        yield figure("q.pivot", t, theta)
        yield figure("v.pivot", t, rate)
        yield figure("position.bob.0", t, mp.sin(theta))
        yield figure("position.bob.1", t, -mp.cos(theta))
        yield figure("reaction.pivot.1", t, rate**2 + pendulum.g * mp.cos(theta))


if __name__ == "__main__":
    printed("pendulum", "Jacobi's elliptic functions, 50 digits, rounded to 30.", figures())
