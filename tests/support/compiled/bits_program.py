"""A C program that prints a hash of each kernel's bits, and the expected hashes.

Every kernel runs in a loop over an array of structs and in one over a structure of arrays, on
numbers that C and Python generate identically, including zeros of either sign.  The expected hashes
are those of the NumPy twins, which round every operation once on any machine.  Calls of libm are
replaced by stand-ins.
"""

import functools
import importlib
from collections.abc import Sequence
from dataclasses import dataclass
from types import ModuleType

import numpy as np

from coscrew_codegen.accuracy.tiers import TIERS
from coscrew_codegen.algebra.operations import OPERATIONS, Operation
from coscrew_codegen.backends.c.c_operations import c_name, c_type, member
from coscrew_codegen.program.values.formats import PRECISIONS, Precision
from coscrew_codegen.program.values.quantity import Argument
from tests.support.compiled.c_harness import call_of, distinct, is_array
from tests.support.truth.attack import plain_program

ROWS = 33  # vectors of any width, and a rest
FEW = (0.0, -0.0, 1.0, -1.0, 2.0, -2.0, 0.5, -3.0)
"""Every other row consists of these: sums of their products are often zero, of either sign."""
WIDEST = 36  # components

HEAD = """\
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#if defined(__clang__)
#define NOT_FOLDED __attribute__((noinline, unused))
#else
#define NOT_FOLDED __attribute__((noinline, noclone, unused))
#endif
#if defined(__clang__)
#define INDEPENDENT _Pragma("clang loop vectorize(assume_safety)")
#else
#define INDEPENDENT _Pragma("GCC ivdep")
#endif
"""

_OF_PRECISION = """
/* Component k of argument a in row i; no operation rounds. */
static {real} number_{name}(int a, int k, int i) {{
  uint64_t seed = (uint64_t)((a * {widest} + k) * {rows} + i + 1) * 0x9E3779B97F4A7C15u;
  seed = (seed ^ (seed >> 29)) * 0xBF58476D1CE4E5B9u;
  seed = seed ^ (seed >> 32);
  if (i % 2) {{
    static const {real} few[] = {{{few}}};
    return few[seed >> 61];
  }}
  return (({real})(int64_t)(seed >> {shift}) - {half}) * {unit};
}}

/* Where an entry lies: in its plane, or in a struct, matrices column by column. */
static int place_{name}(int entry, int row, int rows, int columns, int planes) {{
  return planes ? entry * {rows} + row
                : row * rows * columns + entry % columns * rows + entry / columns;
}}

static NOT_FOLDED void fill_{name}({real} *x, int a, int rows, int columns, int planes) {{
  for (int row = 0; row < {rows}; row++) {{
    for (int entry = 0; entry < rows * columns; entry++) {{
      x[place_{name}(entry, row, rows, columns, planes)] = number_{name}(a, entry, row);
    }}
  }}
}}

/* Any NaN counts as any other. */
static NOT_FOLDED uint64_t hashed_{name}(uint64_t hash, const {real} *x, int rows, int columns,
    int planes) {{
  for (int row = 0; row < {rows}; row++) {{
    for (int entry = 0; entry < rows * columns; entry++) {{
      const {real} *number = x + place_{name}(entry, row, rows, columns, planes);
      {bits} bits = 1;
      if (*number == *number) {{ memcpy(&bits, number, sizeof bits); }}
      hash = (hash ^ bits) * 1099511628211u;
    }}
  }}
  return hash;
}}
"""


@dataclass(frozen=True)
class Kernel:
    """An operation in one tier and precision."""

    operation: Operation
    precision: Precision
    tier: str  # "" for plain

    @property
    def name(self) -> str:
        """The name of its C function."""
        name = c_name(self.operation.name, self.precision)
        return f"{name}_{self.tier}" if self.tier else name


def kernels(tier: str, names: Sequence[str] = ()) -> tuple[Kernel, ...]:
    """The kernels of a tier, of these names or of all."""
    made = next(t for t in TIERS if t.mark == tier)
    assert set(names) <= {op.name for op in OPERATIONS}, names
    chosen = [op for op in OPERATIONS if not names or op.name in names]
    return tuple(Kernel(made.operation(op), precision, tier)
                 for precision in PRECISIONS for op in chosen
                 if made.has(plain_program(op)))


def text(chosen: Sequence[Kernel], planes: bool = True) -> str:
    """The program; without `planes`, only with arrays of structs."""
    headers = sorted({f"ksl_{kernel.tier}" if kernel.tier else "ksl" for kernel in chosen})
    parts = [HEAD, *(f"#include <ksl/{header}.h>" for header in headers),
             *map(numbers_and_hashes, PRECISIONS)]
    for number, kernel in enumerate(chosen):
        parts.append(_function(kernel, f"rows_{number}", _rows(kernel)))
        if planes:
            parts.append(_function(kernel, f"planes_{number}", _planes(kernel)))
    layouts = ("rows", "planes") if planes else ("rows",)
    calls = [f"  {layout}_{number}();" for number in range(len(chosen)) for layout in layouts]
    return "\n".join([*parts, "int main(void) {", *calls, "  return 0;", "}", ""])


def wanted(chosen: Sequence[Kernel], planes: bool = True) -> list[str]:
    """The lines that it must print."""
    layouts = ("rows", "planes") if planes else ("rows",)
    return [f"{kernel.name} {layout} {_hash(kernel):016x}" for kernel in chosen
            for layout in layouts]


