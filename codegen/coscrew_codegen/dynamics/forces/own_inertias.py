"""Inertias of joints themselves, as of the rotors of their motors, and of sums of coordinates; and
gravity: what effects add to a scene that no motion changes."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

from coscrew_codegen.algebra.recording.numbers import Number, Vector, add
from coscrew_codegen.algebra.recording.recorder import Recorder
from coscrew_codegen.dynamics.forces.acted_coordinates import weights_of
from coscrew_codegen.dynamics.forces.effect_parameters import settings
from coscrew_codegen.scene.identifiers import identifiers
from coscrew_codegen.scene.mechanism.tree import Tree
from coscrew_codegen.scene.scene import Applied, Scene


@dataclass(frozen=True)
class SummedInertia:
    """The inertia I against the rate w·v of a weighted sum: I w w^T of the mass matrix."""

    weights: Mapping[int, Fraction]  # by velocity
    inertia: Number

    def along(self, rates: Sequence[Number]) -> Number:
        """w·rates."""
        total = self.inertia.like(0)
        for place, weight in self.weights.items():
            total = total + rates[place] * weight
        return total


class OwnInertias(dict[str, Number]):
    """The inertias of joints themselves, by joint, and `sums`, those of weighted sums."""

    def __init__(self) -> None:
        super().__init__()
        self.sums: list[SummedInertia] = []

    @property
    def alone(self) -> list[SummedInertia]:
        """The inertias of sums of one term, which are on the diagonal."""
        return [x for x in self.sums if len(x.weights) == 1]

    @property
    def coupling(self) -> "OwnInertias":
        """The inertias of sums of several terms alone."""
        result = OwnInertias()
        result.sums = [x for x in self.sums if len(x.weights) > 1]
        return result

    def enter(self, M: list[list[Number]]) -> list[list[Number]]:
        """The mass matrix with those of sums entered."""
        for x in self.sums:
            for i, of_row in x.weights.items():
                for j, of_column in x.weights.items():
                    M[i][j] = M[i][j] + x.inertia * (of_row * of_column)
        return M

    def with_sums(self, torques: list[Number], a: Sequence[Number]) -> list[Number]:
        """Torques by velocity, with those that sums take at the accelerations a."""
        results = list(torques)
        for x in self.sums:
            torque = x.inertia * x.along(a)
            for place, weight in x.weights.items():
                results[place] = results[place] + torque * weight
        return results

    def energy(self, v: Sequence[Number], others: Number) -> Number:
        """A kinetic energy with those of sums, I (w·v)²/2, added."""
        total = others
        for x in self.sums:
            rate = x.along(v)
            total = total + x.inertia * (rate * rate) / 2
        return total


def owner(applied: Applied) -> str:
    """The prefix of the names of an effect's values: elbow_viscous, also for a joint called
    elbow_joint."""
    return f"{(applied.label or applied.on).removesuffix('_joint')}_{applied.effect.name}"


def gravity(scene: Scene, recorder: Recorder) -> Vector | None:
    """The acceleration of gravity of the scene's effects, in the world's frame; None without."""
    total = None
    for applied in scene.effects:
        if applied.effect.gravity:
            values = settings(recorder, applied.values, recorder.number(0))
            own = applied.effect.gravity(values)
            total = own if total is None else add(total, own)
    return total


def joint_inertias(scene: Scene, recorder: Recorder, tree: Tree) -> OwnInertias:
    """The inertias that effects add to joints, and to sums of coordinates."""
    total = OwnInertias()
    for applied in scene.effects:
        if applied.effect.joint_inertia:
            values = settings(recorder, applied.values, recorder.number(0))
            own = applied.effect.joint_inertia(values)
            prefix, = identifiers([owner(applied)])
            own, = recorder.label("I", own, prefix)
            if applied.terms:
                total.sums.append(SummedInertia(weights_of(tree, applied.terms), own))
            else:
                total[applied.on] = total[applied.on] + own if applied.on in total else own
    return total
