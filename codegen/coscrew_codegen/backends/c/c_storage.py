"""The C functions that only move numbers: constructors, allocation, element access.

They exist only in C: Python has arrays.
"""

from fractions import Fraction
from itertools import count
from math import isqrt

import numpy as np

from coscrew_codegen.backends.c.c_function import CFunction
from coscrew_codegen.backends.c.c_operations import member, type_name
from coscrew_codegen.backends.c.c_statements import WIDTH, comment_of, listed
from coscrew_codegen.program import Constant
from coscrew_codegen.program.values.formats import Precision
from coscrew_codegen.program.values.quantity import (
    COSCREW,
    INERTIA,
    MAT3X3,
    MAT4X4,
    MAT6X6,
    QUATERNION,
    SCREW,
    SE3,
    SPATIAL_INERTIA,
    VEC3,
    VEC4,
    Quantity,
)

_FIELDS = {
    "vec3": (("{real} at[3];",), ("{real} x, y, z;",)),
    "vec4": (("{real} at[4];",), ("{real} x, y, z, w;",), ("ksl_vec3{f}_t r;",)),
    "mat3x3": (("{real} as_array[9];",), ("{real} at[3][3];",),
               ("{real} m00, m10, m20;", "{real} m01, m11, m21;", "{real} m02, m12, m22;"),
               ("ksl_vec3{f}_t v0, v1, v2;",), ("ksl_vec3{f}_t v[3];",)),
    "mat4x4": (("{real} as_array[16];",), ("{real} at[4][4];",),
               tuple("{real} " + ", ".join(f"m{row}{column}" for row in range(4)) + ";"
                     for column in range(4)),
               ("ksl_vec4{f}_t v0, v1, v2, v3;",), ("ksl_vec4{f}_t v[4];",)),
    "SE3": (("{real} as_array[12];",), ("{real} at[4][3];",),
            ("ksl_mat3x3{f}_t R;", "ksl_vec3{f}_t t;"),
            ("{real} m00, m10, m20;", "{real} m01, m11, m21;", "{real} m02, m12, m22;",
             "{real} m03, m13, m23;"),
            ("ksl_vec3{f}_t v0, v1, v2, v3;",), ("ksl_vec3{f}_t v[4];",)),
    "screw": (("{real} at[6];",), ("ksl_vec3{f}_t lin, ang;",),
              ("{real} m0, m1, m2, m3, m4, m5;",)),
    "coscrew": (("{real} at[6];",), ("ksl_vec3{f}_t lin, ang;",),
                ("{real} m0, m1, m2, m3, m4, m5;",)),
    "mat6x6": (("{real} as_array[36];",), ("{real} at[6][6];",)),
    "quaternion": (("{real} at[4];",), ("{real} x, y, z, w;",), ("ksl_vec3{f}_t r;",)),
    "inertia": (("{real} at[10];",),
                ("{real} m;", "ksl_vec3{f}_t mt;", "{real} Ixx, Iyy, Izz, Ixy, Iyz, Izx;"),
                ("{real} mass;", "ksl_vec3{f}_t mr;", "{real} diagonal[3];",
                 "{real} Iyx, Izy, Ixz;")),
    "spatial_inertia": (("{real} at[10];",), (
        "{real} m;", "ksl_vec3{f}_t h;", "{real} xx, yy, zz, xy, xz, yz;")),
}

_MEANING = {
    "vec3": "vector (x, y, z)",
    "vec4": "vector (x, y, z, w), r = (x, y, z), w a homogeneous coordinate",
    "mat3x3": "3×3 matrix, stored column by column: m21 is row 2, column 1, also at[1][2]",
    "mat4x4": "4×4 matrix, stored column by column: m32 is row 3, column 2, also at[2][3]",
    "SE3": "displacement [R | t], stored column by column: m13 is t.y, also at[3][1]",
    "screw": "screw (lin; ang) = (v; ω)",
    "coscrew": "coscrew (lin; ang) = (f; τ)",
    "mat6x6": "6×6 operator, stored column by column: at[column][row]",
    "quaternion": "quaternion (x, y, z, w), r = (x, y, z); for rotations, of norm 1",
    "inertia": "inertia: mass m, first moment mt = m c, moments about the centre of mass c",
    "spatial_inertia": "spatial inertia: mass m, first moment h = m c, moments about the origin",
}

