"""The kinds of joints, one per module.

A module put here adds a kind that scenes and URDF files can use: in every function, language,
precision and tier, in runs, checks and documents.
"""

import copyreg

from coscrew_codegen.program.plugins import discover
from coscrew_codegen.scene.mechanism.joint_kind import JointKind

KINDS: tuple[JointKind, ...] = tuple(sorted(
    discover(__name__, __path__, "JOINT", JointKind), key=lambda x: (x.place, x.name)))
"""The catalogue, in the order of `place`."""

KIND_NAMED = {kind.name: kind for kind in KINDS}


def kind_named(name: str) -> JointKind:
    """The kind of this name.  Raises KeyError if there is none."""
    return KIND_NAMED[name]


def called(kinds: tuple[JointKind, ...], between: str = "and") -> str:
    """The names of kinds in one phrase: revolute and prismatic."""
    *first, last = (kind.name for kind in kinds)
    return f"{', '.join(first)} {between} {last}" if first else last


ONE_COORDINATE = tuple(kind for kind in KINDS if kind.one_coordinate)
"""The kinds on whose joints effects act, and which have limits."""


def _pickled(kind: JointKind) -> str | tuple[object, ...]:
    """A kind of the catalogue is pickled by its name, since its functions cannot be."""
    if any(known is kind for known in KINDS):
        return kind_named, (kind.name,)
    return object.__reduce_ex__(kind, 2)


copyreg.pickle(JointKind, _pickled)  # type: ignore[arg-type]  # object's own reductions are any tuple
