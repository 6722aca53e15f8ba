"""Derivatives of steps."""

from dataclasses import replace

from coscrew_codegen.scene import units
from coscrew_codegen.scene.functions.derivatives.directions import displacements
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.scene.scene_function import Array, AxisLength, Depends, SceneFunction
from coscrew_codegen.scene.units import Kinds, Units


def _matrices(scene: Scene) -> dict[str, Array]:
    """The derivatives by q and v, tau and p, if the step takes these."""
    displaced = displacements(scene)

    def state(kinds: Kinds) -> tuple[str, ...]:
        own = displaced(kinds) if callable(displaced) else displaced
        return *own, *units.velocities(kinds)

    def by(columns: Units) -> Units:
        return lambda kinds: units.over(
            state(kinds), columns(kinds) if callable(columns) else columns)

    return {"q": Array("A", (AxisLength.STATE, AxisLength.STATE), by(state)),
            "tau": Array("B_tau", (AxisLength.STATE, AxisLength.NV), by(units.torques)),
            "p": Array("B_p", (AxisLength.STATE, AxisLength.PARAMETERS), ("1",))}


def _of(own: SceneFunction, function: SceneFunction, scene: Scene) -> SceneFunction | None:
    """The step's derivatives."""
    if not function.step:
        return None
    given = {x.name for x in function.inputs_in(scene)}
    return replace(
        function, name=f"{function.name}_derivatives", place=own.place, differentiates=function,
        words=own.words.replace("step_INTEGRATOR", function.name), step=None, default=own.default,
        outputs=(*function.outputs_in(scene),
                 *(x for y, x in _matrices(scene).items() if y in given)),
        compute=lambda x: x.step_derivatives(function), members=None)


FUNCTION = SceneFunction(
    "step_INTEGRATOR_derivatives", 290, "q and v after step_INTEGRATOR, and their derivatives: A "
    "by q and v, B_tau by tau if the step takes it, B_p by p; of coordinates along velocities; of "
    "a step that is split at limits, one part", "h q v", (), None, Depends.EFFECTS, each=_of)
