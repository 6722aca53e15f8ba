"""The kinds of joints by their names, for models that are written in tests."""

from coscrew_codegen.scene.joints import kind_named


class Kind:
    """Kinds of joints that ship: Kind.REVOLUTE."""

    REVOLUTE, PRISMATIC, UNIVERSAL, PLANAR, SPHERICAL, FREE, FIXED = map(kind_named, (
        "revolute", "prismatic", "universal", "planar", "spherical", "free", "fixed"))
