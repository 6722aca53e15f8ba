"""Searches at length for the largest errors of kernels whose bounds are not proved.

`python -m tests.search --minutes M [KERNEL …]` climbs (tests/climb.c) for so many minutes of the
processor's time a kernel and precision; each slice of it is kept in build/search, so that what is
broken off goes on.  Errors are estimated in long double; each champion is confirmed in 60 digits.
Right Jacobians are the left ones of -v, bit for bit but for signs, and are not searched again.
"""

import json
import os
import subprocess
from collections.abc import Iterator
from dataclasses import asdict, dataclass, field
from pathlib import Path

import mpmath as mp
import numpy as np

from coscrew_codegen.operations import Operation
from coscrew_codegen.operations.operation import GRID, PER_PRECISION
from coscrew_codegen.program import Constant, Input, Op, Operand
from coscrew_codegen.quantity import FRACTION, TURN, UNIT, Argument
from coscrew_codegen.targets.c import c_type, member
from coscrew_codegen.targets.precision import PRECISIONS, Precision
from tests.attack import plain_program
from tests.c_harness import INCLUDE, call_of, distinct
from tests.corpus import TABLE, Case, load, save
from tests.judge import Group, groups, ratio

ROOT = Path(__file__).resolve().parents[1]
FOLDER = ROOT / "build" / "search"
SLICE = 60.0  # seconds
LARGEST = 50.0  # angle searched; test_motions and the corpus have larger ones

SEARCHED = tuple(op for op in TABLE.values() if op.normwise and "right" not in op.name)
NAMES = tuple(op.name for op in SEARCHED)


@dataclass
class Found:
    """How long a kernel was searched, and each group's champion: error in u, parameters, inputs."""

    seconds: float = 0.0
    slices: int = 0
    errors: list[float] = field(default_factory=list)
    parameters: list[list[str]] = field(default_factory=list)
    inputs: list[list[str]] = field(default_factory=list)
    of_bound: list[float] = field(default_factory=list)  # confirmed


def path_of(operation: Operation, precision: Precision) -> Path:
    return FOLDER / f"{operation.name}-{precision.name}.json"


def known(operation: Operation, precision: Precision) -> Found:
    path = path_of(operation, precision)
    return Found(**json.loads(path.read_text())) if path.exists() else Found()


def climb(operation: Operation, precision: Precision, seconds: float) -> Iterator[Found]:
    """What is known after each slice, until it has been searched for so long."""
    FOLDER.mkdir(parents=True, exist_ok=True)
    program = _compiled(operation, precision)
    found = known(operation, precision)
    while found.seconds < seconds:
        length = min(SLICE, seconds - found.seconds)
        earlier = [x for row in found.parameters for x in row]
        text = subprocess.run([program, str(found.slices + 1), str(length), *earlier], check=True,
                              capture_output=True, text=True).stdout
        found = _after(operation, precision, found, length, text)
        _kept(path_of(operation, precision), json.dumps(asdict(found), indent=1))
        yield found


def _after(operation: Operation, precision: Precision, before: Found, length: float,
           text: str) -> Found:
    found = Found(before.seconds + length, before.slices + 1)
    given = sum(a.quantity.size for a in operation.inputs)
    free = sum(_PARAMETERS[kind] for kind in _kinds(operation))
    for line in text.splitlines():
        _, error, *numbers = line.split()
        row = [float.fromhex(x) for x in numbers[free:]]
        found.errors.append(float(error))
        found.parameters.append(numbers[:free])
        found.inputs.append(numbers[free:free + given])
        found.of_bound.append(ratio(operation, precision, "plain", row[:given], row[given:]))
    return found


def _kept(path: Path, text: str) -> None:
    part = path.with_suffix(".part")
    part.write_text(text)
    os.replace(part, path)


def search(names: list[str], minutes: float, append: bool) -> int:
    """Climbs for so long, a little of each first; prints each kernel's figures; how many exceed
    their bound."""
    operations = [TABLE[name] for name in names] or list(SEARCHED)
    targets = [(op, precision) for op in operations for precision in PRECISIONS]
    violations = 0
    for budget in (*(m for m in (1, 5) if m < minutes), minutes):
        for operation, precision in targets:
            for _ in climb(operation, precision, 60 * budget):
                pass
            print(line_of(operation, precision), flush=True)
    for operation, precision in targets:
        found = known(operation, precision)
        violations += max(found.of_bound) > 1
        if append:
            origin = f"search --minutes {found.seconds / 60:g}"
            new = [Case(operation, precision, tuple(map(float.fromhex, row)), origin)
                   for row in found.inputs]
            save((*load(), *new))
    return violations


def line_of(operation: Operation, precision: Precision) -> str:
    """Name, precision, minutes, each part's error in u beside what is stated, confirmed ratio."""
    found = known(operation, precision)
    parts = ", ".join(f"{bound.part} {error:.2f} of {bound.k} u" for bound, error in
                      zip(operation.normwise, found.errors, strict=True))
    return (f"{operation.name} {precision.name}, {found.seconds / 60:g} min: {parts}; "
            f"{max(found.of_bound):.3f} of the bound")


# the C


_PARAMETERS = {"t": 3, "h": 3, "u": 3, "l": 3, "a": 1, "f": 1, "q": 4, "m": 1}


def _kinds(operation: Operation) -> str:
    """The parameters of all inputs, a letter for what they are: turn, unit, lever, angle, fraction,
    quaternion, multiple."""
    return "".join(map(_kind, operation.inputs))


