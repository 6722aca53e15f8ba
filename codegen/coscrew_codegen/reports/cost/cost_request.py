"""Settings of a measurement: functions whose accuracy is measured, numbers of states, digits."""

from collections.abc import Sequence
from dataclasses import dataclass

from coscrew_codegen.program.values.formats import BY_NAME
from coscrew_codegen.reports.cost import CostError
from coscrew_codegen.reports.cost.effect_ablation import SHOWN, Ablation, whole
from coscrew_codegen.reports.cost.measured import Counts
from coscrew_codegen.reports.cost.needs.need import Need, refuse_unknown
from coscrew_codegen.scene.function_selection import (
    ALL,
    DEFAULT,
    FREE,
    all_names,
    resolved,
    together,
)
from coscrew_codegen.scene.functions.whole_scene.mass_matrix import MANY, speeds
from coscrew_codegen.scene.integrators import EMITTED
from coscrew_codegen.scene.patterns import is_pattern
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.simulation.required_functions import of_run

USUAL = (*SHOWN, "body_poses")
"""The functions of a scene that selects none."""


@dataclass(frozen=True)
class CostRequest:
    """The settings of a measurement."""

    functions: tuple[str, ...] = ()  # the given ones, else the scene's
    counts: Counts = Counts()
    digits: int | None = None  # of the reference for runs
    emitted: tuple[str, ...] = tuple(BY_NAME)  # precisions that the scene is generated in
    needs: tuple[Need, ...] = ()

    @property
    def alone(self) -> bool:
        """True if only functions are requested: no effects, no runs."""
        return bool(self.functions or self.needs)

    def of(self, scene: Scene) -> tuple[str, ...]:
        """The names of the functions.  Raises FunctionsError for an unknown one, CostError for a
        step."""
        refuse_unknown(self.needs, all_names(scene))
        given = (*self.functions, *(x.function for x in self.needs))
        words = given or scene.functions
        steps = {name for x in EMITTED for name in (x.step_name, x.step_with_tau)}
        if wrong := [name for name in given if name in steps]:
            raise CostError(f"{wrong[0]}: the error of a step is not that of rounding; without "
                            "--function, cost measures whole runs")
        result = resolved(scene, words) if words else {
            x for x in USUAL if x != "mass_matrix" or speeds(scene) <= MANY}
        return tuple(name for name in all_names(scene) if name in result and name not in steps)

    def needed(self, scene: Scene, integrator: str | None) -> tuple[str, ...]:
        """The functions that the measurement calls."""
        names = self.of(scene)
        if not self.alone:
            return whole(scene, names)
        return together(of_run(scene, integrator), ("inverse_dynamics", "forward_dynamics"), FREE)


def refuse_absent(request: CostRequest, part: Ablation) -> None:
    """Raises CostError for a function that was requested by its name, and that only scenes of
    another kind have."""
    for name in (*request.functions, *(x.function for x in request.needs)):
        if not is_pattern(name) and name not in (DEFAULT, ALL, *(f.name for f in part.public)):
            raise CostError(f"{part.functions.name}: there is no {name}: only scenes with a "
                            "floating base or with limits have it")


def present(wanted: Sequence[str], part: Ablation) -> tuple[str, ...]:
    """Returns the names that the part has."""
    return tuple(name for name in wanted if any(f.name == name for f in part.public))
