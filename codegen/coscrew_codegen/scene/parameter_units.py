"""The units of run-time parameters."""

from collections.abc import Iterator, Mapping

from coscrew_codegen.program.values.parameter import Parameter
from coscrew_codegen.scene.mechanism.model import Body
from coscrew_codegen.scene.scene import Applied, Scene


def parameter_units(scene: Scene) -> Mapping[str, str]:
    """The unit of each number that the scene lists in `runtime`, by name."""
    sliding = {x.name for x in scene.model.joints if x.kind.slides}
    numbers = [x for body in scene.model.bodies for x in _of_body(body)]
    numbers += [x for applied in scene.effects
                for x in _of_effect(applied, applied.on in sliding)]
    return {x.name: unit for x, unit in numbers if isinstance(x, Parameter)}


def _of_body(body: Body) -> Iterator[tuple[object, str]]:
    if body.inertia:
        yield body.inertia.mass, "kg"
        yield from ((x, "m") for x in body.inertia.com)
        yield from ((x, "kg m^2") for x in body.inertia.moments)


def _of_effect(applied: Applied, slides: bool) -> Iterator[tuple[object, str]]:
    for x in applied.effect.parameters:
        turning, _, sliding = x.unit.replace(",", "").partition(" or ")  # N m or N; 1, or rad/m
        value = applied.values[x.name]
        for number in value if isinstance(value, tuple) else (value,):
            yield number, sliding if slides and sliding else turning