def numbers_and_hashes(precision: Precision) -> str:
    """C's number_double, fill_double, hashed_double; for single precision, too."""
    digits = {"double": 53, "single": 24}[precision.name]
    f = precision.suffix
    return _OF_PRECISION.format(
        real=precision.c_type, name=precision.name, widest=WIDEST, rows=ROWS, shift=64 - digits,
        few=", ".join(f"{x}{f}" for x in FEW), half=f"{2.0**(digits - 1)}{f}",
        unit=f"{2.0**(3 - digits)}{f}", bits=f"uint{8 * precision.bytes}_t")


def _function(kernel: Kernel, name: str, lines: list[str]) -> str:
    layout = name.partition("_")[0]
    return "\n".join([
        f"static NOT_FOLDED void {name}(void) {{", "  uint64_t hash = 14695981039346656037u;",
        *(f"  {line}" for line in lines),
        f'  printf("{kernel.name} {layout} %016llx\\n", (unsigned long long)hash);', "}", ""])


def _rows(kernel: Kernel) -> list[str]:
    arguments, p = distinct(kernel.operation), kernel.precision
    lines = []
    for a in arguments:
        size = f"[{a.quantity.size}]" if is_array(a) else ""
        lines.append(f"static {c_type(a.quantity, p)} {a.name}[{ROWS}]{size};")
    for number, a in enumerate(kernel.operation.inputs):
        lines.append(f"fill_{p.name}(({p.c_type} *){a.name}, {number}, {_shape(a)}, 0);")
    call = call_of(kernel.operation, p, {a.name: f"{a.name}[row]" for a in arguments}, kernel.tier)
    lines.append(f"for (int row = 0; row < {ROWS}; row++) {{ {call} }}")
    return lines + [f"hash = hashed_{p.name}(hash, (const {p.c_type} *){a.name}, {_shape(a)}, 0);"
                    for a in kernel.operation.outputs]


def _planes(kernel: Kernel) -> list[str]:
    arguments, p = distinct(kernel.operation), kernel.precision
    operation, lines = kernel.operation, []
    for number, a in enumerate(operation.inputs):
        lines += [f"static {p.c_type} in{number}[{a.quantity.size}][{ROWS}];",
                  f"fill_{p.name}(in{number}[0], {number}, {_shape(a)}, 1);"]
    lines += [f"static {p.c_type} out{number}[{a.quantity.size}][{ROWS}];"
              for number, a in enumerate(operation.outputs)]
    lines += ["INDEPENDENT", f"for (int row = 0; row < {ROWS}; row++) {{"]
    for a in arguments:
        size = f"[{a.quantity.size}]" if is_array(a) else ""
        lines.append(f"  {c_type(a.quantity, p)} {a.name}{size};")
    lines += [f"  {a.name}{member(a.quantity, k)} = in{number}[{k}][row];"
              for number, a in enumerate(operation.inputs) for k in range(a.quantity.size)]
    lines.append("  " + call_of(operation, p, {a.name: a.name for a in arguments}, kernel.tier))
    lines += [f"  out{number}[{k}][row] = {a.name}{member(a.quantity, k)};"
              for number, a in enumerate(operation.outputs) for k in range(a.quantity.size)]
    return [*lines, "}", *(f"hash = hashed_{p.name}(hash, out{number}[0], {_shape(a)}, 1);"
                           for number, a in enumerate(operation.outputs))]


def _shape(argument: Argument) -> str:
    rows, columns = argument.quantity.rows_columns if argument.quantity.shape else (1, 1)
    return f"{rows}, {columns}"


def numbers(precision: Precision, argument: int, size: int) -> np.ndarray:
    """number_double, number_single: all rows of an argument."""
    digits = {"double": 53, "single": 24}[precision.name]
    k, i = np.meshgrid(np.arange(size), np.arange(ROWS))
    seeds = ((argument * WIDEST + k) * ROWS + i + 1).astype(np.uint64)
    seeds *= np.uint64(0x9E3779B97F4A7C15)
    seeds = (seeds ^ (seeds >> np.uint64(29))) * np.uint64(0xBF58476D1CE4E5B9)
    seeds = seeds ^ (seeds >> np.uint64(32))
    few = np.array(FEW)[(seeds >> np.uint64(61)).astype(int)]
    many = ((seeds >> np.uint64(64 - digits)).astype(float) - 2.0**(digits - 1)) * 2.0**(3 - digits)
    return np.where(i % 2 == 1, few, many).astype(precision.numpy_type)


@functools.cache
def _twins(tier: str, precision: Precision) -> ModuleType:
    return importlib.import_module(".".join(filter(None, ("coscrew", tier, precision.name))))


@functools.cache
def _hash(kernel: Kernel) -> int:
    inputs = [numbers(kernel.precision, number, a.quantity.size).reshape(
        (ROWS, *a.quantity.shape)) for number, a in enumerate(kernel.operation.inputs)]
    twins = _twins(kernel.tier, kernel.precision)
    with np.errstate(all="ignore"):
        result = getattr(twins, kernel.operation.name)(*inputs)
    return hashed(result if isinstance(result, tuple) else (result,))


def hashed(results: Sequence[np.ndarray]) -> int:
    """hashed_double, hashed_single: of arrays of rows, one after the other."""
    value = 14695981039346656037
    for output in results:
        bits = np.where(np.isnan(output), 1, output.view(f"u{output.itemsize}"))
        for word in bits.ravel().tolist():
            value = (value ^ word) * 1099511628211 % 2**64
    return value
