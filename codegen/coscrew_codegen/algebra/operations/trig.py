"""Sine and cosine of a joint angle."""

import sympy as sp

from coscrew_codegen.algebra.operations.elementary import ROUNDED, within
from coscrew_codegen.algebra.operations.family import Family
from coscrew_codegen.algebra.operations.operation import Operation
from coscrew_codegen.program.values.quantity import ANY, DC, SCALAR, Argument

_NAME = "trig"

_theta, _dc = Argument("theta", SCALAR, ANY), Argument("dc", DC)

OPERATIONS = (
    Operation(_NAME, "dc", "dc = (sin θ, cos θ), θ in rad",
              (_theta,), (_dc,), lambda theta: sp.Matrix([sp.sin(theta), sp.cos(theta)]),
              rounding=within("sincos"), accurate=ROUNDED),
)

FAMILY = Family(_NAME, 80, __doc__, OPERATIONS)
