"""The file CASE of climb.c: a kernel, its inputs as functions of free parameters, truth and bounds.

Truth is the plain program in long double, for the rotations nearest to the given ones; for
residuals (backward.py) it is their formula.
"""

from collections.abc import Iterator

import mpmath as mp
import numpy as np
import sympy as sp

from coscrew_codegen.algebra.operations import Operation
from coscrew_codegen.algebra.operations.operation import GRID, PER_PRECISION
from coscrew_codegen.backends.c.c_operations import c_type, member
from coscrew_codegen.program import Constant, Input, Op, Operand
from coscrew_codegen.program.values.formats import PRECISIONS, Precision
from coscrew_codegen.program.values.quantity import (
    ANGLE,
    ANY,
    DISPLACEMENT,
    FRACTION,
    HALF_TURN,
    NEAR_ROTATION,
    NONZERO,
    ORDINARY,
    ROTATION,
    SYMMETRIC,
    TURN,
    UNIT_QUATERNION,
    UNIT_VECTOR,
    Argument,
)
from tests.hard_cases.corpus import TABLE
from tests.support.compiled.c_harness import call_of, distinct
from tests.support.truth.attack import plain_program
from tests.support.truth.backward import BACKWARD, expressions
from tests.support.truth.judge import Group, groups

LARGEST = 50.0  # largest angle searched; test_motions and the corpus have larger ones

_PARAMETERS = {"t": 3, "u": 3, "l": 3, "a": 1, "f": 1, "q": 4, "m": 1, "r": 9}


def parameters(operation: Operation) -> int:
    """Number of free parameters."""
    return sum(_PARAMETERS[kind] for kind in _kinds(operation))


def _kinds(operation: Operation) -> str:
    """The parameters of all inputs, a letter for the kind of each: turn, unit, lever, angle,
    fraction, quaternion, multiple, rows."""
    return "".join(_kind(operation, a) for a in operation.inputs)


def _kind(operation: Operation, argument: Argument) -> str:
    if "euler" in operation.name:
        return "aaa"
    if argument.domain in (TURN, HALF_TURN) and argument.quantity.name == "screw":
        return "lt"
    return _LETTERS[argument.domain]


_LETTERS = {NEAR_ROTATION: "r", SYMMETRIC: "r", FRACTION: "f", ANY: "a", ANGLE: "a", TURN: "t",
            UNIT_VECTOR: "u", HALF_TURN: "t", ROTATION: "t", DISPLACEMENT: "tl",
            UNIT_QUATERNION: "q", NONZERO: "qm", ORDINARY: "qm"}

_MADE = {  # lines of C: parameters p, rounded inputs x
    "a": "x[0] = (REAL)fmax(-PI, fmin(PI, p[0]));",
    "f": "x[0] = (REAL)fmax(0, fmin(1, p[0]));",
    "u": "unit(p, 3, 1, x);", "q": "unit(p, 4, 1, x);",
    "qm": "unit(p, 4, exp2l(fmax(-20, fmin(20, p[4]))), x);",
    "mat3x3": "rotation(p, x, 3);",
    "tl": "rotation(p, x, 4); for (int i = 0; i < 3; i++) { x[4 * i + 3] = (REAL)p[3 + i]; }",
    "t": "turn(p, x);",
    "lt": "for (int i = 0; i < 3; i++) { x[i] = (REAL)p[i]; } turn(p + 3, x + 3);",
    "r": "for (int i = 0; i < 9; i++) { x[i] = (REAL)p[i]; }",
}

_HEAD = """
#include <ksl/ksl.h>
#include <tgmath.h>
#define PI 3.141592653589793238L
static void turn(const double *p, REAL *x) {
  const long double n = hypotl(hypotl(p[0], p[1]), p[2]);
  const long double k = n > LARGEST ? LARGEST / n : 1;
  for (int i = 0; i < 3; i++) { x[i] = (REAL)(k * p[i]); }
}
static void unit(const double *p, int size, long double multiple, REAL *x) {
  long double square = 0;
  for (int i = 0; i < size; i++) { square += (long double)p[i] * p[i]; }
  for (int i = 0; i < size; i++) {
    x[i] = (REAL)(square > 0 ? multiple * p[i] / sqrtl(square) : i == 0 ? multiple : 0);
  }
}
static void rotation(const double *p, REAL *R, int columns) {
  const long double half = hypotl(hypotl(p[0], p[1]), p[2]) / 2;
  const long double k = half > 0 ? sinl(half) / (2 * half) : 0.5L, w = cosl(half);
  const long double x = k * p[0], y = k * p[1], z = k * p[2];
  const long double m[9] = {
      1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y),
      2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
      2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)};
  for (int i = 0; i < 9; i++) { R[columns * (i / 3) + i % 3] = (REAL)m[i]; }
}
static void nearest(long double *R, int columns) { /* R (3 I - R^T R) / 2, until it is a rotation */
  for (int step = 0; step < 3; step++) {
    long double S[9], Q[9];
    for (int i = 0; i < 9; i++) {
      S[i] = i % 4 ? 0 : 3;
      for (int k = 0; k < 3; k++) { S[i] -= R[columns * k + i / 3] * R[columns * k + i % 3]; }
    }
    for (int i = 0; i < 9; i++) {
      Q[i] = 0;
      for (int k = 0; k < 3; k++) { Q[i] += R[columns * (i / 3) + k] * S[3 * k + i % 3] / 2; }
    }
    for (int i = 0; i < 9; i++) { R[columns * (i / 3) + i % 3] = Q[i]; }
  }
}
"""


