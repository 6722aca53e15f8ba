"""Elementary functions, with the same bits on every machine."""

import sympy as sp

from coscrew_codegen.operations.family import Family
from coscrew_codegen.operations.operation import Operation
from coscrew_codegen.quantity import ANY, SCALAR, Argument

_NAME = "elementary"

_x, _y = (Argument(name, SCALAR, ANY) for name in "xy")
_s, _c, _angle = (Argument(name, SCALAR) for name in ("s", "c", "angle"))

OPERATIONS = (
    Operation(_NAME, "sincos", "s = sin x, c = cos x, x in rad", (_x,), (_s, _c),
              lambda x: (sp.sin(x), sp.cos(x))),
    Operation(_NAME, "sin", "s = sin x, x in rad", (_x,), (_s,), sp.sin),
    Operation(_NAME, "cos", "c = cos x, x in rad", (_x,), (_c,), sp.cos),
    Operation(_NAME, "exp", "y = e^x", (_x,), (Argument("y", SCALAR),), sp.exp),
    Operation(_NAME, "tanh", "y = tanh x", (_x,), (Argument("y", SCALAR),), sp.tanh),
    Operation(_NAME, "atan2", "angle of the vector (x, y) to the x axis, in rad, from -π to π",
              (_y, _x), (_angle,), sp.atan2),
)

FAMILY = Family(_NAME, 5, __doc__, OPERATIONS)
