"""Coordinates with quaternions move by exponentials, and stay of norm 1."""

import mpmath
import pytest
from mpmath import mpf

from coscrew_codegen.scene.model import HERE, Kind
from tests.support.scenes.evaluation import MULTIPRECISE, Evaluated
from tests.support.scenes.mechanisms import Z, chain, inertia, scene

KINDS = pytest.mark.parametrize("kind", [Kind.SPHERICAL, Kind.FREE], ids=lambda kind: kind.value)


def evaluated(kind: Kind) -> Evaluated:
    """A body behind one joint."""
    return Evaluated(scene(chain((kind, Z, HERE, inertia(1, moments=(1, 2, 2, 0, 0, 0))))),
                     MULTIPRECISE)


def turned(f: Evaluated) -> list[mpf]:
    """A q with a quaternion of norm 1, in fifths."""
    return [mpf(x) for x in (1, -2, 3)[:f.nq - 4]] + [
        mpf(x) / 10 for x in (2, -4, 4, 8)]


@KINDS
def test_rates_of_displacements_are_right_to_third_order(kind: Kind) -> None:
    """d/dt integrated(q, φ + t u) is d/dt integrated(integrated(q, φ), t v), except for O(|φ|⁴)."""
    f = evaluated(kind)
    v = [mpf(x) for x in (3, -1, 2, 1, 4, -2)[-f.nv:]]
    far = [mpf(x) / 10 for x in (2, 1, -3, 2, -2, 1)[-f.nv:]]
    q, t = turned(f), mpf(10)**-5

    def difference(phi: list[mpf]) -> mpf:
        u = f("chart_rate", v=v, phi=phi)
        here = f("integrated", q=q, phi=phi)
        ends = [[(b - a) / (2 * t) for a, b in zip(*(of(s) for s in (-t, t)), strict=True)]
                for of in (lambda s: f("integrated", q=q, phi=[
                               x + s * y for x, y in zip(phi, u, strict=True)]),
                           lambda s: f("integrated", q=here, phi=[s * y for y in v]))]
        return mpmath.norm([a - b for a, b in zip(*ends, strict=True)])

    assert difference([x / 2 for x in far]) <= difference(far) / 14
    assert difference(far) <= mpf(10)**-2


@KINDS
def test_norms_come_back_to_one(kind: Kind) -> None:
    """By a step of Newton's method: 1 + e becomes 1 - 1.5 e² or a smaller error."""
    f = evaluated(kind)
    for e in (mpf(10)**-3, -mpf(10)**-5):
        q = turned(f)
        q[-4:] = [x * (1 + e) for x in q[-4:]]
        found = f("integrated", q=q, phi=[mpf(1) / 7] * f.nv)[-4:]
        assert abs(mpmath.norm(found) - 1) <= 2 * e**2 + mpf(10)**-15
