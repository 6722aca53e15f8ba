"""In all emitted C there is no product that compilers could fuse into a sum.

In the library every product that may be inexact is inside KSL_MUL. In scenes, where a pragma
forbids that compilers fuse within expressions, no product outside RN reaches a sum or a result.
"""

import re
from collections.abc import Iterator

import numpy as np
import pytest
from pycparser import CParser, c_ast
from pycparser.c_generator import CGenerator

from coscrew_codegen.backends.scene import scene_c, scene_c_runtime
from tests.support.compiled import all_headers
from tests.support.scenes import scene_bits
from tests.support.scenes.generated_scenes import BANNER, CASES

SCENES = {**CASES, "carrier": scene_bits.functions}

_REMOVED = re.compile(r"/\*.*?\*/|^[ \t]*#(?:[^\n]|(?<=\\)\n)*|\"[^\"\n]*\"",
                      re.DOTALL | re.MULTILINE)
_ASSEMBLY = re.compile(r"__asm__\([^;]*;|__attribute__\(\((?:[^()]|\([^()]*\))*\)\)|"
                       r"(?:__extension__ _S|s)tatic_assert\([^;]*;")
_BRACKETS = re.compile(r"\[[^\[\]]*\]")
_PRODUCT = re.compile(r"(\S+) \*=? (\S+(?: \*)?)")  # of more factors, the second is none
_SINGLE = r"-?(?:\(double\)\w[\w.>-]*|(\d[\d.]*(?:e[-+]?\d+)?))"
_FACTORS = re.compile(rf"(?:^|\(){_SINGLE}$"), re.compile(rf"^{_SINGLE}\)*$")
_HALVES = re.compile(r"(?:low|high|cross[12]) = a_(?:high|low) \* b_(?:high|low)$|zero = a \* b$")
_MACRO = "return a * b"  # KSL_MUL where it is a function
_INTEGERS = re.compile(r"\b(?:stride|[ab]_stride|axes\.[xyz]|sizeof)\b")


def wrong(text: str) -> Iterator[str]:
    """The products without KSL_MUL that may be inexact, in the expression around each."""
    for piece in re.split(r"[;{},]", _REMOVED.sub("", text)):
        expression = " ".join(piece.split())
        while _BRACKETS.search(expression):
            expression = _BRACKETS.sub("", expression)
        known = expression == _MACRO or _INTEGERS.search(expression) or _HALVES.search(expression)
        if not known and not all(map(_is_exact, _PRODUCT.finditer(expression))):
            yield expression


def _is_exact(product: re.Match[str]) -> bool:
    """Returns whether this is a product, in double, of two numbers of single precision."""
    factors = [pattern.search(x) for pattern, x in zip(_FACTORS, product.groups(), strict=True)]
    return all(x is not None and (not x[1] or float(np.float32(x[1])) == float(x[1]))
               for x in factors)


@pytest.mark.parametrize("name", all_headers.AMALGAMATIONS)
def test_no_product_of_the_library_could_be_fused(name: str):
    text = (all_headers.c_folder() / name).read_text(encoding="utf-8")
    assert "KSL_MUL" in text
    assert list(wrong(text)) == []


class Fused(c_ast.NodeVisitor):
    """The sums and results of a file that a bare product reaches: in an expression, or through a
    variable, a sign, a size, a choice."""

    def __init__(self) -> None:
        self.texts: list[str] = []
        self.products: set[str] = set()

    def visit_FuncDef(self, node: c_ast.FuncDef) -> None:
        self.products = set()
        self.generic_visit(node)

    def visit_Decl(self, node: c_ast.Decl) -> None:
        if node.init is not None and self.is_product(node.init):
            self.products.add(node.name)

    def visit_Assignment(self, node: c_ast.Assignment) -> None:
        if self.is_product(node.rvalue):
            self.texts.append(CGenerator().visit(node))

    def is_product(self, node: c_ast.Node) -> bool:
        """Returns whether the value is a product that is not rounded separately; collects sums of
        such products."""
        if isinstance(node, c_ast.ID):
            return node.name in self.products
        if isinstance(node, c_ast.Cast):
            return self.is_product(node.expr)
        if isinstance(node, c_ast.UnaryOp):
            return self.is_product(node.expr)
        if isinstance(node, c_ast.TernaryOp):
            self.is_product(node.cond)
            return self.is_product(node.iftrue) | self.is_product(node.iffalse)
        if isinstance(node, c_ast.BinaryOp):
            reaches = self.is_product(node.left) | self.is_product(node.right)
            if reaches and (node.op in "+-" or node.op == "*" and _is_two(node)):
                self.texts.append(CGenerator().visit(node))
            return node.op == "*"
        if isinstance(node, c_ast.FuncCall) and node.args is not None:
            for argument in node.args:
                if isinstance(argument, c_ast.BinaryOp) and node.name.name == "RN":
                    self.is_product(argument.left)
                    self.is_product(argument.right)
                elif self.is_product(argument) and node.name.name.startswith("fabs"):
                    return True
        return False


