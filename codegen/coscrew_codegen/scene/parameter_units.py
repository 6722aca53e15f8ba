"""The units of run-time parameters."""

from collections.abc import Iterator, Mapping

from coscrew_codegen.program.values.parameter import Parameter
from coscrew_codegen.scene.effect_quantities import acted_units
from coscrew_codegen.scene.mechanism.joint_kind import JointKind
from coscrew_codegen.scene.mechanism.model import Body
from coscrew_codegen.scene.scene import Applied, Scene


def parameter_units(scene: Scene) -> Mapping[str, str]:
    """The unit of each number that the scene lists in `runtime`, by name."""
    kinds = {x.name: x.kind for x in scene.model.joints}
    numbers = [x for body in scene.model.bodies for x in _of_body(body)]
    numbers += [x for applied in scene.effects
                for x in _of_effect(applied, kinds)]
    return {x.name: unit for x, unit in numbers if isinstance(x, Parameter)}


def _of_body(body: Body) -> Iterator[tuple[object, str]]:
    if body.inertia:
        yield body.inertia.mass, "kg"
        yield from ((x, "m") for x in body.inertia.com)
        yield from ((x, "kg m^2") for x in body.inertia.moments)


def _of_effect(applied: Applied, kinds: Mapping[str, JointKind]) -> Iterator[tuple[object, str]]:
    acted = acted_units(applied, kinds)
    for x in applied.effect.parameters:
        turning, _, sliding = x.unit.replace(",", "").partition(" or ")  # N m or N; 1, or rad/m
        unit = x.unit if len(acted) > 1 else sliding if "N" in acted and sliding else turning
        value = applied.values[x.name]
        rest = kinds[applied.on].units("q") if x.name == applied.effect.rest and \
            isinstance(value, tuple) else ()
        for k, number in enumerate(value if isinstance(value, tuple) else (value,)):
            yield number, rest[k] if rest else unit
