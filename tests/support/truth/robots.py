"""Random robots, and their dynamics to any number of digits by the tests' Newton-Euler method.

Trees of revolute, prismatic and fixed joints under gravity, with springs, dampers, friction and
rotors at the joints.  Shares nothing with the generator but the model.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, TypeAlias

import mpmath
import numpy as np
from mpmath import mpf

from coscrew_codegen.scene.mechanism.model import WORLD, Body, Joint, Model, Placement
from coscrew_codegen.scene.scene import Scene
from tests.support.scenes import mechanisms as m
from tests.support.scenes.kinds import Kind
from tests.support.truth.newton_euler import inverse_dynamics

Numbers: TypeAlias = list[Any]  # mpmath has no types

GRAVITY = (Fraction("0.3"), Fraction("-0.7"), Fraction("-9.81"))
FUNCTIONS = ("inverse_dynamics", "forward_dynamics", "mass_matrix")
KINDS = (*[Kind.REVOLUTE] * 5, *[Kind.PRISMATIC] * 3, Kind.FIXED)
ABSENT = dict.fromkeys(("k", "q0", "d", "tau_c", "rotor"), Fraction(0)) | {
    "eps": Fraction(1), "gear": Fraction(1)}


@dataclass(frozen=True)
class Robot:
    """A scene, and the effects at each of its joints that move."""

    scene: Scene
    acting: tuple[dict[str, Fraction], ...]

    def inverse(self, q: Numbers, v: Numbers, a: Numbers,
                gravity: Sequence[Fraction] = GRAVITY) -> Numbers:
        """The torques that the joints must supply besides their springs, dampers and friction."""
        tau = inverse_dynamics(self.scene.model, gravity, q, v, a)
        return [x + _against(given, *state) for x, given, *state in zip(
            tau, self.acting, q, v, a, strict=True)]

    def mass_matrix(self, q: Numbers) -> Any:
        """Its columns are the torques of unit accelerations at rest, less those at rest; an entry
        that cancels to rounding is zero."""
        n, least = len(q), mpf(10)**(20 - mpmath.mp.dps)
        still = [mpf(0)] * n
        rest = self.inverse(q, still, still)
        units = [[mpf(j == k) for j in range(n)] for k in range(n)]
        return mpmath.matrix([[mpmath.chop(x - y, least) for x, y in zip(
            self.inverse(q, still, unit), rest, strict=True)] for unit in units]).T

    def forward(self, q: Numbers, v: Numbers, tau: Numbers) -> Numbers:
        """a with M a + bias = τ by elimination."""
        bias = self.inverse(q, v, [mpf(0)] * len(q))
        right = mpmath.matrix([x - y for x, y in zip(tau, bias, strict=True)])
        return list(mpmath.lu_solve(self.mass_matrix(q), right))

    def true(self, function: str, given: Sequence[Numbers]) -> Numbers:
        """All components of a function's result."""
        if function == "mass_matrix":
            M = self.mass_matrix(*given)
            return [M[i, k] for i in range(M.rows) for k in range(M.cols)]
        return (self.inverse if function == "inverse_dynamics" else self.forward)(*given)


def _against(given: dict[str, Fraction], q: Any, v: Any, a: Any) -> Any:
    """k (q - q0) + d v + τc tanh(v / eps) + gear² rotor a."""
    k, q0, d, tau_c, rotor, eps, gear = (
        mpf(given[x].numerator) / given[x].denominator
        for x in ("k", "q0", "d", "tau_c", "rotor", "eps", "gear"))
    return k * (q - q0) + d * v + tau_c * mpmath.tanh(v / eps) + gear**2 * rotor * a


def robot(number: int) -> Robot:
    """One of an endless row of robots: three to six joints that move, and some that do not."""
    draw = np.random.default_rng((60, number))
    bodies: list[Body] = []
    joints: list[Joint] = []
    moving = int(draw.integers(3, 7))
    while sum(x.kind is not Kind.FIXED for x in joints) < moving:
        n = len(bodies)
        kind = KINDS[draw.integers(len(KINDS))]
        parent = f"b{draw.integers(n)}" if n and draw.integers(8) else WORLD
        place = Placement(_rotation(draw), tuple(_decimals(draw, 3, 500)))
        bodies.append(Body(f"b{n}", m.inertia(_decimal(draw, 100, 4000), _decimals(draw, 3, 200), (
            *(_decimal(draw, 200, 500) for _ in range(3)), *_decimals(draw, 3, 60)))))
        joints.append(Joint(f"j{n}", kind, parent, f"b{n}", place, _axis(draw)))
    acting, effects = [], [m.gravity(*GRAVITY)]
    for joint in joints:
        if joint.kind is not Kind.FIXED:
            acting.append(ABSENT | _effects(draw))
            effects += _applied(joint.name, acting[-1])
    model = Model(f"robot{number}", tuple(bodies), tuple(joints))
    return Robot(Scene(model.name, model, tuple(sorted(effects, key=lambda x: x.effect.name)),
                       functions=FUNCTIONS, tiers=("accurate", "certified")), tuple(acting))


def _effects(draw: np.random.Generator) -> dict[str, Fraction]:
    """The parameters of each effect; a joint has half of the effects."""
    chosen: dict[str, Fraction] = {}
    for names in (("k", "q0"), ("d",), ("tau_c", "eps"), ("rotor", "gear")):
        if draw.integers(2):
            chosen |= {x: _decimal(draw, 10, 3000) for x in names}
    return chosen


def _applied(joint: str, given: dict[str, Fraction]) -> list[Any]:
    results = []
    for name, marking, words in (("spring", "k", ("k", "q0")), ("viscous", "d", ("d",)),
                                 ("coulomb", "tau_c", ("tau_c", "eps")),
                                 ("armature", "rotor", ("rotor", "gear"))):
        if given[marking]:
            results.append(m.applied(name, joint, **{x: given[x] for x in words}))
    return results


def _decimal(draw: np.random.Generator, least: int, most: int) -> Fraction:
    return Fraction(int(draw.integers(least, most)), 1000)


def _decimals(draw: np.random.Generator, count: int, most: int) -> tuple[Fraction, ...]:
    return tuple(_decimal(draw, -most, most) for _ in range(count))


def _axis(draw: np.random.Generator) -> tuple[Fraction, ...]:
    return (m.X, m.Y, m.Z)[draw.integers(3)]


def _rotation(draw: np.random.Generator) -> tuple[Fraction, ...]:
    """The rotation of a quaternion of small integers, whose matrix is rational."""
    x, y, z, w = (Fraction(int(n)) for n in (*draw.integers(-3, 4, 3), draw.integers(1, 5)))
    s = 2 / (x * x + y * y + z * z + w * w)
    return (1 - s * (y * y + z * z), s * (x * y - z * w), s * (x * z + y * w),
            s * (x * y + z * w), 1 - s * (x * x + z * z), s * (y * z - x * w),
            s * (x * z - y * w), s * (y * z + x * w), 1 - s * (x * x + y * y))
