"""The functions of scenes, one per module, or one family of them.

A module put here adds a function that scenes can select and record: in C, Python and CUDA, in every
precision and tier, in stubs and documentation.
"""

import re
from collections.abc import Collection, Iterator, Sequence

from coscrew_codegen.program.plugins import discover
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.scene.scene_function import Of, SceneFunction, SceneQuantity
from coscrew_codegen.scene.units import UNITS

FUNCTIONS: tuple[SceneFunction, ...] = tuple(sorted(
    discover(__name__, __path__, "FUNCTION", SceneFunction), key=lambda x: (x.place, x.name)))
"""The catalogue, in the order of `place`."""


def refuse_names(functions: Sequence[SceneFunction]) -> None:
    """Raise ValueError for a name that C and Python cannot use for each precision: f at its end
    means single precision."""
    names = {x.name for x in functions}
    for x in functions:
        if not _NAME.fullmatch(x.name):
            raise ValueError(f"a function of scenes is called {x.name!r}; wanted a name as "
                             "center_of_mass, or of a family as jacobian_BODY")
        if f"{x.name}f" in names:
            raise ValueError(f"functions of scenes are called {x.name!r} and '{x.name}f', which is "
                             f"{x.name} in single precision; rename one")


_NAME = re.compile(r"([a-z][a-z0-9]*|FUNCTION)(_([a-z0-9]+|[A-Z]+))*")
refuse_names(FUNCTIONS)


def quantities(functions: Sequence[SceneFunction]) -> dict[str,
                                                           tuple[SceneFunction, SceneQuantity]]:
    """Recorded quantities of functions, by name: of the scene, of bodies, of joints.  Raises
    ValueError for two of one name."""
    known: dict[str, tuple[SceneFunction, SceneQuantity]] = {}
    for function in functions:
        for quantity in function.recorded:
            if quantity.name in known or quantity.name in UNITS:
                other = known[quantity.name][0].name if quantity.name in known else "the state"
                raise ValueError(f"{quantity.name!r} is recorded of {other} and of "
                                 f"{function.name}; rename one")
            known[quantity.name] = function, quantity
    return dict(sorted(known.items(), key=lambda x: (_ORDER.index(x[1][1].of), x[0])))


_ORDER = tuple(Of)
QUANTITIES = quantities(FUNCTIONS)


def functions_of(scene: Scene, names: Collection[str] = ()) -> Iterator[SceneFunction]:
    """All functions that a scene may have, internal ones among them, in the order in which they are
    emitted; derivatives of functions only if these names need them."""
    own = sorted((x for function in FUNCTIONS if not function.each for x in function.of(scene)),
                 key=lambda x: x.place)
    yield from own
    if not {x.name for x in own}.issuperset(names):
        yield from _derivatives(scene, own)


def derivatives_of(scene: Scene) -> Iterator[SceneFunction]:
    """The derivatives of functions that a scene may have."""
    yield from _derivatives(scene, list(functions_of(scene)))


def _derivatives(scene: Scene, own: Sequence[SceneFunction]) -> Iterator[SceneFunction]:
    for family in FUNCTIONS:
        if family.each:
            yield from filter(None, (family.each(family, x, scene) for x in own))
