"""A scene's accurate C in which a run-time switch flips any one sign, compiled once.

`x - y` reads `x - sign_of[k] * y`, with sign_of[k] 1 or -1: the product is exact, so that all other
bits stay.
"""

import ctypes
import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from tests.support.compiled.c_harness import EXACT, run
from tests.support.compiled.flags import FMA

SIGN = re.compile(r" [-+] |(?<=[=(]) ?-(?=[A-Za-z(])")
STATEMENT = re.compile(r"^  .*=\s[^;]*;", re.M)

LOOP = """
#include <math.h>
/* The worst error of each mutant, in units of the last digit: states until one exceeds `most`. */
void worst_of_mutants(const int *mutants, int count, int n, const double *given[3],
    const double *high, const double *low, const double *unit, double most, double *worst) {
  for (int m = 0; m < count; m++) {
    if (mutants[m] >= 0) { sign_of[mutants[m]] = -1.0; }
    worst[m] = 0;
    for (int row = 0; row < n && worst[m] <= most; row++) {
      double found[SIZE];
      FUNCTION(given[0] + SIZE * row, given[1] + SIZE * row, given[2] + SIZE * row, found);
      for (int k = 0; k < SIZE; k++) {
        const int place = SIZE * row + k;
        const double error = fabs((found[k] - high[place]) - low[place]) / unit[place];
        if (!(error <= worst[m])) { worst[m] = error == error ? error : INFINITY; }
      }
    }
    if (mutants[m] >= 0) { sign_of[mutants[m]] = 1.0; }
  }
}
"""


@dataclass(frozen=True)
class Mutants:
    """The signs of a function's text, and the library in which they can be flipped."""

    lines: tuple[str, ...]  # the text around each sign
    library: ctypes.CDLL
    size: int

    def worst(self, mutants: list[int], given: list[np.ndarray], high: np.ndarray, low: np.ndarray,
              unit: np.ndarray, most: float) -> np.ndarray:
        """The largest error found of each mutant (-1: of none), at most a little beyond `most`; NaN
        in `high` leaves a result out."""
        worst = np.zeros(len(mutants))
        chosen = np.array(mutants, np.intc)
        rows = [np.ascontiguousarray(x, float) for x in (*given, high, low, unit)]
        at = [x.ctypes.data_as(ctypes.c_void_p) for x in rows]
        self.library.worst_of_mutants(
            chosen.ctypes.data_as(ctypes.c_void_p), len(mutants), len(high),
            (ctypes.c_void_p * 3)(*at[:3]), *at[3:], ctypes.c_double(most),
            worst.ctypes.data_as(ctypes.c_void_p))
        return worst


def mutants(folder: Path, files: dict[str, str], stem: str, function: str, size: int) -> Mutants:
    """Of a function from three rows of `size` numbers to one, `function` in `stem`.c."""
    text, lines = files[f"{stem}.c"], list[str]()
    first = text.index(f"struct {function.replace('_accurate', '')}_values_accurate {{")
    last = text.index("\n}\n", text.index(f"void {function}(")) + 3

    def statement(found: re.Match[str]) -> str:
        left, equals, right = found[0].partition("=")

        def sign(one: re.Match[str]) -> str:
            before, after = right[:one.start()][-50:], right[one.end():][:30]
            lines.append(" ".join(f"{before} [{one[0].strip()}] {after}".split()))
            return f"{one[0].rstrip()} sign_of[{len(lines) - 1}] * "

        return left + equals + SIGN.sub(sign, right)

    changed = STATEMENT.sub(statement, text[first:last])
    for name, other in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(other)
    (folder / "mutants.c").write_text("\n".join((
        f"static double sign_of[{len(lines)}];", text[:first], changed, "#endif",
        LOOP.replace("SIZE", str(size)).replace("FUNCTION", function),
        f"void start(void) {{ for (int k = 0; k < {len(lines)}; k++) {{ sign_of[k] = 1.0; }} }}")))
    run(("gcc", "-std=gnu11", "-O1", *FMA, EXACT, "-fPIC", "-shared", "-I", folder,
         folder / "mutants.c", "-o", folder / "mutants.so", "-lm"))
    library = ctypes.CDLL(str(folder / "mutants.so"))
    library.start()
    return Mutants(tuple(lines), library, size)
