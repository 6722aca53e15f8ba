"""Closures of loops, and the rows that hold them."""

from coscrew_codegen.scene import units
from coscrew_codegen.scene.scene_function import (
    Array,
    AxisLength,
    Default,
    SceneFunction,
)
from coscrew_codegen.scene.situation import LOOPS, Situation

BY_DEFAULT = Default("by default, if the scene has loops", lambda scene, target: True)


def _units(its: Situation) -> tuple[str, ...]:
    """Units of phi, and of E, row by row."""
    rows = tuple(unit for x in its.scene.model.loops for unit in x.kind.units)
    return (*rows, *units.over(rows, units.displacements(its.kinds)))


FUNCTION = SceneFunction(
    "closure", 205, "phi and E of the closed loops, row by row: phi = 0 where they are closed, "
    "phi' = E v; a point has three rows, a frame six, a hinge five, a rod one: distances in m, "
    "then twice the tangents of half the angles", "q",
    (Array("phi", (AxisLength.ROWS,), (), "closures"),
     Array("E", (AxisLength.ROWS, AxisLength.NV), (), "closures for a unit of each velocity")),
    lambda x: x.closures(), default=BY_DEFAULT, needs=LOOPS, units_in=_units)
