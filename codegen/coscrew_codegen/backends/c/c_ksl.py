"""The functions of KSL that are not formulas: integers, sequences of axes, rows of matrices, loops.

C only.  Their text is in templates/c/ksl, one template per header, and is put at the end of that
header; they call kernels of the table of operations.
"""

import itertools
import re
import textwrap
from dataclasses import dataclass
from fractions import Fraction
from functools import partial

import mpmath

from coscrew_codegen.backends.c.c_statements import WIDTH, product
from coscrew_codegen.backends.c.c_storage import INTEGER, allocation, integers
from coscrew_codegen.backends.library import Library
from coscrew_codegen.backends.render import render
from coscrew_codegen.backends.target import Files, Target
from coscrew_codegen.program import Constant
from coscrew_codegen.program.values.formats import PRECISIONS, Precision
from coscrew_codegen.program.values.quantity import TOLERANCE

SEQUENCES = tuple((name, tuple("XYZ".index(axis) for axis in name)) for name in (
    "XYZ", "YZX", "ZXY", "XZY", "YXZ", "ZYX", "XYX", "XZX", "YXY", "YZY", "ZXZ", "ZYZ"))
"""Sequences of Euler angles, in the order of KSL's enumeration: name, axes."""

HEADERS = {"axis": ("vec3", "Axes, and sequences of axes of Euler angles."),
           "array": ("vec3", "Numbers in arrays: exchanged, added, compared, interpolated.")}
"""Headers that hold nothing else: name → (the family they come with, their title)."""

SYSTEM = {"mat3x3": ("stdarg.h",), "array": ("stddef.h",)}
"""Headers of the C library that they need, besides <stdbool.h>."""

@dataclass(frozen=True)
class RefusedName:
    """A header of KSL that is not here: its subject, its names (a{b,c} is ab and ac), the reason,
    and a remedy."""

    what: str
    names: tuple[str, ...]
    reason: str
    instead: str

    @property
    def all_names(self) -> tuple[str, ...]:
        """The names in full."""
        return tuple(name for pattern in self.names for name in _expanded(pattern))


def _expanded(pattern: str) -> tuple[str, ...]:
    """a{b,c}d → abd, acd; braces may follow each other."""
    parts = [part.split(",") for part in re.split("[{}]", pattern)]
    return tuple(map("".join, itertools.product(*parts)))


REFUSED = {
    "linalg": RefusedName(
        "Linear algebra on arrays",
        ("ksl_linalg_gramSchmidt{,f}",
         "ksl_linalg_{cholesky,ldlt}{,_backwardSubstitution,_forwardElimination,_solve}_{cmo,rmo}",
         "ksl_linalg_lu{,_full,_full_specified,_setBMatrix,_setCMatrix}_{cmo,rmo}",
         "ksl_linalg_lu_infinityNormB_rmo", "ksl_linalg_symmetricMatrixInverse_{cmo,rmo}"),
        "matrices here have fixed sizes; LAPACK solves any size, with pivots and error estimates",
        "for A x = b see ksl/symmetric.h and ksl_mat3x3_inverted in ksl/mat3x3.h, for Gram-Schmidt "
        "ksl_mat3x3_normalize, else use LAPACK"),
    "print": RefusedName(
        "Printing to streams",
        ("ksl_{SE3,mat3x3,mat4x4,vec3,vec4}{,f}_{debug,print,printWithOptions}",
         "ksl_{coscrew,quaternion,screw}{,f}_{debug,print,printWithOptions}",
         "ksl_{inertia,eulerangles,euleranglesf}_{debug,print,printWithOptions}",
         "ksl_{array,arrayi,array2D,triang,triangb,triangi}_{debug,print,printWithOptions}",
         "ksl_print_options", "ksl_print_setDefaultOptions",
         "ksl_print_set{Boolean,BreakBetweenLinesInMatrix,Delimiter}{,Option}",
         "ksl_print_set{InnerBrackets,OuterBrackets,RealFormat,RowColumnMajorPrinting}{,Option}"),
        "the headers compute, and run without an operating system and its streams",
        "print the members, as in printf(\\\"%g\\\", v.x)"),
    "memory": RefusedName(
        "Arrays of pointers",
        ("ksl_array2D{,b,c,f,i,ui}_{alloc,free}", "ksl_array{,b,c,f,i,ui}_free"),
        "one allocator for each type of C, of arrays of pointers to rows, which nothing here takes",
        "use calloc and free; for the system's memory.h include string.h"),
}
"""Headers that refuse to be included."""

MARK = "/* What KSL declares beside formulas. */"

NEEDED = {"vec3": (), "vec4": (), "trig": (), "SE3": (), "screw": (), "array": (),
          "axis": ("vec3",), "quaternion": (), "inertia": ("mat3x3",),
          "mat3x3": ("vec3", "axis")}  # header → headers with functions that it calls
MIXED = ("SE3",)
"""Headers whose functions turn one precision into the other, and so are there only with both."""
CLOSE = Fraction(1, 10**6)
"""Largest difference of numbers that KSL calls close, relative to the first, or to 1 if that is
more."""
NOISE = 128
"""In u: eigenvalues of moments below it, relative to the largest, count as zero."""

_PARTS = {"mat3x3": ("mat3x3", "euler")}  # header → its templates, if there are several


def text(header: str, headers: tuple[str, ...], precisions: tuple[Precision, ...]) -> str:
    """The functions of a header; empty if there are none, or if a header or a precision that they
    need is not generated."""
    if (header not in NEEDED or not set(NEEDED[header]) <= set(headers)
            or header in MIXED and len(precisions) < len(PRECISIONS)):
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
            "close": literal(CLOSE), "noise": literal(NOISE * precision.u),
            "times": partial(product, precision)}


def refusals(library: Library) -> Files:
    """The headers that refuse to be included."""
    return {f"c/include/ksl/{name}.h": render(
        "c/refused.h", banner=library.banner, what=refused.what, reason=refused.reason,
        names=textwrap.fill(", ".join(refused.all_names), WIDTH, initial_indent="   ",
                            subsequent_indent="   ", break_on_hyphens=False),
        sentence=f"ksl/{name}.h is not here: {refused.instead}")
            for name, refused in REFUSED.items() if "vec3" in library.families}


TARGET = Target("KSL's other headers", ("c",), library=refusals)