def parts(operation: Operation) -> tuple[Group, ...]:
    """The parts that have a bound; of residuals, all."""
    if operation.name in BACKWARD:
        return (Group(tuple(range(9)), BACKWARD[operation.name].k),)
    return groups(operation, "plain")


def text_of(operation: Operation, precision: Precision) -> str:
    """The file CASE of climb.c."""
    size = [sum(a.quantity.size for a in arguments)
            for arguments in (operation.inputs, operation.outputs)]
    largest = LARGEST if any(a.domain == TURN for a in operation.inputs) else "PI"
    result = parts(operation)
    judged = (_given_back if operation.name in BACKWARD else _compared)(operation, precision)
    of = 9 if operation.name in BACKWARD else size[1]
    defines = {"REAL": precision.c_type, "INPUTS": size[0], "OUTPUTS": size[1],
               "U": float(np.finfo(precision.numpy_type).eps) / 2,
               "KINDS": f'"{_kinds(operation)}"', "JUDGED": of,
               "PARAMETERS": parameters(operation), "GROUPS": len(result),
               "LARGEST": largest, "LEAST": 1e-250 if precision.name == "double" else 1e-25}
    return "\n".join([*(f"#define {name} {value}" for name, value in defines.items()), _HEAD,
                      *_tables(result, size[0], of), _made(operation),
                      _turned(operation), *_OPPOSITE.get(operation.name, ()),
                      _evaluate(operation, precision), judged])


def _tables(results: tuple[Group, ...], inputs: int, judged: int) -> Iterator[str]:
    for name, size, chosen in (("PLACES", judged, lambda g: g.places),
                               ("BESIDE", inputs, lambda g: g.inputs)):
        rows = ", ".join("{" + ", ".join(str(int(i in chosen(g))) for i in range(size)) + "}"
                         for g in results)
        yield f"static const int {name}[GROUPS][{size}] = {{{rows}}};"
    slopes = ", ".join(str(g.slope / g.k) for g in results)
    yield f"static const double SLOPE[GROUPS] = {{{slopes}}};"


def _made(operation: Operation) -> str:
    lines, p, x = [], 0, 0
    for a in operation.inputs:
        kind = _kind(operation, a)
        made = (_of_angles(operation) if kind == "aaa" else
                _MADE["mat3x3" if (a.quantity.name, kind) == ("mat3x3", "t") else kind])
        lines.append(f"  {{ const double *p = all + {p}; REAL *x = to + {x}; {made} }}")
        p, x = p + sum(_PARAMETERS[k] for k in kind), x + a.quantity.size
    return "\n".join(["static void made(const double *all, REAL *to) {", *lines, "}"])


def _of_angles(operation: Operation) -> str:
    """The rotation by three Euler angles, rounded."""
    angles = sp.symbols("p_0:3", real=True)
    inverse = TABLE["mat3x3_from_" + operation.name.removesuffix("_from_mat3x3")]
    entries = enumerate(inverse.formula(sp.Matrix(angles)))
    return " ".join([*(f"const long double p_{i} = p[{i}];" for i in range(3)),
                     *(f"x[{i}] = (REAL)({_c(entry)});" for i, entry in entries)])


def _turned(operation: Operation) -> str:
    start, value = 0, "0"
    for a in operation.inputs:
        start += a.quantity.size
        if a.domain == TURN:
            value = f"hypot(hypot(x[{start - 3}], x[{start - 2}]), x[{start - 1}])"
    return f"static double turned(const REAL *x) {{ (void)x; return (double){value}; }}"


