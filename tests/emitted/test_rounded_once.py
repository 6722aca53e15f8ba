"""The text of all emitted C rounds once a statement, so that compilers find nothing to fuse.

Outside KSL_MUL there is no product of two numbers that could round; and between commas and
semicolons there is one operation, since clang fuses within expressions by default.
"""

import re
from collections.abc import Iterator

import numpy as np
import pytest

from coscrew_codegen.targets import scene_c
from tests.support.compiled.c_harness import C_FOLDER
from tests.support.scenes import scene_bits
from tests.support.scenes.generated_scenes import BANNER, CASES

LIBRARY = {path.name: path for path in sorted(C_FOLDER.glob("*.h"))}
SCENES = {**CASES, "carrier": scene_bits.functions}

_REMOVED = re.compile(r"/\*.*?\*/|^[ \t]*#(?:[^\n]|(?<=\\)\n)*|\"[^\"\n]*\"",
                      re.DOTALL | re.MULTILINE)
_OPERATION = re.compile(r"(?<![=(,?:<>&|{;]) ([-+*/]) ")
_COMPOUND = re.compile(r" ([-+*/])= ")
_BRACKETS = re.compile(r"\[[^\[\]]*\]")
_SINGLE = r"(?:\(double\)\S+|([\d.]+))"
_EXACT = re.compile(rf"= {_SINGLE} \* {_SINGLE}")
_INTEGERS = re.compile(r"\b(?:stride|[ab]_stride|axes\.[xyz]|sizeof)\b")


def wrong(text: str) -> Iterator[str]:
    """The expressions that round more than once, or a product without KSL_MUL."""
    for piece in re.split(r"[;{},]", _REMOVED.sub("", text)):
        expression = " ".join(piece.split())
        while _BRACKETS.search(expression):
            expression = _BRACKETS.sub("", expression)
        found = _OPERATION.findall(expression) + _COMPOUND.findall(expression)
        if not found or _INTEGERS.search(expression):
            continue
        if len(found) > 1 or "*" in found and not _exact(expression):
            yield expression


def _exact(expression: str) -> bool:
    """Whether this is a product of two numbers of single precision, in double."""
    match = _EXACT.search(expression)
    return match is not None and all(float(np.float32(x)) == float(x) for x in match.groups() if x)


@pytest.mark.parametrize("name", LIBRARY)
def test_the_library_rounds_once_a_statement(name: str):
    assert list(wrong(LIBRARY[name].read_text(encoding="utf-8"))) == []


@pytest.mark.parametrize("name", SCENES)
def test_scenes_round_once_a_statement(name: str):
    for text in scene_c.files(SCENES[name](), BANNER).values():
        assert list(wrong(text)) == []


@pytest.mark.parametrize("text", [
    "  w[i] = half * kv1[i];", "x = a + b - c;", "v[i] += h * a[i];", "f(x, a + b * c);",
    "const double k = *t, twice = 2 * k;", "a *= b;", "const double x = a[i + 1] * b,\n    y = c;",
    "angles->x = x + whole * ceil(y);", "x = 0.1 * (double)a;", "x = (double)a * b;"])
def test_what_rounds_twice_would_be_noticed(text: str):
    assert list(wrong(text))


@pytest.mark.parametrize("text", [
    "x = KSL_MUL(a, b);", "/* a * b + c */ x = -a + b, y = c - d;", "x = (double)a * (double)b;",
    "x = 0.5 * (double)a->m01;",
    "#define KSL_MUL(a, b) \\\n  ((a) * (b))\nint x;", "const double *t = a + 1;",
    "x = a[i * 3 + j];",
    "swap(a + i * a_stride, b);", "y = a < b ? -c : c;"])
def test_what_rounds_once_is_right(text: str):
    assert not list(wrong(text))
