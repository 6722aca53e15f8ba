"""An arm of seven joints, its motions, and the exact torques that these take."""

from fractions import Fraction

import mpmath
import numpy as np

from coscrew_codegen.program.values.formats import Precision
from coscrew_codegen.scene.mechanism.model import Model
from tests.support.scenes import mechanisms as m
from tests.support.scenes.kinds import Kind
from tests.support.scenes.tiers import DIGITS
from tests.support.truth.newton_euler import inverse_dynamics

GRAVITY = (Fraction(0), Fraction(0), Fraction("-9.81"))


def arm(scale: Fraction = Fraction(1)) -> Model:
    """Seven joints, as the arms of industry; each link's mass and size are `scale` times those of
    the link before."""
    axes = ((m.Z, "0"), (m.Y, "0.333"), (m.Z, "0"), (m.Y, "0.316"), (m.Z, "0.0825"), (m.Y, "0.384"),
            (m.Z, "0.088"))
    links = []
    for n, (axis, length) in enumerate(axes):
        k = scale**n
        com = (Fraction("0.01") * k, Fraction("-0.02") * k, Fraction("0.07") * k)
        moments = tuple(Fraction(x) * k**3 for x in (
            "0.013", "0.011", "0.009", "0.0004", "-0.0011", "0.0007"))
        links.append((Kind.REVOLUTE, axis, m.at(0, "0.01", Fraction(length) * k),
                      m.inertia(Fraction("3.1") * k, com, moments)))
    return m.chain(*links, name="arm")


def motions(count: int, precision: Precision) -> np.ndarray:
    """Random q, v, a, in rows of three."""
    draw = np.random.default_rng(7)
    return draw.uniform(-2, 2, (count, 3, 7)).astype(precision.numpy_type)


def exact(row: np.ndarray) -> list[mpmath.mpf]:
    return [mpmath.mpf(float(x)) for x in row]


def inverse(model: Model, q: np.ndarray, v: np.ndarray, a: np.ndarray) -> list[mpmath.mpf]:
    with mpmath.workdps(DIGITS):
        return inverse_dynamics(model, GRAVITY, *map(exact, (q, v, a)))
