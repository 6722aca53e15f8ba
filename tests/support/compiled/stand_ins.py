"""Replacements for sin, cos, atan2, exp and tanh, which C libraries round differently.

In C and in NumPy they are the same few operations, each rounded once, so that functions that call
them have the same bits everywhere.  They have the signs, ranges and limits of the originals, but
not their values; (cos, sin) lies on the unit circle.
"""

import sys
from collections.abc import Iterator
from contextlib import contextmanager

import numpy as np
import pytest

from coscrew_codegen.formats import PRECISIONS

# Through volatile objects nothing is fused, under any flag.
_OF_PRECISION = """
static NOT_FOLDED {real} near_sin{f}({real} x) {{
  volatile {real} half = x / 2, square = half * half, below = 1 + square;
  return x / below;
}}
static NOT_FOLDED {real} near_cos{f}({real} x) {{
  volatile {real} half = x / 2, square = half * half, above = 1 - square, below = 1 + square;
  return above / below;
}}
static NOT_FOLDED {real} near_atan2{f}({real} y, {real} x) {{
  volatile {real} size = fabs{f}(y) + fabs{f}(x), part = y / size, left = 2 - part;
  volatile {real} below = -2 - part;
  return x < 0 ? y < 0 ? below : left : part;
}}
static NOT_FOLDED {real} near_exp{f}({real} x) {{
  volatile {real} more = 1 + x, less = 1 - x;
  return x > 0 ? more : 1 / less;
}}
static NOT_FOLDED {real} near_tanh{f}({real} x) {{
  volatile {real} below = 1 + fabs{f}(x);
  return x / below;
}}
"""
_NAMES = ("sin", "cos", "atan2", "exp", "tanh")

C = """\
#include <math.h>
#include <string.h>
#if defined(__clang__)
#define NOT_FOLDED __attribute__((noinline, unused))
#else
#define NOT_FOLDED __attribute__((noinline, noclone, unused))
#endif
""" + "".join(_OF_PRECISION.format(real=p.c_type, f=p.suffix) for p in PRECISIONS) + "\n" + "".join(
    f"#define {name}{p.suffix} near_{name}{p.suffix}\n" for p in PRECISIONS for name in _NAMES)
"""The text that a C program includes first."""


def _sin(x: np.ndarray) -> np.ndarray:
    half = x / 2
    return x / (1 + half * half)


def _cos(x: np.ndarray) -> np.ndarray:
    half = x / 2
    square = half * half
    return (1 - square) / (1 + square)


def _atan2(y: np.ndarray, x: np.ndarray) -> np.ndarray:
    part = y / (abs(y) + abs(x))
    return np.where(x < 0, np.where(y < 0, -2 - part, 2 - part), part)


def _exp(x: np.ndarray) -> np.ndarray:
    return np.where(x > 0, 1 + x, 1 / (1 - x))


def _tanh(x: np.ndarray) -> np.ndarray:
    return x / (1 + abs(x))


_IN_NUMPY = {"sin": _sin, "cos": _cos, "arctan2": _atan2, "exp": _exp, "tanh": _tanh}


@contextmanager
def in_numpy(package: str) -> Iterator[None]:
    """All modules of a package compute with them."""
    with pytest.MonkeyPatch.context() as patch:
        for module in [module for path, module in sys.modules.items()
                       if f"{path}.".startswith(f"{package}.")]:
            for name, function in _IN_NUMPY.items():
                if vars(module).get(name) is getattr(np, name):
                    patch.setattr(module, name, function)
        yield
