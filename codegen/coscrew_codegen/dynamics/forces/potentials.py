"""Forces on bodies that follow from a potential energy V of their pose [R | x].

G = ∂V/∂R and g = ∂V/∂x come from one adjoint pass.  A displacement δx and a rotation δφ of the body
in the world's frame change V by g·δx + Σ (R_j × G_j)·δφ, with the columns R_j and G_j.  So the
force is -R^T g in the body's frame, and the moment about its origin -Σ e_j × R^T G_j.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from coscrew_codegen.algebra.recording import numbers
from coscrew_codegen.algebra.recording.numbers import (
    Number,
    Vector,
    add,
    cross,
    negative,
    rotated_back,
    rotation,
)
from coscrew_codegen.algebra.recording.recorder import Recorder, array
from coscrew_codegen.dynamics.algorithms.motion import Displacement
from coscrew_codegen.dynamics.forces.body_motion import BodyInWorld, BodyOfLink
from coscrew_codegen.dynamics.forces.effect_parameters import settings
from coscrew_codegen.program import differentiate
from coscrew_codegen.scene.effect import BodyState, Force, Values, required
from coscrew_codegen.scene.scene import Setting

BodyLaw = Callable[[BodyState, Values], Force]


def body_force(law: BodyLaw, state: BodyOfLink, values: Mapping[str, Setting]) -> Force:
    """The law's Force, with force and moment derived from the energy if it gives only that."""
    force = law(state, settings(state.t.recorder, values, state.t))
    if force.force is not None or force.moment is not None:
        return force
    if force.energy is None:
        raise TypeError("an effect on a body gives a force, a moment or an energy; this one "
                        "gives none")
    slope = _slope(law, state, values)
    columns = [rotated_back(rotation(state.pose), slope[j::4]) for j in range(4)]
    zero = state.t.like(0)
    moment: Vector = (zero, zero, zero)
    for j in range(3):
        axis = tuple(zero.like(int(i == j)) for i in range(3))
        moment = add(moment, cross(columns[j], axis))
    return Force((zero, zero, zero), negative(columns[3]), moment, force.energy, force.power)


def _slope(law: BodyLaw, state: BodyOfLink, values: Mapping[str, Setting]) -> tuple[Number, ...]:
    """∂V/∂[R | x], row by row."""
    outer = state.t.recorder
    p = [a for a in outer.inputs if a.name == "p"]
    recorder = Recorder([array("D", (3, 4)), array("g", (3,)), array("t", ()), *p])
    (t,) = recorder.argument("t")
    posed = _Posed(state.own, t, recorder.argument("D"), recorder.argument("g"))
    energy = required(law(posed, settings(recorder, values, t)).energy)
    program = recorder.program("energy", [(array("V", ()), [energy])])
    given = [state.pose, state.gravity, (state.t,), *(outer.argument(a.name) for a in p)]
    _, result = differentiate.adjoint(program, outer.arithmetic, numbers, given, [outer.number(1)])
    return tuple(outer.number(0) if x is None else x for x in result[0])


@dataclass(frozen=True)
class _Posed(BodyInWorld):
    """A body at a given pose, without velocities."""

    D: Displacement
    g: Vector

    @property
    def gravity(self) -> Vector:
        """The scene's gravity."""
        return self.g

    @property
    def pose(self) -> Displacement:
        """The given pose."""
        return self.D

    @property
    def angular_velocity(self) -> Vector:
        """Raises TypeError: an energy must not depend on it."""
        raise TypeError("an energy from which a force follows depends on the body's pose and on "
                        "time, not on velocities")

    def velocity(self, point: Vector) -> Vector:
        """Raises TypeError: an energy must not depend on it."""
        return self.angular_velocity

    velocity_in_fluid = velocity

    def above_ground(self, position: Vector) -> tuple[Number, Vector]:
        """Raises TypeError: the ground exerts forces of its own."""
        raise TypeError("an energy from which a force follows does not depend on the ground")