_OPPOSITE = {  # whether both ways are equally short, except for rounding errors
    "quaternion_interpolated": ("""#define OPPOSITE
static int opposite(const REAL *x) {
  long double dot = 0;
  for (int i = 0; i < 4; i++) { dot += (long double)x[i] * x[4 + i]; }
  return fabsl(dot) < 64 * U;
}""",),
    "SE3_interpolated": ("""#define OPPOSITE
static int opposite(const REAL *x) {
  long double R[9];
  for (int i = 0; i < 9; i++) {
    R[i] = 0;
    for (int k = 0; k < 3; k++) { R[i] += (long double)x[4 * k + i / 3] * x[12 + 4 * k + i % 3]; }
  }
  return R[0] + R[4] + R[8] < 0 &&
      hypotl(hypotl(R[7] - R[5], R[2] - R[6]), R[3] - R[1]) < 128 * U;
}""",)}


def _evaluate(operation: Operation, precision: Precision) -> str:
    lines = [f"{c_type(a.quantity, precision)} {a.name};" for a in distinct(operation)]
    for array, arguments in (("x", operation.inputs), ("y", operation.outputs)):
        start = 0
        if array == "y":
            names = {a.name: a.name for a in distinct(operation)}
            lines.append(call_of(operation, precision, names))
        for a in arguments:
            for i in range(a.quantity.size):
                at, place = f"{array}[{start + i}]", f"{a.name}{member(a.quantity, i)}"
                lines.append(f"{place} = {at};" if array == "x" else f"{at} = {place};")
            start += a.quantity.size
    return "\n".join(["static void evaluate(const REAL *x, REAL *y) {",
                      *(f"  {line}" for line in lines), "}"])


_WIDE = {Op.ADD: "{} + {}", Op.SUB: "{} - {}", Op.MUL: "{} * {}", Op.SCALE: "{} * {}",
         Op.DIV: "{} / {}", Op.NEG: "-({})", Op.ABS: "fabsl({})", Op.SQRT: "sqrtl({})",
         Op.SIN: "sinl({})", Op.COS: "cosl({})", Op.ATAN2: "atan2l({}, {})", Op.LESS: "{} < {}",
         Op.EQUAL: "{} == {}", Op.SELECT: "({}) ? {} : {}"}


def _compared(operation: Operation, precision: Precision) -> str:
    """The plain program in long double, with GRID for its 64 bits; interpolation keeps the error of
    D1."""
    program, starts, start, lines = plain_program(operation), [], 0, []
    for a in program.inputs:
        starts.append(start)
        if a.domain in (ROTATION, DISPLACEMENT) and operation.name != "SE3_interpolated":
            lines.append(f"  nearest(in_ + {start}, {a.quantity.rows_columns[1]});")
        start += a.quantity.size
    grid = int(PER_PRECISION[GRID][PRECISIONS.index(precision)])

    def value(x: Operand) -> str:
        if isinstance(x, Input):
            return f"in_[{starts[x.argument] + x.index}]"
        if isinstance(x, Constant):
            exact = precision.value(x)
            exact = 2**34 if exact == grid else exact
            with mp.workdps(40):
                return mp.nstr(mp.mpf(exact.numerator) / exact.denominator, 25) + "L"
        return x.name

    steps = [f"  const long double {s.name} = {_WIDE[s.op].format(*map(value, s.operands))};"
             for s in program.instructions]
    results = [f"  sizes_[{i}] = {value(x)}; errors_[{i}] = fabsl(got_[{i}] - sizes_[{i}]);"
               for i, x in enumerate(program.results)]
    return "\n".join([_JUDGED, *lines, *steps, *results, "}"])


def _given_back(operation: Operation, precision: Precision) -> str:
    """Residuals, and the sizes to which they are relative."""
    symbols, residuals, size = expressions(operation)
    common, (*result, whole) = sp.cse([*residuals, size])
    numbers = [(x, f"{'got_' if x.name.startswith('out_') else 'in_'}[{x.name.partition('_')[2]}]")
               for x in symbols]
    return "\n".join([
        _JUDGED, *(f"  const long double {x.name} = {place};" for x, place in numbers),
        *(f"  const long double {x.name} = {_c(value)};" for x, value in common),
        *(f"  sizes_[{i}] = {_c(whole)}; errors_[{i}] = fabsl({_c(x)});"
          for i, x in enumerate(result)), "}"])


_JUDGED = """static void judged(const REAL *given_, const REAL *got_, long double *errors_,
                   long double *sizes_) {
  long double in_[INPUTS];
  for (int i = 0; i < INPUTS; i++) { in_[i] = given_[i]; }"""


def _c(expression: sp.Expr) -> str:
    """C that calls the functions of tgmath.h."""
    square = [(lambda base, exponent: exponent == 2, lambda base, exponent: f"({base})*({base})")]
    return sp.ccode(expression, user_functions={"Pow": square})
