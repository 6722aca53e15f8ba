"""A scene's accurate C in which a run-time switch flips any one sign, compiled once.

`x - y` reads `x - sign_of[k] * y`, with sign_of[k] 1 or -1: the product is exact, so that all other
bits stay.  The rounding error of the last sum hi + lo of each result is kept in `rest_of`: together
they show errors of second order, which the rounded result hides."""

import ctypes
import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from tests.support.compiled.c_harness import EXACT, run
from tests.support.compiled.flags import FMA

SIGN = re.compile(r" [-+] |(?<=[=(]) ?-(?=[A-Za-z(])")
STATEMENT = re.compile(r"^  .*=\s[^;]*;", re.M)
LONGEST = 200  # letters of a name

LOOP = """
#include <math.h>
static double larger(double worst, double error) {
  return error <= worst ? worst : error == error ? error : INFINITY;
}

/* The worst error of each mutant, in units of the last digit, and that of hi + lo in others: states
   until one exceeds `most`. */
void worst_of_mutants(const int *mutants, int count, int n, const double *given[3],
    const double *truth[4], const double most[2], double *worst) {
  for (int m = 0; m < count; m++) {
    double *rounded = worst + 2 * m, *whole = rounded + 1;
    if (mutants[m] >= 0) { sign_of[mutants[m]] = -1.0; }
    *rounded = *whole = 0;
    for (int row = 0; row < n && *rounded <= most[0] && *whole <= most[1]; row++) {
      double found[SIZE];
      FUNCTION(given[0] + SIZE * row, given[1] + SIZE * row, given[2] + SIZE * row, found);
      for (int k = 0; k < SIZE; k++) {
        const int place = SIZE * row + k;
        const double error = found[k] - truth[0][place], low = truth[1][place];
        *rounded = larger(*rounded, fabs(error - low) / truth[2][place]);
        *whole = larger(*whole, fabs(error + rest_of[k] - low) / truth[3][place]);
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

    def worst(self, mutants: Sequence[int], given: Sequence[np.ndarray],
              truth: Sequence[np.ndarray], most: tuple[float, float]) -> np.ndarray:
        """The largest errors of each mutant (-1: of none) of the rounded results and of hi + lo, at
        most a little beyond `most`.

        `truth` is its upper and its lower part, and the units of both errors."""
        worst = np.zeros((len(mutants), 2))
        rows = [np.ascontiguousarray(x, float) for x in (*given, *truth, most, worst)]
        at = [x.ctypes.data_as(ctypes.c_void_p) for x in rows]
        chosen = np.array(mutants, np.intc)
        self.library.worst_of_mutants(
            chosen.ctypes.data_as(ctypes.c_void_p), len(mutants), len(truth[0]),
            (ctypes.c_void_p * 3)(*at[:3]), (ctypes.c_void_p * 4)(*at[3:7]), *at[7:])
        return rows[-1]


def less_their_errors(text: str) -> list[str]:
    """Places where a value's error is subtracted from it: x_lo is the error of x (x_1 and x_lo_2 of
    x)."""
    return [result[0] for result in re.finditer(r"([\w>.-]*?\w)(?:_\d+)? - \1_lo\w*", text)]


def _last(text: str) -> str:
    """The name that ends a text."""
    return re.split(r"[^\w>.-]", text[-LONGEST:])[-1]


def _first(text: str) -> str:
    """The name that begins a text."""
    return re.split(r"[^\w>.-]", text[:LONGEST], maxsplit=1)[0]


def mutants(folder: Path, files: dict[str, str], stem: str, function: str, size: int) -> Mutants:
    """The mutants of a function from three rows of `size` numbers to one, `function` in `stem`.c.
    """
    text, lines = files[f"{stem}.c"], list[str]()
    values = f"struct {function.replace('_accurate', '')}_values_accurate {{"  # of several parts
    first = text.index(values if values in text else f"void {function}(")
    last = text.index("\n}\n", text.index(f"void {function}(")) + 3

    def statement(results: re.Match[str]) -> str:
        left, equals, right = results[0].partition("=")

        def sign(one: re.Match[str]) -> str:
            before, after = right[:one.start()], right[one.end():]
            if one[0] == " + " and less_their_errors(f"{_last(before)} - {_first(after)}"):
                return one[0]  # noticed in the text
            lines.append(" ".join(f"{before[-50:]} [{one[0].strip()}] {after[:30]}".split()))
            return f"{one[0].rstrip()} sign_of[{len(lines) - 1}] * "

        return left + equals + SIGN.sub(sign, right)

    changed = STATEMENT.sub(statement, text[first:last])
    for name, other in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(other)
    (folder / "mutants.c").write_text("\n".join((
        f"static double sign_of[{len(lines)}], rest_of[{size}];", text[:first],
        _with_rests(changed),
        LOOP.replace("SIZE", str(size)).replace("FUNCTION", function),
        f"void start(void) {{ for (int k = 0; k < {len(lines)}; k++) {{ sign_of[k] = 1.0; }} }}")))
    run(("gcc", "-std=gnu11", "-O1", *FMA, EXACT, "-fPIC", "-shared", "-I", folder,
         folder / "mutants.c", "-o", folder / "mutants.so", "-lm"))
    library = ctypes.CDLL(str(folder / "mutants.so"))
    library.start()
    return Mutants(tuple(lines), library)


def _with_rests(text: str) -> str:
    """After the statement with a result's last sum the sum's rest, by the sum of two numbers
    whatever their sizes.

    A result's sum may have its sign flipped: its operands are read off the text, that not."""
    def matched(pattern: str) -> re.Match[str]:
        match = re.search(pattern, text)
        assert match, pattern
        return match

    for place, result in enumerate(dict.fromkeys(
            re.findall(r"(?:->\w+|\w\[\d+\]) = (\w+_final);", text))):
        total = matched(rf"\b{result} = (?:\w+->)?(\w+) == ")[1]
        match = matched(rf"(?<![>\w]){total} = (\S+) \+(?: sign_of\[\d+\] \*)? "
                        r"(\([^()]*\)|[^\s,;]+)[^;]*;")
        a, b = match.groups()
        right = f"({total} - {a})"
        text = f"{text[:match.end()]}\n  rest_of[{place}] = " \
               f"{a} - ({total} - {right}) + ({b} - {right});{text[match.end():]}"
    return text
