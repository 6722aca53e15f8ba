"""The functions of scenes, one per module, or one family of them.

A module put here adds a function that scenes can select and record: in C, Python and CUDA, in every
precision and tier, in stubs and documentation.
"""

from collections.abc import Iterator

from coscrew_codegen.found import found
from coscrew_codegen.scene.function import Of, Quantity, SceneFunction
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.scene.units import UNITS

FUNCTIONS: tuple[SceneFunction, ...] = tuple(sorted(
    found(__name__, __path__, "FUNCTION", SceneFunction), key=lambda x: (x.place, x.name)))
"""The catalogue, in the order of `place`."""


def _quantities() -> dict[str, tuple[SceneFunction, Quantity]]:
    found: dict[str, tuple[SceneFunction, Quantity]] = {}
    for function in FUNCTIONS:
        for quantity in function.recorded:
            if quantity.name in found or quantity.name in UNITS:
                raise ValueError(f"{function.name}: another function records {quantity.name!r}")
            found[quantity.name] = function, quantity
    return dict(sorted(found.items(), key=lambda x: (_ORDER.index(x[1][1].of), x[0])))


_ORDER = tuple(Of)
QUANTITIES = _quantities()
"""What is recorded of functions, by name: of the scene, of bodies, of joints."""


def functions_of(scene: Scene) -> Iterator[SceneFunction]:
    """All functions that a scene may have, internal ones among them, in the order in which they are
    emitted."""
    yield from sorted((x for function in FUNCTIONS for x in function.of(scene)),
                      key=lambda x: x.place)