def _kind(argument: Argument) -> str:
    if argument.quantity.name == "scalar":
        return "f" if argument.domain == FRACTION else "a"
    if argument.quantity.name == "vec3":
        return "u" if argument.domain == UNIT else "t"
    if argument.quantity.name == "quaternion":
        return "q" if argument.domain == UNIT else "qm"
    return {"mat3x3": "t", "SE3": "tl", "screw": "lt"}[argument.quantity.name]


_MADE = {  # lines of C: parameters p, rounded inputs x
    "a": "x[0] = (REAL)fmax(-PI, fmin(PI, p[0]));",
    "f": "x[0] = (REAL)fmax(0, fmin(1, p[0]));",
    "u": "unit(p, 3, 1, x);", "q": "unit(p, 4, 1, x);",
    "qm": "unit(p, 4, exp2l(fmax(-20, fmin(20, p[4]))), x);",
    "mat3x3": "rotation(p, x, 3);",
    "tl": "rotation(p, x, 4); for (int i = 0; i < 3; i++) { x[4 * i + 3] = (REAL)p[3 + i]; }",
    "t": "turn(p, x);",
    "lt": "for (int i = 0; i < 3; i++) { x[i] = (REAL)p[i]; } turn(p + 3, x + 3);",
}

_HEAD = """
#include <ksl/ksl.h>
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
"""


def text_of(operation: Operation, precision: Precision) -> str:
    """The file CASE of climb.c."""
    size = [sum(a.quantity.size for a in arguments)
            for arguments in (operation.inputs, operation.outputs)]
    largest = LARGEST if any(a.domain == TURN for a in operation.inputs) else "PI"
    found = groups(operation, "plain")
    defines = {"REAL": precision.c_type, "INPUTS": size[0], "OUTPUTS": size[1],
               "U": float(np.finfo(precision.numpy_type).eps) / 2,
               "KINDS": f'"{_kinds(operation)}"',
               "PARAMETERS": sum(_PARAMETERS[k] for k in _kinds(operation)), "GROUPS": len(found),
               "LARGEST": largest, "LEAST": 1e-250 if precision.name == "double" else 1e-25}
    return "\n".join([*(f"#define {name} {value}" for name, value in defines.items()), _HEAD,
                      *_tables(found, *size), _made(operation), _turned(operation),
                      _evaluate(operation, precision), _judged(operation, precision)])


def _tables(found: tuple[Group, ...], inputs: int, outputs: int) -> Iterator[str]:
    for name, size, chosen in (("PLACES", outputs, lambda g: g.places),
                               ("BESIDE", inputs, lambda g: g.inputs)):
        rows = ", ".join("{" + ", ".join(str(int(i in chosen(g))) for i in range(size)) + "}"
                         for g in found)
        yield f"static const int {name}[GROUPS][{size}] = {{{rows}}};"
    slopes = ", ".join(str(g.slope / g.k) for g in found)
    yield f"static const double SLOPE[GROUPS] = {{{slopes}}};"


def _made(operation: Operation) -> str:
    lines, p, x = [], 0, 0
    for a in operation.inputs:
        kind = _kind(a)
        lines.append("  { const double *p = all + %d; REAL *x = to + %d; %s }" % (
            p, x, _MADE["mat3x3" if a.quantity.name == "mat3x3" else kind]))
        p, x = p + sum(_PARAMETERS[k] for k in kind), x + a.quantity.size
    return "\n".join(["static void made(const double *all, REAL *to) {", *lines, "}"])


def _turned(operation: Operation) -> str:
    start, value = 0, "0"
    for a in operation.inputs:
        start += a.quantity.size
        if a.domain == TURN:
            value = f"hypot(hypot(x[{start - 3}], x[{start - 2}]), x[{start - 1}])"
    return f"static double turned(const REAL *x) {{ (void)x; return (double){value}; }}"


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


def _judged(operation: Operation, precision: Precision) -> str:
    """The plain program in long double; GRID for its 64 bits."""
    program, starts, start = plain_program(operation), [], 0
    for a in program.inputs:
        starts.append(start)
        start += a.quantity.size
    grid = int(PER_PRECISION[GRID][PRECISIONS.index(precision)])

    def value(x: Operand) -> str:
        if isinstance(x, Input):
            return f"(long double)in_[{starts[x.argument] + x.index}]"
        if isinstance(x, Constant):
            exact = precision.value(x)
            exact = 2**34 if exact == grid else exact
            with mp.workdps(40):
                return mp.nstr(mp.mpf(exact.numerator) / exact.denominator, 25) + "L"
        return x.name

    steps = [f"  const long double {s.name} = {_WIDE[s.op].format(*map(value, s.operands))};"
             for s in program.instructions]
    results = [f"  out_[{i}] = {value(x)};" for i, x in enumerate(program.results)]
    head = "static void judged(const REAL *in_, long double *out_) {"
    return "\n".join([head, *steps, *results, "}"])


def _compiled(operation: Operation, precision: Precision) -> Path:
    stem = FOLDER / f"{operation.name}-{precision.name}"
    case = stem.with_suffix(".h")
    _kept(case, text_of(operation, precision))
    subprocess.run(["gcc", "-std=gnu11", "-O2", "-ffp-contract=off", "-I", INCLUDE,
                    f'-DCASE="{case}"', Path(__file__).with_suffix(".c"), "-o", stem, "-lm"],
                   check=True)
    return stem
