"""Refuses parameters by the scene's own rules before anything starts.

The rules concern one number each (signs, ranges of the precision), the numbers of one body or one
effect (possible inertias, ends in order), or require enough mass.  The allowed sets are convex, so
a box is allowed if its corners are.  It suffices to try the corners of each body's and each
effect's numbers, with the others at their lower ends, where mass is least."""

from collections.abc import Iterator, Mapping
from itertools import product

from coscrew_codegen.program.values.formats import Precision
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.simulation import SimulateError
from coscrew_codegen.simulation.parameter_checks import refuse_settings
from coscrew_codegen.simulation.sweep import SweepError
from coscrew_codegen.simulation.sweep.specification import Varied


def refuse(scene: Scene, settings: Mapping[str, float], varied: Varied, precision: Precision
           ) -> None:
    """Raise SweepError if a member could have parameters that are refused."""
    refuse_settings(scene, settings, precision)
    for name, ends in varied.ends.items():
        if (most := max(map(abs, ends))) > precision.limit("max"):
            raise SweepError(f"{name}: {most:.9g} overflows in {precision.name} precision")
    for corner in _corners(scene, varied):
        try:
            refuse_settings(scene, {**settings, **corner}, precision)
        except SimulateError as error:
            named = str(error).replace("--set ", "")
            raise SweepError(f"at an end of the varied ranges: {named}") from None


def _corners(scene: Scene, varied: Varied) -> Iterator[Mapping[str, float]]:
    ends = {x.name: varied.ends[x.name] for x in varied.columns if x.array == "p"}
    lowest = {name: low for name, (low, _) in ends.items()}
    owners: dict[str, list[str]] = {}
    for name in ends:
        owners.setdefault(_owner(scene, name), []).append(name)
    for names in owners.values():
        for corner in product(*(ends[name] for name in names)):
            yield lowest | dict(zip(names, corner, strict=True))


def _owner(scene: Scene, name: str) -> str:
    """The body or effect whose number it is."""
    bodies = (x.name for x in scene.model.bodies if name.startswith(f"{x.name}."))
    return next(bodies, name.rpartition(".")[0])
