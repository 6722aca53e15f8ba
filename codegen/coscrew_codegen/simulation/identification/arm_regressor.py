"""An arm as identification needs it: its torques as a linear function of base parameters."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from coscrew_codegen.dynamics.derivation import Derivation
from coscrew_codegen.program.scene_functions import Coordinate
from coscrew_codegen.runtime.load import kernels_for
from coscrew_codegen.scene.joints import kind_named
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.simulation import SimulateError
from coscrew_codegen.simulation.system import System, system

Reals = NDArray[np.float64]
MOTOR = "actuator"
"""The effect whose torque is what is measured: it is left out, so that inverse dynamics is its
torque."""
_FUNCTIONS = ("base_regressor", "linear_parameters")


@dataclass(frozen=True)
class ArmRegressor:
    """A scene without its motors: tau = Y(q, v, a) beta + tau0, beta = K pi."""

    its: System
    names: tuple[str, ...]  # of pi
    units: tuple[str, ...]
    nonnegative: tuple[bool, ...]
    base_names: tuple[str, ...]  # of beta
    base_units: tuple[str, ...]
    K: Reals  # beta by pi
    links: int  # the first ten numbers of pi for each are its inertia

    @property
    def scene(self) -> Scene:
        """The scene without motors."""
        return self.its.scene

    @property
    def coordinates(self) -> Sequence[Coordinate]:
        """Its joints with coordinates of their own."""
        return self.its.functions.coordinates

    @cached_property
    def pi(self) -> Reals:
        """The scene's own parameters."""
        return np.asarray(self.its.call("linear_parameters"), float)

    @property
    def beta(self) -> Reals:
        """The scene's own base parameters."""
        return self.K @ self.pi

    def at(self, t: Reals, q: Reals, v: Reals, a: Reals) -> tuple[Reals, Reals]:
        """(Y, tau0) at each of these states: (n, NV, base parameters) and (n, NV)."""
        Y, rest = self.its.outputs("base_regressor", t=t, q=q, v=v, a=a)
        return np.asarray(Y), np.asarray(rest)


def arm_of(scene: Scene) -> ArmRegressor:
    """The arm of a scene.  Raises SimulateError for joints with several coordinates."""
    effects = tuple(x for x in scene.effects if x.effect.name != MOTOR)
    scene = replace(scene, effects=effects, functions=_FUNCTIONS, tiers=(), accuracy=(),
                    record=(), expectations=(), precisions=("double",), precision="double")
    derivation = Derivation(scene)
    for c in derivation.tree.coordinates:
        if not kind_named(c.kind).one_coordinate:
            raise SimulateError(f"identify: joint {c.joint!r} is {c.kind}; wanted an arm, whose "
                                "joints have one coordinate each")
    linear = derivation.linear
    K = np.zeros((len(linear.base.places), len(linear.names)))
    for row, terms in zip(K, linear.base.combinations, strict=True):
        for place, weight in terms:
            row[place] = float(weight)
    its = system(kernels_for(scene, _FUNCTIONS), "double")
    return ArmRegressor(its, linear.names, linear.units, linear.nonnegative, linear.base_names,
                        linear.base_units, K, len(derivation.tree.links))
