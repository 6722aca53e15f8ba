"""Steps of integrators, which call other functions."""

from dataclasses import replace

from coscrew_codegen.scene.integrators import DEFAULT, EMITTED, named
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.scene.scene_function import IF_SELECTED, Default, Depends, Q, SceneFunction, V


def _members(own: SceneFunction, scene: Scene) -> tuple[SceneFunction, ...]:
    """One for each integrator, and one for each with torques of joints."""
    return (*(replace(own, name=x.step_name, words=x.equation, target=x.name, step=x)
              for x in EMITTED),
            *(replace(own, name=x.step_with_tau, words=x.equation, target=x.name, step=x,
                      inputs="h q v tau", default=IF_SELECTED) for x in EMITTED))


def _of_run(scene: Scene, integrator: str) -> bool:
    """Returns whether it is the integrator of the scene's run, or the default one if SciPy's steps.
    """
    own = named(scene.run.integrator)
    return integrator == (own.name if own.emitted else DEFAULT)


FUNCTION = SceneFunction(
    "step_INTEGRATOR", 210, "q and v after a step of h; step_INTEGRATOR_tau with torques of joints",
    "h q v", (Q, V), None, Depends.EFFECTS,
    Default("by default, for the integrator of the scene; with torques if selected", _of_run),
    divides=True, members=_members)
