"""Results of `integrated` for a free joint, in MPFR, and hard states.

    (p + R(q) J(w) v;  t/|t|),    t = q exp(w/2),    J(w) the left Jacobian

where q need not have norm 1."""

import math
from collections.abc import Sequence

import gmpy2
import numpy as np
from gmpy2 import mpfr
from numpy.typing import NDArray

from tests.support.truth.mpfr_motions import BITS, cross, dot, jacobian, ratio, times, versor

ANGLES = np.array([0, 1e-9, 1e-3, 0.5, 1, 1.5, 2, 3, *(np.pi * n / 2 for n in range(1, 5))])
"""Among them those where series give way to closed forms, π and 2π."""
Array = NDArray[np.float64]


def drawn(rng: np.random.Generator, number: int, kind: type[np.floating]) -> tuple[Array, Array]:
    """q and φ: quaternions that nearly cancel the turn, unit ones, and some of other norms; linear
    parts of all sizes, along the axis and not."""
    def some(chance: float) -> NDArray[np.bool_]:
        return rng.random((number, 1)) < chance

    angle, axis = angles(rng, number, kind), axes(rng, number)
    w, v = angle * axis, axes(rng, number) * powers(rng, number, kind)
    v = np.select([some(0.15), some(0.15)], [w, v + 9 * abs(v).max(1, keepdims=True) * axis], v)
    known = np.where(abs(angle) < 1e6, angle, 0)
    back = np.hstack([-np.sin(known / 2) * axis, np.cos(known / 2)])
    q = np.select([some(0.2), some(0.3)], [
        np.eye(4)[rng.integers(0, 4, number)],
        back + 10**rng.uniform(-17, -1, (number, 1)) * rng.normal(size=(number, 4))
    ], rng.normal(size=(number, 4)))
    q *= np.where(some(0.1), powers(rng, number, kind), 1) / np.linalg.norm(q, axis=1)[:, None]
    p = rng.normal(size=(number, 3)) * np.where(some(0.2), 0, 10**rng.uniform(-3, 3, (number, 1)))
    return np.hstack([p, q]).astype(kind), np.hstack([v, w]).astype(kind)


def angles(rng: np.random.Generator, number: int, kind: type[np.floating]) -> Array:
    """A column of all sizes, half of it next to ANGLES."""
    some = rng.random((number, 1))
    step = rng.integers(-40, 41, (number, 1)) * rng.choice([0, 0.25, 1, 1e4], (number, 1))
    beside = rng.choice(ANGLES, (number, 1)) * (1 + np.finfo(kind).eps * step)
    return rng.choice([-1, 1], (number, 1)) * np.select(
        [some < 0.5, some < 0.7], [beside, powers(rng, number, kind)],
        rng.uniform(0, 7, (number, 1)))


def axes(rng: np.random.Generator, number: int) -> Array:
    """Axes of length 1, a third of them next to the coordinate axes or on them."""
    along = np.eye(3)[rng.integers(0, 3, number)]
    near = along + 10**rng.uniform(-20, 0, (number, 1)) * rng.normal(size=(number, 3))
    kind = rng.random((number, 1))
    result = np.select([kind < 0.1, kind < 0.3], [along, near], rng.normal(size=(number, 3)))
    return result / np.linalg.norm(result, axis=1)[:, None]


def powers(rng: np.random.Generator, number: int, kind: type[np.floating]) -> Array:
    """A column of sizes, half of them ordinary, the others from the least subnormal number to those
    whose cubes do not overflow."""
    info = np.finfo(kind)
    low, high = math.log10(info.smallest_subnormal), math.log10(info.max) / 3
    ends = np.where(rng.random((number, 1)) < 0.5, [[-6, 3]], [[low, high]])
    return 10**rng.uniform(ends[:, :1], ends[:, 1:])


def integrated(q: Sequence[float], phi: Sequence[float]) -> list[mpfr]:
    """The seven components, for (position; quaternion) and (v; w)."""
    with gmpy2.context(precision=BITS):
        (*p, x, y, z, s), numbers = map(mpfr, q), list(map(mpfr, phi))
        r, w = [x, y, z], numbers[3:]
        step = times(jacobian(w), numbers[:3])
        once = cross(r, step)
        turn = [2 / (dot(r, r) + s * s) * (s * a + b)
                for a, b in zip(once, cross(r, once), strict=True)]
        *e, c = versor(w)
        t = [s * a + c * b + d for a, b, d in zip(e, r, cross(r, e), strict=True)]
        t.append(s * c - dot(r, e))
        factor = 1 / gmpy2.sqrt(dot(t, t))
        return [*(a + b + d for a, b, d in zip(p, step, turn, strict=True)),
                *(factor * a for a in t)]


def ratios(given: tuple[Array, Array], got: Array, bounds: Array) -> Array:
    """Errors as parts of their bounds, rounded up, one component after the other, without
    components that have no bound."""
    errors = []
    for q, phi, results, limits in zip(*(x.tolist() for x in (*given, got, bounds)), strict=True):
        true = integrated(q, phi) if any(map(math.isfinite, limits)) else ()
        errors += [ratio(*x) for x in zip(results, limits, true, strict=False)
                   if math.isfinite(x[1])]
    return np.array(errors)
