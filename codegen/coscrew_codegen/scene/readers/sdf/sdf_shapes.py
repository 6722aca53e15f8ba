"""Shapes of SDF's links: sizes, colours, friction."""

from collections.abc import Callable
from fractions import Fraction

from coscrew_codegen.scene.mechanism.collision import PLANE, Friction
from coscrew_codegen.scene.mechanism.model import Placement
from coscrew_codegen.scene.readers.model_reader import ModelSource
from coscrew_codegen.scene.readers.xml_files.xml import Element
from coscrew_codegen.scene.readers.xml_files.xml_shapes import SIZES, Shapes, colour, numbers

_ONE = (Fraction(1),)


def shapes_of(source: ModelSource, pose: Callable[[Element], Placement]) -> Shapes:
    """Reads the shapes of a file whose texts stand among the attributes."""
    return Shapes(source, {**SIZES, "ellipsoid": ("radii",), PLANE: ()}, "uri", pose, _colour,
                  _friction)


def _colour(visual: Element) -> tuple[float, ...]:
    return next((colour(x, "diffuse", "ambient") for x in visual.all("material")), ())


def _friction(collision: Element) -> Friction | None:
    """The coefficients that ODE and others take, mu and mu2.  Raises ValueError."""
    for surface in collision.all("surface"):
        for friction in surface.all("friction"):
            for of in friction.all("ode"):
                return Friction(*numbers(of, "mu", 1, _ONE), *numbers(of, "mu2", 1, _ONE))
    return None
