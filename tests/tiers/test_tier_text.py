"""The emitted text of each tier is identically its operation's formula.

In exact arithmetic rounding errors are zero, so a compensated kernel must reduce to the formula;
and if each result whose error it computes is off by some h, the kernel's result must be off only by
order h². A sum hi + lo, which corrects its own error whatever that is, must have no other error to
correct.
A certified bound must be C S, and C the number of roundings, except for the part that covers
underflow.  C is read here as the few forms it has: `const double a = …, b = …;`, `out->m0 = …;`,
`return …;`.
"""

import ast
import operator
import random
import re
from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import cache
from itertools import islice
from math import ceil
from types import CodeType

import pytest
import sympy as sp
from sympy import QQ
from sympy.external.gmpy import MPQ
from sympy.polys.rings import PolyElement

import coscrew.accurate
from coscrew_codegen.accuracy.tiers import MARKED, tier_named
from coscrew_codegen.algebra.exact import exact_functions
from coscrew_codegen.algebra.operations import Operation
from coscrew_codegen.backends.c.c_operations import c_name, member, returned
from coscrew_codegen.program import scales
from coscrew_codegen.program.values.formats import PRECISIONS, Precision
from coscrew_codegen.program.values.quantity import Argument
from tests.support.cases import for_all
from tests.support.compiled.c_reader import INCLUDE
from tests.support.truth.attack import TIERED, bounds, plain_program

EXACTLY = {
    "ksl_product_error": lambda a, b, p: a * b - p,
    "ksl_product_sum": lambda a, b, c: a * b + c,
    "ksl_product_rest": lambda a, b, p, h: a * b - h,
    "KSL_MUL": operator.mul, "KSL_MULF": operator.mul,
    "exactly": lambda x: QQ(*Fraction(x).as_integer_ratio()),
    "fabs": lambda x: x if isinstance(x, PolyElement) else abs(x),  # in bounds alone
    "fma": lambda a, b, c: a * b + c,
}
EXACTLY |= {f"{name}f": EXACTLY[name] for name in ("fabs", "fma")}
# Results that have their error computed: p of product_error(…, p) and product_rest(…, p, h), and
# sums from which a summand's share is taken.
COMPENSATED = re.compile(r"_error\([^()]*, (\w+)\)|_rest\([^()]*, (\w+), \w+\)|(\w+)_right =")
NORMALIZED = re.compile(r"(\w+_sum)_right =")  # sums hi + lo that take their place
ERROR = re.compile(r"\w+_(error|rest|lo\d?) = ")
TEXT = {tier.name: "".join(path.read_text() for path in INCLUDE.glob(f"*_{tier.name}.h"))
        for tier in MARKED}
FUNCTION = re.compile(r"\b(ksl_\w+)\([^)]*\) {\n(.*?)\n}\n", re.DOTALL)
BODIES = {match[1]: match[2] for text in TEXT.values() for match in FUNCTION.finditer(text)}

MOST_SIGNS = 30  # flipped in a text

TAU = sp.Symbol("tau")  # added for underflow

operations = pytest.mark.parametrize("operation", TIERED, ids=lambda op: op.name)


