"""Parts of a picture that are hidden at first: the shapes with which bodies may touch others.

The world's are not drawn, and planes are the ground of every picture."""

from coscrew_codegen.scene.mechanism.collision import PLANE, Collision
from coscrew_codegen.scene.mechanism.model import Model
from coscrew_codegen.scene.mechanism.visual import MESH, Visual, from_rotation
from coscrew_codegen.simulation.view.body_shapes import (
    UNPAINTED,
    DrawnPart,
    RobotDrawing,
    readable,
)
from coscrew_codegen.simulation.view.mesh_files import TOUCHING, identity, meshes


def add_collisions(drawing: RobotDrawing, model: Model) -> None:
    """Add the collision shapes of the bodies; meshes that visuals have, too, are the same."""
    numbers = {body.name: n for n, body in enumerate(model.bodies)}
    own = [(x, _as_visual(x)) for x in model.collisions if x.body in numbers and x.shape != PLANE]
    kept = [(x, visual) for x, visual in own if not x.problem]
    wanted = {identity(x): x for _, x in kept if readable(x)}
    further = {name: x for name, x in wanted.items() if name not in drawing.pieces}
    pieces = {**drawing.pieces, **dict(zip(further, meshes([*further.values()], TOUCHING),
                                           strict=True))} if further else drawing.pieces
    drawing.notes += [f"{x.body}: a collision shape: {x.problem}" for x, _ in own if x.problem]
    for shape, visual in kept:
        body, place = numbers[shape.body], visual.place
        if visual.shape != MESH:
            drawing.touching.append(DrawnPart(body, visual.shape, visual.size, place, UNPAINTED))
        elif not readable(visual):
            continue  # as the command says of all meshes
        elif isinstance(result := pieces[identity(visual)], str):
            drawing.notes.append(f"{shape.body}: a collision shape: {visual.mesh}: {result}")
        else:
            drawing.touching += [DrawnPart(body, MESH, (), place, UNPAINTED, x) for x in result]


def _as_visual(x: Collision) -> Visual:
    """The shape as one that is seen."""
    place = (*map(float, x.t), *from_rotation([*map(float, x.R)]))
    return Visual(x.shape, tuple(map(float, x.size)), place, mesh=x.mesh,
                  scale=tuple(map(float, x.scale)))
