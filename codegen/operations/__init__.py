"""The table of operations, family by family; everything generated is made from it."""

from coscrew_codegen.operations import (
    SE3,
    coscrew,
    exponential,
    inertia,
    mat3x3,
    mat4x4,
    mat6x6,
    matrix,
    quaternion,
    screw,
    spatial_inertia,
    symmetric,
    trig,
    vec3,
    vec4,
)
from coscrew_codegen.operations.operation import (
    NORM_THRESHOLD,
    PER_PRECISION,
    Operation,
    components,
    scaled,
)

_MODULES = (vec3, vec4, mat3x3, SE3, mat4x4, mat6x6, matrix, trig, screw, coscrew, quaternion,
            exponential, symmetric, inertia, spatial_inertia)

FAMILIES: tuple[str, ...] = tuple(module.FAMILY for module in _MODULES)
OPERATIONS: tuple[Operation, ...] = tuple(op for module in _MODULES for op in module.OPERATIONS)

_names = [op.name for op in OPERATIONS]
if len(set(_names)) < len(_names):
    raise ValueError("operations named twice: "
                     f"{sorted({n for n in _names if _names.count(n) > 1})}")


def family_title(family: str) -> str:
    """The first line of the family's documentation."""
    module = next(module for module in _MODULES if family == module.FAMILY)
    return str(module.__doc__).splitlines()[0]


__all__ = ["FAMILIES", "NORM_THRESHOLD", "OPERATIONS", "PER_PRECISION", "Operation", "components",
           "family_title", "scaled"]
