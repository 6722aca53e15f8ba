"""Random numbers of scenes, and gains that give a mechanism's stiffest part a wanted rate."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TypeVar

import numpy as np
import pinocchio as pin

from tests.support.motions.dynamics import Dynamics
from tests.support.motions.mechanism import Body, Mechanism, Motion, State, rounded

Chosen = TypeVar("Chosen")
STEP = 1e-3
RATES = (0.05, 0.1, 0.2, 0.5, 1.0, 1.4, 2.0, 3.0, 5.0, 10.0, 20.0, 50.0)
"""Rates of the stiffest part, in rad per step, over which each family goes."""
_MOST = 6000.0
"""Radians that an undamped part turns in a run: so long the judge takes."""


class Draw:
    """Numbers of a scene, by its seed."""

    def __init__(self, *seed: int | str):
        self._rng = np.random.default_rng([
            x if isinstance(x, int) else int.from_bytes(x.encode(), "little") for x in seed])

    def between(self, low: float, high: float) -> float:
        return rounded(self._rng.uniform(low, high))

    def over(self, low: float, high: float) -> float:
        """Evenly by its logarithm."""
        return rounded(math.exp(self._rng.uniform(math.log(low), math.log(high))))

    def one(self, choices: Sequence[Chosen]) -> Chosen:
        return choices[int(self._rng.integers(len(choices)))]

    def either_way(self, low: float, high: float) -> float:
        return self.between(low, high) * self.one((-1, 1))


@dataclass(frozen=True)
class Wanted:
    """A scene to draw: `shape` is the same for all scenes of a family, `draw` its own; `rate` that
    of its stiffest part, per step."""

    family: str
    number: int
    shape: Draw
    draw: Draw
    per_step: float

    @property
    def rate(self) -> float:
        """In rad/s, for steps of 1 ms."""
        return rounded(self.per_step / STEP)

    def seconds(self, *choices: float, damped: bool = False) -> float:
        """A duration: at least 100 steps."""
        most = math.inf if damped else max(0.1, _MOST / self.rate)
        return rounded(min(self.draw.one(choices or (0.1, 0.3)), most), 2)

    def motion(self, mechanism: Mechanism, q: State, v: State | None = None,
               duration: float = 0.3, step: float = STEP, rate: float = 0.0, length: float = 1.0,
               chaotic: bool = False, about: str = "", adaptive: bool = False,
               pair: tuple[tuple[str, float], ...] = ()) -> Motion:
        return Motion(self.family, self.number, mechanism, q, v or {}, duration, (step,),
                      rate or self.rate, length, chaotic, about or f"h w = {self.per_step:g}",
                      adaptive, pair)


Family = Callable[[Wanted], Motion]


def link(name: str, mass: float, length: float) -> Body:
    """A rod that hangs from its joint."""
    m = mass * length**2
    return Body(name, mass, (rounded(m / 12), rounded(m / 12), rounded(m / 300)),
                (0.0, 0.0, -length / 2))


def of_hinge(mass: float, length: float) -> float:
    """A rod's moment of inertia about its hinge."""
    return rounded(mass * length**2 / 12) + mass * (length / 2)**2


def scale(mechanism: Mechanism, q: State, stiffness: dict[str, float], rate: float) -> float:
    """The factor on these stiffnesses of joints with which the stiffest mode has the rate."""
    its = Dynamics(mechanism)
    M = pin.crba(its.model, its.data, its.packed(q, {})[:its.model.nq])
    M, K = np.triu(M) + np.triu(M, 1).T, np.zeros(its.model.nv)
    for p in its.places:
        K[p.v] = stiffness.get(p.joint.name, 0.0)
    return float(rate**2 / np.abs(np.linalg.eigvals(np.linalg.solve(M, np.diag(K)))).max())