_IDENTITIES = {"mat3x3": ("m00", "m11", "m22"), "mat4x4": ("m00", "m11", "m22", "m33"),
               "SE3": ("m00", "m11", "m22"), "quaternion": ("w",)}
"""The types that are allocated as identities, and the members that are then 1."""

TYPES = (VEC3, VEC4, MAT3X3, MAT4X4, SE3, SCREW, COSCREW, MAT6X6, QUATERNION, INERTIA,
         SPATIAL_INERTIA)
"""The struct types, each after those that it contains."""

INTEGER = Precision(31, 0, "integer", "int", "i", "int32", 4)
INTEGRAL = (VEC3, VEC4)
"""The types that also exist with integer members: ksl_vec3i_t."""


def views(quantity: Quantity, precision: Precision) -> list[list[str]]:
    """The anonymous structs of the type's union, as member declarations."""
    return [[line.format(real=precision.c_type, f=precision.suffix) for line in view]
            for view in _FIELDS[quantity.name]]


def meaning(quantity: Quantity) -> str:
    """Describes the type for the comment above it."""
    return _MEANING[quantity.name]


def selfcheck_numbers(precision: Precision) -> dict[str, str]:
    """The numbers that ksl_selfcheck reads at run time, so that no compiler can fold them."""
    digits, exponent = precision.digits, -precision.least_exponent
    near_one = 1 + Fraction(1, 2**((digits + 1) // 2))
    odd = (Fraction(n) for n in count(3, 2))
    numbers = {
        "zero": Fraction(0), "half": Fraction(1, 2), "one": Fraction(1), "two": Fraction(2),
        "x": near_one, "nearly_square": 2 * near_one - 1,
        "smallest": Fraction(1, 2**exponent),
        "largest": (2 - Fraction(1, 2**(digits - 1))) * 2**(exponent + 1),
        "above_half_ulp": Fraction(1, 2**digits) + Fraction(1, 2**(digits + digits // 2 - 1)),
        "root": Fraction(isqrt(2 * 4**(3 * digits)), 2**(3 * digits)),  # of 2, for every purpose
        # n / n is 1, but n (1 / n), rounded, is not
        "n": next(n for n in odd if _rounded(n * _rounded(1 / n, precision), precision) != 1),
        **dict(zip(("m", "rounded_twice"), _cube(precision, digits), strict=True)),
    }
    literals = [precision.literal(Constant(n, n)) + precision.suffix for n in numbers.values()]
    reads = [f"{name} = given[{i}]" for i, name in enumerate(numbers)]
    given = listed(f"const volatile {precision.c_type} given[] = {{", literals, "};", WIDTH - 2)
    read = listed(f"const {precision.c_type} ", reads, ";", WIDTH - 2)
    return {"real": precision.c_type, "f": precision.suffix, "F": precision.suffix.upper(),
            "given": given.replace("\n", "\n  "), "read": read.replace("\n", "\n  ")}


def _rounded(value: Fraction, precision: Precision) -> Fraction:
    return Fraction(float(precision.rounded(value)))


def _cube(precision: Precision, digits: int) -> tuple[Fraction, Fraction]:
    """(x, its cube rounded twice), for an x for which that has an error of more than 0.7 ulp."""
    for m in map(Fraction, count(2**((digits + 1) // 2))):
        cube = _rounded(_rounded(m * m, precision) * m, precision)
        ulp = Fraction(float(np.spacing(precision.rounded(cube))))
        if abs(cube - m**3) > Fraction(7, 10) * ulp:
            return m, cube
    raise AssertionError("numbers do not end")


def storage_functions(family: str, precision: Precision) -> tuple[CFunction, ...]:
    """Constructors, alloc, get and set of the type that a family is named after, if there is one.
    """
    quantity = next((q for q in TYPES if q.name == family), None)
    if quantity is None:
        return ()
    stem = f"ksl_{family}{precision.suffix}"
    functions = [] if quantity in (MAT6X6, INERTIA) else [_constructor(quantity, precision, stem)]
    if quantity in (MAT3X3, MAT4X4, SE3):
        functions.append(_constructor(quantity, precision, f"{stem}_cmo", by_columns=True))
    if quantity is SE3:
        functions.append(_identity(precision, stem))
    if quantity in (MAT3X3, MAT4X4, SE3, MAT6X6):
        functions += _element_access(quantity, precision, stem)
    return tuple(functions)


def integers(family: str) -> tuple[CFunction, ...]:
    """The integer constructor of the type that a family is named after, if there is one."""
    quantity = next((q for q in INTEGRAL if q.name == family), None)
    return (_constructor(quantity, INTEGER, f"ksl_{family}i"),) if quantity else ()


def allocation(family: str, precision: Precision) -> CFunction | None:
    """The family's _alloc function, the only one that needs <stdlib.h>."""
    if family not in _FIELDS:
        return None
    kind = f"ksl_{family}{precision.suffix}"
    zeroed = f"n > 0 ? ({kind}_t *)calloc((size_t)n, sizeof({kind}_t)) : NULL;"
    body, holding = f"  return {zeroed}", "zeros"
    if family in _IDENTITIES:
        ones = " = ".join(f"all[i].{name}" for name in _IDENTITIES[family])
        body, holding = "\n".join((
            f"  {kind}_t *const all =\n      {zeroed}", "  for (int i = 0; all && i < n; i++) {",
            f"    {ones} = 1.0{precision.suffix};", "  }", "  return all;")), "identities"
    return CFunction(
        f"{kind}_alloc",
        comment_of([f"n {kind}_t on the heap, {holding}, to be freed by the caller; NULL for "
                    "n <= 0 or when there is no memory."]),
        f"{kind}_t *{kind}_alloc(int n)", body)


def _constructor(quantity: Quantity, precision: Precision, name: str,
                 by_columns: bool = False) -> CFunction:
    kind, order = type_name(quantity.name, precision), list(range(quantity.size))
    if by_columns:
        order.sort(key=lambda i: quantity.indices[i][::-1])
    fields = [member(quantity, i).lstrip(".") for i in order]
    names = [field.replace(".", "") for field in fields]
    declared = [f"const {precision.c_type} {name}" for name in names]
    words = "column by column" if by_columns else "row by row" if quantity.shape[1:] else "in order"
    stores = [f"  value.{field} = {name};" for field, name in zip(fields, names, strict=True)]
    body = [f"  {kind} value;", *stores, "  return value;"]
    return CFunction(name, comment_of([f"The {quantity.name} of these entries, {words}."]),
                     listed(f"{kind} {name}(", declared, ")", WIDTH - 16), "\n".join(body))


def _identity(precision: Precision, stem: str) -> CFunction:
    entries = (f"{float(i == j)}{precision.suffix}" for i, j in SE3.indices)
    return CFunction(f"{stem}_identity", comment_of(["The displacement [I | 0]."]),
                     f"{stem}_t {stem}_identity(void)", f"  return {stem}({', '.join(entries)});")


def _element_access(quantity: Quantity, precision: Precision,
                    stem: str) -> tuple[CFunction, CFunction]:
    rows, columns = quantity.shape
    inside = f"row >= 0 && row < {rows} && column >= 0 && column < {columns}"
    real, kind, name = precision.c_type, f"{stem}_t", quantity.name[0].upper()
    name = "D" if quantity is SE3 else "R" if quantity is MAT3X3 else name
    where = f"for 0 <= row < {rows} and 0 <= column < {columns}"
    return (
        CFunction(f"{stem}_get",
                  comment_of([f"The entry of {name} at (row, column), {where}; NaN outside."]),
                  f"{real} {stem}_get(const {kind} *{name}, const int row, const int column)",
                  f"  return {inside} ? {name}->at[column][row] : ({real})NAN;"),
        CFunction(f"{stem}_set",
                  comment_of([f"Sets the entry of {name} at (row, column), {where}; does nothing "
                              "outside."]),
                  f"void {stem}_set({kind} *{name}, const int row, const int column,\n"
                  f"    const {real} value)",
                  f"  if ({inside}) {{\n    {name}->at[column][row] = value;\n  }}"),
    )
