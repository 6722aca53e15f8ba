"""States at which another program has computed a robot's torques and mass matrix."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass

import numpy as np

from coscrew_codegen.dynamics import derive
from coscrew_codegen.program.scene_functions import SceneFunctions
from coscrew_codegen.scene.scene import Scene
from tests.support.scenes.evaluation import DOUBLE, Evaluated

Array = np.ndarray
FUNCTIONS = ("inverse_dynamics", "mass_matrix")


@dataclass(frozen=True)
class PeerState:
    """q, v and a in our coordinates, and the other program's results in them."""

    q: Array
    v: Array
    a: Array
    mass_matrix: Array
    torques: Array


@dataclass(frozen=True)
class Worst:
    """The largest differences, relative to the largest entry."""

    mass_matrix: float
    bias: float
    torques: float

    @property
    def all(self) -> float:
        """The largest of them."""
        return max(self.mass_matrix, self.bias, self.torques)


def worst(torques: Callable[[Array, Array, Array], Array], mass_matrix: Callable[[Array], Array],
          states: Iterable[PeerState]) -> Worst:
    """The largest differences of these functions from another program's results."""
    largest = [0.0, 0.0, 0.0]
    for x in states:
        inertial = x.mass_matrix @ x.a
        scale = max(np.abs(x.torques).max(), np.abs(inertial).max())
        pairs = ((mass_matrix(x.q), x.mass_matrix, np.abs(x.mass_matrix).max()),
                 (torques(x.q, x.v, np.zeros_like(x.a)), x.torques - inertial, scale),
                 (torques(x.q, x.v, x.a), x.torques, scale))
        for n, (ours, theirs, size) in enumerate(pairs):
            error = np.abs(ours - theirs).max() / max(size, 1e-300)
            largest[n] = float(np.maximum(largest[n], error))  # NaN if any is
    return Worst(*largest)


def worst_of_programs(scene: Scene, functions: SceneFunctions, states: Iterable[PeerState]
                      ) -> Worst:
    """The largest differences of a scene's derived functions, evaluated without a compiler."""
    f = Evaluated(scene, DOUBLE, functions)

    def torques(q: Array, v: Array, a: Array) -> Array:
        return np.array(f.components("inverse_dynamics", q=q, v=v, a=a), float)

    def mass_matrix(q: Array) -> Array:
        return np.array(f.components("mass_matrix", q=q), float).reshape(f.nv, f.nv)

    return worst(torques, mass_matrix, states)


def derived(scene: Scene) -> SceneFunctions:
    """The functions that are compared."""
    return derive(scene, FUNCTIONS)
