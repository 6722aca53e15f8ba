"""Gravity and the inertias of joints: what effects add to a scene that no motion changes."""

from coscrew_codegen.algebra.recording.numbers import Vector, add
from coscrew_codegen.algebra.recording.recorder import Recorder
from coscrew_codegen.dynamics.forces.acted_coordinates import weights_of
from coscrew_codegen.dynamics.forces.effect_parameters import settings
from coscrew_codegen.dynamics.forces.own_inertias import OwnInertias, SummedInertia
from coscrew_codegen.scene.identifiers import identifiers
from coscrew_codegen.scene.mechanism.tree import Tree
from coscrew_codegen.scene.scene import Applied, Scene


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
