"""Judges certified bounds in C with numbers of 113 bits: a scene's plain program, evaluated with
its exact decimals as sums of three doubles.

Shares the plain program with the code under test, and nothing of the tier.  Its own errors, 2^-113
of sizes, are far below what bounds add to the first order, 2^-106 of them.
"""

import ctypes
import tempfile
from collections.abc import Callable, Iterator
from fractions import Fraction
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from coscrew_codegen.program import Constant, Input, NotANumber, Op, Operand, Program
from coscrew_codegen.program.tables import TableColumn
from tests.support.compiled.c_harness import run

COMMAND = "gcc", "-O1", "-shared", "-fPIC", "-w"
"""Only gcc has quadmath.h on x86-64."""
_SPELLED = {
    Op.ADD: "{} + {}", Op.SUB: "{} - {}", Op.MUL: "{} * {}", Op.DIV: "{} / {}", Op.NEG: "-{}",
    Op.ABS: "fabsq({})", Op.SQRT: "sqrtq({})", Op.SIN: "sinq({})", Op.COS: "cosq({})",
    Op.EXP: "expq({})", Op.TANH: "tanhq({})", Op.LESS: "{} < {}", Op.EQUAL: "{} == {}",
    Op.SELECT: "{} ? {} : {}"}
_HEAD = """\
#include <quadmath.h>
#include <stddef.h>
typedef __float128 Q;
static double judged(Q x, double found, double bound) {
  const Q error = fabsq(found - x);
  const double ratio = error == 0 ? 0 : (double)(error / bound);
  return error <= bound ? (ratio < 1 ? ratio : 1) : ratio > 1 ? ratio : 1 + 0x1p-52;
}
"""
Judge = Callable[[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]],
                 NDArray[np.float64]]


def source(program: Program) -> str:
    """C of the function `judge`: (n, inputs, results, bounds, → errors / bounds), a state a row."""
    starts = np.cumsum([0, *(a.quantity.size for a in program.inputs)]).tolist()
    names = {step.name: f"x{n}" for n, step in enumerate(program.instructions)}

    def text(x: Operand) -> str:
        if isinstance(x, Input):
            return f"(Q)in[{starts[x.argument] + x.index}]"
        if isinstance(x, Constant):
            return f"({' + '.join(f'(Q){part}' for part in _parts(x.double))})"
        assert not isinstance(x, TableColumn)
        return "(Q)NAN" if isinstance(x, NotANumber) else names[x.name]

    lines = [f"const Q {names[step.name]} = {_SPELLED[step.op].format(*map(text, step.operands))};"
             for step in program.instructions]
    count = len(program.results)
    lines += [f"ratio[{n}] = judged({text(x)}, found[{n}], bound[{n}]);"
              for n, x in enumerate(program.results)]
    body = "\n    ".join((*lines, f"in += {starts[-1]}; found += {count}; bound += {count}; "
                          f"ratio += {count};"))
    return (f"{_HEAD}void judge(ptrdiff_t n, const double *in, const double *found,\n"
            f"           const double *bound, double *ratio) {{\n  while (n--) {{\n    {body}\n"
            "  }\n}\n")


def _parts(value: Fraction) -> Iterator[str]:
    """Three doubles whose sum is the number, all but 2^-159 of it."""
    for _ in range(3):
        part = float(value)
        value -= Fraction(part)
        yield part.hex()


def judge(program: Program, folder: Path) -> Judge:
    """The function, compiled, from inputs, results and bounds, a state a row, to errors / bounds:
    at most 1 where a bound holds."""
    path = Path(tempfile.mkdtemp(dir=folder), f"{program.name}.c")  # none is opened twice
    path.write_text(source(program))
    run((*COMMAND, path, "-o", path.with_suffix(".so"), "-lquadmath"))
    call = ctypes.CDLL(str(path.with_suffix(".so"))).judge
    call.argtypes = [ctypes.c_ssize_t, *[ctypes.c_void_p] * 4]

    def judged(given: NDArray[np.float64], results: NDArray[np.float64], bound: NDArray[np.float64]
               ) -> NDArray[np.float64]:
        arrays = [np.ascontiguousarray(x, float) for x in (given, results, bound)]
        ratios = np.empty(arrays[1].shape)
        call(len(given), *(x.ctypes.data for x in (*arrays, ratios)))
        return ratios

    return judged
