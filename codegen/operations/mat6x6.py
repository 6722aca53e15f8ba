"""6×6 operators on screws and coscrews, as [Ad], [Ad]*, [ad] and [ad]* return them."""

import sympy as sp

from coscrew_codegen.operations.operation import Operation
from coscrew_codegen.quantity import (
    ANY,
    MAT6X6,
    Argument,
)

FAMILY = "mat6x6"

_M, _self, _Mo = (Argument(name, MAT6X6, ANY) for name in ("M", "self", "Mo"))

OPERATIONS = (
    Operation("mat6x6_copy", FAMILY, "Mo = M", (_M,), (_Mo,), lambda M: M),
    Operation("mat6x6_setIdentity", FAMILY, "self = I", (_self,), (_self,), lambda M: sp.eye(6)),
    Operation("mat6x6_transposed", FAMILY, "Mo = M^T", (_M,), (_Mo,), lambda M: M.T),
)
