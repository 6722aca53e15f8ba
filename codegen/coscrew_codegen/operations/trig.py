"""Sine and cosine of a joint angle."""

import sympy as sp

from coscrew_codegen.operations.elementary import ROUNDED, within
from coscrew_codegen.operations.family import Family
from coscrew_codegen.operations.operation import Operation
from coscrew_codegen.quantity import (
    ANY,
    DC,
    SCALAR,
    Argument,
)

_NAME = "trig"

_theta, _dc = Argument("theta", SCALAR, ANY), Argument("dc", DC)

OPERATIONS = (
    Operation(_NAME, "dc", "dc = (sin θ, cos θ), θ in rad",
              (_theta,), (_dc,), lambda theta: sp.Matrix([sp.sin(theta), sp.cos(theta)]),
              rounding=within("sincos"), accurate=ROUNDED),
)

FAMILY = Family(_NAME, 80, __doc__, OPERATIONS)
