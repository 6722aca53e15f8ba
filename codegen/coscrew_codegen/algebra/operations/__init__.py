"""The table of operations, one file per family; everything generated is made from it."""

from coscrew_codegen.algebra.operations.family import Family
from coscrew_codegen.algebra.operations.operation import (
    NORM_THRESHOLD,
    PER_PRECISION,
    Operation,
    components,
    scaled,
    truncated,
)
from coscrew_codegen.program.plugins import discover

_TABLE = {family.name: family for family in sorted(
    discover(__name__, __path__, "FAMILY", Family), key=lambda family: family.order)}

FAMILIES: tuple[str, ...] = tuple(_TABLE)
OPERATIONS: tuple[Operation, ...] = tuple(op for family in _TABLE.values()
                                          for op in family.operations)

_names = [op.name for op in OPERATIONS]
if len(set(_names)) < len(_names):
    raise ValueError("operations named twice: "
                     f"{sorted({n for n in _names if _names.count(n) > 1})}")


def family_named(name: str) -> Family:
    """The family of this name; a KeyError if there is none."""
    return _TABLE[name]


def contributors(name: str) -> tuple[str, ...]:
    """The families whose files hold operations of this one: itself, and others at times."""
    return tuple(family.name for family in _TABLE.values()
                 if any(op.family == name for op in family.operations))


__all__ = ["FAMILIES", "NORM_THRESHOLD", "OPERATIONS", "PER_PRECISION", "Family", "Operation",
           "components", "contributors", "family_named", "scaled",
           "truncated"]
