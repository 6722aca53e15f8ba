"""The functions of KSL that are not formulas: integers, sequences of axes, rows of matrices, loops.

C only.  Their text is in templates/c/ksl, one template per header, and is put at the end of that
header; they call kernels of the table of operations.
"""

from fractions import Fraction
from functools import partial

import mpmath

from coscrew_codegen.formats import Precision
from coscrew_codegen.library import Library
from coscrew_codegen.program import Constant
from coscrew_codegen.quantity import TOLERANCE
from coscrew_codegen.render import render
from coscrew_codegen.targets.c_statements import product
from coscrew_codegen.targets.c_storage import INTEGER, allocation, integers
from coscrew_codegen.targets.target import Files, Target

SEQUENCES = tuple((name, tuple("XYZ".index(axis) for axis in name)) for name in (
    "XYZ", "YZX", "ZXY", "XZY", "YXZ", "ZYX", "XYX", "XZX", "YXY", "YZY", "ZXZ", "ZYZ"))
"""Sequences of Euler angles, in the order of KSL's enumeration: name, axes."""

HEADERS = {"axis": ("vec3", "Axes, and sequences of axes of Euler angles."),
           "array": ("vec3", "Numbers in arrays: exchanged, and added in multiples.")}
"""Headers that hold nothing else: name → (the family they come with, their title)."""

SYSTEM = {"vec3": ("stdbool.h",), "mat3x3": ("stdarg.h",), "array": ("stddef.h",)}
"""Headers of the C library that they need."""

REFUSED = {
    "linalg": ("Linear algebra on arrays",
               "ksl/linalg.h is not here: for A x = b see ksl/symmetric.h and ksl_mat3x3_inverted "
               "in ksl/mat3x3.h, else use LAPACK"),
    "print": ("Printing to streams",
              "ksl/print.h is not here: print the members, as in printf(\\\"%g\\\", v.x)"),
    "memory": ("Arrays of pointers",
               "ksl/memory.h is not here: use calloc and free; for the system's memory.h include "
               "string.h"),
}
"""Headers that refuse to be included: name → (what KSL has there, what to do instead)."""

MARK = "/* What KSL declares beside formulas. */"

NEEDED = {"vec3": (), "vec4": (), "trig": (), "screw": (), "array": (), "axis": ("vec3",),
          "quaternion": (), "inertia": ("mat3x3",),
          "mat3x3": ("vec3", "axis")}  # header → headers with functions that it calls
NOISE = 128
"""In u: eigenvalues of moments below it, relative to the largest, count as zero."""

_PARTS = {"mat3x3": ("mat3x3", "euler")}  # header → its templates, if there are several


def text(header: str, headers: tuple[str, ...], precisions: tuple[Precision, ...]) -> str:
    """The functions of a header; empty if there are none, or if a header that they need is not
    generated."""
    if header not in NEEDED or not set(NEEDED[header]) <= set(headers):
        return ""
    made = integers(header)
    return f"\n{MARK}\n" + "".join(render(
        f"c/ksl/{part}.h", made=made, allocated=allocation(header, INTEGER) if made else None,
        sequences=SEQUENCES, numbers=(*precisions, INTEGER),
        precisions=[_holes(precision) for precision in precisions])
        for part in _PARTS.get(header, (header,)))


def _holes(precision: Precision) -> dict[str, object]:
    with mpmath.workdps(60):
        pi = Fraction(*mpmath.libmp.to_rational((+mpmath.pi)._mpf_))

    def literal(number: Fraction | int) -> str:
        return precision.literal(Constant(*(Fraction(number),) * 2)) + precision.suffix

    return {"suffix": precision.suffix, "c_type": precision.c_type, "one": literal(1),
            "few": literal(16 * precision.u), "tolerance": f"{float(TOLERANCE)}{precision.suffix}",
            "eighth": literal(pi / 4), "half": literal(pi), "whole": literal(2 * pi),
            "turns": (("Degrees", literal(360), "360"), ("Radians", literal(2 * pi), "2 π")),
            "noise": literal(NOISE * precision.u), "times": partial(product, precision)}


def refusals(library: Library) -> Files:
    """The headers that refuse to be included."""
    return {f"c/include/ksl/{name}.h": render("c/refused.h", banner=library.banner, what=what,
                                              sentence=sentence)
            for name, (what, sentence) in REFUSED.items() if "vec3" in library.families}


TARGET = Target("KSL's other headers", ("c",), library=refusals)
