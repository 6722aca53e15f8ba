"""Jacobians of bodies."""

from coscrew_codegen.scene import units
from coscrew_codegen.scene.identifiers import identifiers
from coscrew_codegen.scene.mechanism.model import WORLD
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.scene.scene_function import Array, AxisLength, Depends, Frame, SceneFunction


def moving(scene: Scene) -> dict[str, str]:
    """The bodies that can move."""
    bodies, links = [body.name for body in scene.model.bodies], scene.model.links()
    return {stem: body for stem, body in zip(identifiers(bodies), bodies, strict=True)
            if links[body] != WORLD}


FUNCTION = SceneFunction(
    "jacobian_BODY", 110, "J with J v = (v; w) of BODY in the frame of the body, at its origin",
    "q", (Array("J", (6, AxisLength.NV), units.jacobian, "screws of the velocities"),),
    lambda x: [x.jacobian(x.target, Frame.BODY)], Depends.GEOMETRY, targets=moving)
