"""Elementary functions, with the same bits on every machine."""

from functools import partial

import sympy as sp

from coscrew_codegen.algebra.operations.family import Family
from coscrew_codegen.algebra.operations.operation import Operation
from coscrew_codegen.program.elementary import ELEMENTARY as FUNCTIONS
from coscrew_codegen.program.values.formats import PRECISIONS
from coscrew_codegen.program.values.quantity import ANY, SCALAR, Argument

_NAME = "elementary"
_FUNCTIONS = {function.name: function for function in FUNCTIONS}

_x, _y = (Argument(name, SCALAR, ANY) for name in "xy")
_s, _c, _angle = (Argument(name, SCALAR) for name in ("s", "c", "angle"))

ROUNDED = "Error <= 0.501 ulp, unless a result is subnormal; proved."
"""Bound of the accurate tier: half an ulp, plus the error of the function's error."""


def within(name: str) -> str:
    """The bounds of an elementary function's error."""
    double, single = (float(_FUNCTIONS[name].error(p)) for p in PRECISIONS)
    return (f"Error <= {double:g} ulp, in single precision {single:g} ulp, unless a result is "
            "subnormal; proved.")


_op = partial(Operation, _NAME, accurate=ROUNDED)

OPERATIONS = (
    _op("sincos", "s = sin x, c = cos x, x in rad", (_x,), (_s, _c),
        lambda x: (sp.sin(x), sp.cos(x)), rounding=within("sincos")),
    _op("sin", "s = sin x, x in rad", (_x,), (_s,), sp.sin, rounding=within("sincos")),
    _op("cos", "c = cos x, x in rad", (_x,), (_c,), sp.cos, rounding=within("sincos")),
    _op("exp", "y = e^x", (_x,), (Argument("y", SCALAR),), sp.exp, rounding=within("exp")),
    _op("tanh", "y = tanh x", (_x,), (Argument("y", SCALAR),), sp.tanh, rounding=within("tanh")),
    _op("atan2", "angle of the vector (x, y) to the x axis, in rad, from -π to π", (_y, _x),
        (_angle,), sp.atan2, rounding=within("atan2")),
)

FAMILY = Family(_NAME, 5, __doc__, OPERATIONS)