def _is_two(node: c_ast.BinaryOp) -> bool:
    """Returns whether one factor is 2: compilers make a sum of that product."""
    return any(isinstance(x, c_ast.Constant) and float(x.value.rstrip("f")) == 2
               for x in (node.left, node.right))


_WORDS = {"KSL_COLD": "", "KSL_INLINED": "inline", "KSL_INLINE": "inline",
          "COSCREW_UNROLLED": ""}
_TYPES = "typedef unsigned long uint64_t; typedef unsigned int uint32_t;\n"


def fused(text: str) -> list[str]:
    """Places where a product could be fused into a sum."""
    visitor = Fused()
    plain = _ASSEMBLY.sub("", _REMOVED.sub("", text))
    for word, meaning in _WORDS.items():
        plain = plain.replace(word, meaning)
    visitor.visit(CParser().parse(_TYPES + plain))
    return visitor.texts


ERRORS = "#if defined(COSCREW_RUNTIME_ERRORS)"
"""Stands above the part of the shared header that serves accurate tiers."""


@pytest.mark.parametrize("name", SCENES)
def test_no_product_of_a_scene_reaches_a_sum(name: str):
    text = scene_c.files(SCENES[name](), BANNER)
    runtime, _, errors = text[scene_c_runtime.NAME].partition(ERRORS)
    assert "products are exact" in errors  # of halves: fused or not, they give the same bits
    assert "#pragma STDC FP_CONTRACT OFF" in runtime
    for path in text:
        if path.endswith(".c"):
            assert fused(runtime + text[path]) == []


@pytest.mark.parametrize("body", [
    "const double x = a * b + c;", "const double p = a * b, x = c - p;", "r[0] = a * b;",
    "const double p = -(a * b), q = a < b ? p : c, x = q + a;", "const double x = 2.0 * (a * b);",
    "const double x = fabs(a * b) + c;",
    "const double x = RN((a * b + c) * a);", "const double x = sin(a * b + c);",
    "s->x = a * b;"])
def test_what_could_be_fused_would_be_noticed(body: str):
    assert len(fused(f"void f(double a, double b, double c) {{ {body} }}")) == 1


@pytest.mark.parametrize("body", [
    "const double x = RN(a * b) + c;", "r[0] = RN(a * b);", "const double x = a * b * c;",
    "const double p = a * b, x = sin(p), y = x + c;", "const double x = RN((a + b) * c) - a;",
    "const double x = (a * b) / c + a;", "int i = a * b < c; r[0] = RN(2.0 * a);"])
def test_what_cannot_be_fused_is_right(body: str):
    assert fused(f"void f(double a, double b, double c) {{ {body} }}") == []


@pytest.mark.parametrize("text", [
    "  w[i] = half * kv1[i];", "v[i] += h * a[i];", "f(x, a + b * c);",
    "const double k = *t, twice = 2 * k;", "a *= b;", "const double x = a[i + 1] * b,\n    y = c;",
    "angles->x = x + whole * ceil(y);", "x = 0.1 * (double)a;", "x = (double)a * b;",
    "x = a < b ? a * b : c;", "x = KSL_MUL(a * b, c);", "x = 1.5e-10 * (double)a + c;",
    "x = (double)a * 2.5 * (double)b;", "x = f((double)a * b->m0);", "return a * b + c;"])
def test_a_product_that_could_be_fused_would_be_noticed(text: str):
    assert len(list(wrong(text))) == 1


@pytest.mark.parametrize("text", [
    "x = KSL_MUL(a, b);", "/* a * b + c */ x = -a + b, y = c - d;", "x = (double)a * (double)b;",
    "x = 0.5 * (double)a->m01 + c;", "x = KSL_MUL(a + b - c, d) - KSL_MUL(a, b);",
    "x = ksl_product_sum(0.5, (double)b, c + (double)a->m1 * (double)b->h.x);",
    "#define KSL_MUL(a, b) \\\n  ((a) * (b))\nint x;", "const double *t = a + 1;",
    "x = a[i * 3 + j];",
    "swap(a + i * a_stride, b);", "y = a < b ? -c : c;"])
def test_what_is_rounded_or_exact_is_right(text: str):
    assert not list(wrong(text))