def spread(matches: Sequence[re.Match]) -> Sequence[re.Match]:
    """All of them or, of many, MOST_SIGNS or fewer, evenly spread."""
    return matches[::-(-len(matches) // MOST_SIGNS) or 1]


def body(operation: Operation, precision: Precision, tier: str) -> str:
    """The text between the braces of the operation's function."""
    text = BODIES[f"{c_name(operation.name, precision)}_{tier}"]
    if operation.by_value:  # as if by address
        passed = "|".join(a.name for a in (*operation.inputs, *operation.outputs)
                          if a.quantity.shape)
        text = re.sub(rf"\b({passed})\.", r"\1->", text)
        text = re.sub(rf" *(ksl_\w+_t|return) ({passed});\n?", "", text)
    return text


def names(argument: Argument) -> list[str]:
    """The names of the argument's components in the text, as Python identifiers."""
    return [identifier(f"{argument.name}{member(argument.quantity, i).replace('.', '->', 1)}")
            for i in range(argument.quantity.size)]


def identifier(text: str) -> str:
    """D->m03, B->h.x, M->at[1][2], dc[0] as identifiers; casts removed, literals exact."""
    text = re.sub(r"\((double|float)\)", "", text)
    text = re.sub(r"(?<![\w.])(\d+\.\d*(?:e[-+]?\d+)?|\d+e[-+]?\d+)f?\b", r"exactly(\1)", text)
    text = re.sub(r"(\w+)->(\w+)(?:\.([xyz]))?", r"\1__\2\3", text)
    return re.sub(r"(?<=\w)\[(\d)\](?:\[(\d)\])?", r"_\1\2", text)


def made(operation: Operation, tier: str) -> Operation:
    """The operation as the tier has it: a certified one has bounds among its outputs."""
    return tier_named(tier).operation(operation)


def evaluated(text: str, operation: Operation, inputs: Sequence[object],
              errors: Callable[[], object] = int, largest_error: MPQ | None = None,
              normalized: bool = True) -> tuple[object, ...] | None:
    """Run the body on these input components; `errors` gives the error of each result that has its
    error computed, of sums hi + lo if `normalized`.  None if a computed error is larger than the
    largest, or one of a sum that has none."""
    within: list[bool] = []

    def error(x: MPQ, of: str) -> MPQ:
        most = 0 if of in exact else largest_error
        within.append(largest_error is None or abs(x) <= most)
        return x

    memory: dict[str, object] = {**EXACTLY, "error": error}
    components = iter(inputs)
    for argument in operation.inputs:
        memory |= {name: next(components) for name in names(argument)}
    compensated = {name for names in COMPENSATED.findall(text) for name in names if name}
    exact = () if normalized else NORMALIZED.findall(text)
    for name, code, is_error in (x for part in text.split(";") for x in assignments(part)):
        exec(code, memory)
        if name in compensated and name not in exact:
            memory[name] += errors()
        if name.removesuffix("_lo") in exact and name not in exact and memory[name]:
            return None
        if largest_error and is_error and abs(memory[name]) > largest_error:
            return None
    if not all(within):
        return None
    value = returned(operation)
    return tuple(memory["returned"] if argument == value and not operation.by_value
                 else memory[name] for argument in operation.outputs for name in names(argument))


@cache
def assignments(statement: str) -> tuple[tuple[str, CodeType, bool], ...]:
    """The assignment of a C statement, as Python: the name, and whether it is an error."""
    text = identifier(re.sub(r"\s+", " ", statement.strip()))
    text = re.sub(r"^return ", "returned = ", re.sub(r"^const (double|float) ", "", text))
    each = [x.lstrip("*") for x in re.split(r", (?=\w+ = )", text) if x]
    return tuple((x.split(" ")[0], compile(_Nested().visit(ast.parse(x)), "C", "exec"),
                  bool(ERROR.match(x))) for x in each)


class _Nested(ast.NodeTransformer):
    """Writes error(x, "s") for each x in an expression that is a summand's share of the error of
    s: a - (s - s_right), b - s_right, ksl_product_rest(…)."""

    def visit_BinOp(self, node: ast.BinOp) -> ast.AST:
        self.generic_visit(node)
        right = node.right if not _is_left(node.right) else node.right.right
        shared = isinstance(right, ast.Name) and right.id.endswith("_right") and not _is_left(node)
        return _error(node, right.id.removesuffix("_right")) if shared else node

    def visit_Call(self, node: ast.Call) -> ast.AST:
        self.generic_visit(node)
        return _error(node, "") if ast.unparse(node.func).startswith("ksl_product_rest") else node


def _error(node: ast.expr, of: str) -> ast.expr:
    call = ast.Call(ast.Name("error", ast.Load()), [node, ast.Constant(of)], [])
    return ast.fix_missing_locations(ast.copy_location(call, node))


def _is_left(node: ast.expr) -> bool:
    """Returns whether this is s - s_right, or s + s_right."""
    return (isinstance(node, ast.BinOp) and isinstance(node.left, ast.Name)
            and ast.unparse(node.right) == f"{node.left.id}_right")


@cache
def polynomials(operation: Operation) -> tuple[tuple[PolyElement, ...], tuple[PolyElement, ...]]:
    """All input components, and the truth, as polynomials over the rationals."""
    symbols = [symbol for a in operation.inputs for symbol in a.symbols]
    ring, *variables = sp.ring(symbols, QQ)
    return tuple(variables), tuple(map(ring.from_expr, operation.truth()))


def is_truth(results: Sequence[PolyElement], operation: Operation) -> bool:
    _, truth = polynomials(operation)
    return all(y - x == 0 for x, y in zip(results, truth, strict=True))


class Size:
    """A sum of absolute values: a polynomial in those of the inputs and, last, τ, by arithmetic
    that ignores signs."""

    def __init__(self, value: PolyElement):
        self.value = value

    def __add__(self, other: "Size | MPQ") -> "Size":
        if isinstance(other, Size):
            return Size(self.value + other.value)
        return Size(self.value + (self.value.ring.gens[-1] if 0 < other < 1e-20 else abs(other)))

    def __mul__(self, other: "Size") -> "Size":
        return Size(self.value * other.value)

    def __rmul__(self, constant: MPQ) -> "Size":
        return Size(self.value * constant)

    def __abs__(self) -> "Size":
        return self

    __sub__ = __radd__ = __rsub__ = __add__
    __neg__ = __abs__


@operations
@for_all(precision=PRECISIONS)
def test_a_certified_bound_is_a_multiple_of_the_terms(operation: Operation, precision: Precision):
    """C S for τ = 0; C / u is plain's c1 and the last rounding, and hardly more.  Where products
    are summed, something is left for all inputs 0."""
    u = QQ(1, 2**precision.digits)
    symbols = [symbol for a in operation.inputs for symbol in a.symbols]
    ring, *variables = sp.ring([*symbols, TAU], QQ)
    results = evaluated(body(operation, precision, "certified"), made(operation, "certified"),
                        list(map(Size, variables[:-1])))
    plain_bounds = bounds(operation, precision, "plain")
    for bound, (_, terms), plain in zip(results[len(results) // 2:], exact_functions(operation),
                                        plain_bounds, strict=True):
        S = ring(terms(*variables[:-1]))
        if not plain.rounded:
            assert bound == 0
            continue
        of_terms = ring.from_dict({m: c for m, c in bound.value.terms() if not m[-1]})
        C = of_terms.LC / S.LC
        # Scalings are counted as roundings.
        scalings = 2 * any(map(scales, plain_program(operation).instructions))
        most = ceil(plain.c1) + 1 + scalings  # c1 may be a mean over equal monomials
        assert of_terms == S * C
        assert (QQ(*plain.c1.as_integer_ratio()) + 1) * u < C < most * u * (1 + 16 * u)
        assert of_terms != bound.value or all(len(m) == 1 for m in plain.terms)


@operations
@for_all(precision=PRECISIONS, tier=TEXT)
def test_c_is_its_truth(operation: Operation, precision: Precision, tier: str):
    variables, truth = polynomials(operation)
    results = evaluated(body(operation, precision, tier), made(operation, tier), variables)
    assert is_truth(results[:len(truth)], operation)


def first_order_error(text: str, operation: Operation) -> bool:
    """Returns whether errors of size h in the results that are compensated leave errors of that
    order."""
    numbers, h = random.Random(operation.name), QQ(1, 10**30)
    inputs = [QQ(numbers.randrange(1, 1000), 8)
              for a in operation.inputs for _ in range(a.quantity.size)]
    for normalized in (True, False) if NORMALIZED.search(text) else (True,):
        results = evaluated(text, operation, inputs, lambda: h * numbers.randrange(1, 1000),
                            h * 10**9, normalized)
        if results is None or any(abs(x - exact(*inputs)) > h / 10**9 for x, (exact, _) in
                                  zip(results, exact_functions(operation), strict=True)):
            return True
    return False


@operations
def test_a_flipped_sign_in_a_bound_is_noticed(operation: Operation):
    """Any of them changes a result or a bound for positive inputs: of many, a part is tried."""
    text, numbers = body(operation, PRECISIONS[0], "certified"), random.Random(operation.name)
    inputs = [QQ(numbers.randrange(1, 1000), 8)
              for a in operation.inputs for _ in range(a.quantity.size)]
    right = evaluated(text, made(operation, "certified"), inputs)
    for sign in spread(list(re.finditer(r"(?<= )[+-](?= )", text))):
        flipped = text[:sign.start()] + {"+": "-", "-": "+"}[sign[0]] + text[sign.end():]
        assert evaluated(flipped, made(operation, "certified"), inputs) != right, flipped


@operations
def test_a_flipped_sign_is_noticed(operation: Operation):
    text = body(operation, PRECISIONS[0], "accurate")
    assert not first_order_error(text, operation)
    signs = re.finditer(r"(?<= )[+-](?= )|(?<=, )-(?=\w)", text)
    for sign in spread(list(signs)):
        flipped = text[:sign.start()] + {"+": "-", "-": "+"}[sign[0]] + text[sign.end():]
        assert first_order_error(flipped, operation), flipped


@for_all(operation=TIERED, precision=PRECISIONS)
def test_python_is_its_truth(operation: Operation, precision: Precision,
                             monkeypatch: pytest.MonkeyPatch):
    kernels = getattr(coscrew.accurate, precision.name)
    kernel: Callable = getattr(kernels, operation.name).__wrapped__
    for name in ("product_error", "product_rest"):
        if name in kernel.__globals__:
            monkeypatch.setitem(kernel.__globals__, name, EXACTLY[f"ksl_{name}"])
    variables = iter(polynomials(operation)[0])
    results = kernel(*(tuple(islice(variables, a.quantity.size)) if a.quantity.shape
                       else next(variables) for a in operation.inputs))
    assert is_truth(results if isinstance(results, tuple) else (results,), operation)
