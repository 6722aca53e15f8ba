"""The parts of a step that resolve contacts of limits."""

from coscrew_codegen.scene.functions.steps.closing_contacts import BY_DEFAULT
from coscrew_codegen.scene.scene_function import COUNT, Array, SceneFunction
from coscrew_codegen.scene.situation import LIMITS

MOST = 1024
"""Largest number of parts of a step."""
MOST_OF_CONTACTS = 64
"""Largest number for contacts of bodies: where more would be needed, bounces lose speed, but the
implicit step stays stable."""

FUNCTION = SceneFunction(
    "parts", 200, "count, part = h/count: the number and length of the parts in which a step of h "
    "is taken, to resolve contacts of limits; part is NaN if count would exceed "
    f"{MOST}", "h q v", (COUNT, Array("part", (), ("s",), "in s")),
    lambda x: [[y] for y in x.split()], default=BY_DEFAULT, divides=True, needs=LIMITS)
