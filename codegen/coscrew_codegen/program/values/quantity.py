"""The quantities operations act on: shape, named parts, units.

A quantity knows how its components are addressed mathematically; how a language stores them is the
targets' business.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from math import prod
from typing import TYPE_CHECKING

if TYPE_CHECKING:  # imported on first use: modules that need only shapes start without SymPy
    import sympy as sp


@dataclass(frozen=True)
class Domain:
    """The set of values an input may take; `words` describe it for the name {x}.

    Statements of bounds found by search name the domain if it `restricts` anything.
    `algebra/domains.py` draws inputs from it."""

    name: str
    words: str
    restricts: bool = True


ANY = Domain("any", "{x} any numbers", False)
ROTATION = Domain("rotation", "{x} a rotation")
NEAR_ROTATION = Domain("near rotation", "{x} a rotation or nearly one", False)
DISPLACEMENT = Domain("displacement", "R of {x} a rotation")
UNIT_VECTOR = Domain("unit vector", "|{x}| = 1")
UNIT_QUATERNION = Domain("unit quaternion", "|{x}| = 1")
NONZERO = Domain("nonzero", "{x} not 0", False)
NONZERO_MATRIX = Domain("nonzero matrix", "{x} not 0", False)
ORDINARY = Domain("ordinary", "2^-450 < |{x}| < 2^511, in single precision 2^-45 < |{x}| < 2^63")
FRACTION = Domain("fraction", "0 <= {x} <= 1")
ANGLE, ANGLES = Domain("angle", "{x} an angle", False), Domain("angles", "{x} angles", False)
TURN = Domain("turn", "|{x}| <= 1e13, in single precision 1e5")
HALF_TURN = Domain("half turn", "|{x}| <= π")
SINE_COSINE = Domain("sine, cosine", "{x} = (sin θ, cos θ)")
REGULAR, SYMMETRIC = Domain("regular", "det {x} not 0"), Domain("symmetric", "{x} symmetric")
POSITIVE_DEFINITE = Domain("positive definite", "{x} symmetric, positive definite")
LDL_FACTOR = Domain("LDL factor", "{x} the L and D of an LDL^T, D > 0")
MASS, BODY = Domain("mass", "{x} >= 0"), Domain("body", "{x} of a body that can be")
"""ROTATION, DISPLACEMENT, UNIT_VECTOR, UNIT_QUATERNION: up to one rounding of each component.
TURN, HALF_TURN: the angle of a rotation vector, or of a screw's angular part."""

TOLERANCE = Fraction(1, 1000)
"""A matrix counts as a rotation if |R^T R - I|_ij and |det R - 1| are at most this; a quaternion as
a unit one if | |q| - 1 | is.  Decimals with three digits and results of single precision pass;
reflections, and matrices that are scaled by 0.05 %, do not."""


@dataclass(frozen=True)
class Part:
    """A named block of a quantity: `R` and `t` of a displacement, `lin` and `ang` of a screw."""

    name: str
    rows: range
    columns: range


@dataclass(frozen=True)
class Quantity:
    """A kind of value.  `shape` is its array shape: () scalar, (n,) column, (rows, columns)."""

    name: str
    shape: tuple[int, ...]
    parts: tuple[Part, ...]
    words: str  # description with units, for the documentation
    domain: Domain | None = None  # of inputs of this kind; None: every input names its own

    @property
    def size(self) -> int:
        """Number of components."""
        return prod(self.shape)

    @property
    def rows_columns(self) -> tuple[int, int]:
        """The shape as a matrix: a scalar is 1×1, a column n×1."""
        rows, columns, *_ = (*self.shape, 1, 1)
        return rows, columns

    @property
    def indices(self) -> tuple[tuple[int, int], ...]:
        """(row, column) of every component, row by row."""
        rows, columns = self.rows_columns
        return tuple((i, j) for i in range(rows) for j in range(columns))

    @property
    def core(self) -> str:
        """The shape as a gufunc signature writes it: '(3,4)'."""
        return f"({','.join(map(str, self.shape))})"

    def place(self, row: int, column: int) -> tuple[int, int]:
        """(number of its part, its index in the part, row by row) of a component."""
        for number, part in enumerate(self.parts):
            if row in part.rows and column in part.columns:
                inner = (row - part.rows.start) * len(part.columns) + column - part.columns.start
                return number, inner
        raise ValueError(f"{self.name} has no component ({row}, {column})")


def _whole(name: str, shape: tuple[int, ...], words: str,
           domain: Domain | None = None) -> Quantity:
    rows, columns = (*shape, 1, 1)[:2]
    return Quantity(name, shape, (Part("", range(rows), range(columns)),), words, domain)


def _halves(name: str, words: str) -> Quantity:
    lin, ang = Part("lin", range(3), range(1)), Part("ang", range(3, 6), range(1))
    return Quantity(name, (6,), (lin, ang), words, ANY)


SCALAR = _whole("scalar", (), "number")
DC = _whole("dc", (2,), "(sin θ, cos θ)", SINE_COSINE)
VEC3 = _whole("vec3", (3,), "vector")
VEC4 = _whole("vec4", (4,), "vector (x, y, z) and a homogeneous coordinate w", ANY)
MAT3X3 = _whole("mat3x3", (3, 3), "rotation or other 3×3 matrix")
SE3 = Quantity("SE3", (3, 4), (Part("R", range(3), range(3)), Part("t", range(3), range(3, 4))),
               "displacement [R | t], R rotation, t in m", DISPLACEMENT)
SCREW = _halves("screw", "screw (v in m/s; ω in rad/s)")
COSCREW = _halves("coscrew", "coscrew (f in N; τ in N m)")
ANGULAR_FIRST = _whole("angular_first", (6,), "six components with the angular part on top", ANY)
MAT4X4 = _whole("mat4x4", (4, 4), "4×4 matrix")
MAT6X6 = _whole("mat6x6", (6, 6), "6×6 operator")
QUATERNION = Quantity("quaternion", (4,), (Part("v", range(3), range(1)),
                                           Part("w", range(3, 4), range(1))),
                      "quaternion (x, y, z, w), the scalar last", UNIT_QUATERNION)
INERTIA = Quantity("inertia", (10,), (Part("m", range(1), range(1)),
                                      Part("mt", range(1, 4), range(1)),
                                      Part("I", range(4, 10), range(1))),
                   "inertia (m in kg; mt = m c in kg m; I about the centre of mass c, "
                   "xx, yy, zz, xy, yz, zx in kg m^2)", BODY)
SPATIAL_INERTIA = Quantity("spatial_inertia", (10,), (Part("m", range(1), range(1)),
                                                      Part("h", range(1, 4), range(1)),
                                                      Part("I", range(4, 10), range(1))),
                           "spatial inertia (m in kg; h = m c in kg m; I about the origin, "
                           "xx, yy, zz, xy, xz, yz in kg m^2)", BODY)

QUANTITIES = (SCALAR, DC, VEC3, VEC4, MAT3X3, MAT4X4, SE3, SCREW, COSCREW, ANGULAR_FIRST, MAT6X6,
              QUATERNION, INERTIA, SPATIAL_INERTIA)


@dataclass(frozen=True)
class Argument:
    """A named input or output of an operation.  An input has a domain, its own or its quantity's;
    `Operation` refuses inputs without."""

    name: str
    quantity: Quantity
    own_domain: Domain | None = None

    @property
    def domain(self) -> Domain:
        """The values it may take, if it is an input."""
        return self.own_domain or self.quantity.domain or ANY

    @property
    def says_its_domain(self) -> bool:
        return (self.own_domain or self.quantity.domain) is not None

    @property
    def domain_in_words(self) -> str:
        """The domain in terms of the argument's name: '|v| <= π'."""
        angular = any(part.name == "ang" for part in self.quantity.parts)
        return self.domain.words.format(x=f"ω of {self.name}" if angular else self.name)

    @cached_property
    def symbols(self) -> tuple[sp.Symbol, ...]:
        """One SymPy symbol per component, row by row: `a`, `c_0`, `D_03`."""
        import sympy as sp

        shape = self.quantity.shape
        if not shape:
            return (sp.Symbol(self.name),)
        if len(shape) == 1:
            return tuple(sp.Symbol(f"{self.name}_{i}") for i in range(shape[0]))
        return tuple(sp.Symbol(f"{self.name}_{i}{j}") for i, j in self.quantity.indices)

    @property
    def value(self) -> sp.Matrix | sp.Symbol:
        """The argument as formulas see it: a scalar symbol or a matrix of symbols."""
        import sympy as sp

        if not self.quantity.shape:
            return self.symbols[0]
        return sp.Matrix(*self.quantity.rows_columns, self.symbols)


def in_words(arguments: tuple[Argument, ...]) -> str:
    """The arguments with their meanings and units: 'D: displacement …; ci, co: coscrew …'."""
    names: dict[str, list[str]] = {}
    for argument in arguments:
        names.setdefault(argument.quantity.words, []).append(argument.name)
    return "; ".join(f"{', '.join(group)}: {words}" for words, group in names.items())
