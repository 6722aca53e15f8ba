"""What the emitted text of each tier computes is identically its operation's truth.

In exact arithmetic rounding errors are zero, so a compensated kernel must reduce to the formula; and
when each result whose error it computes is off by some h, its own must be off by h² only.  C is read
here as the few forms it has: `const double a = …, b = …;`, `out->m0 = …;`, `return …;`.
"""

import random
import re
from collections.abc import Callable, Sequence
from fractions import Fraction

import pytest
import sympy as sp

import coscrew.accurate
from coscrew_codegen.exact import exact_functions
from coscrew_codegen.operations import Operation
from coscrew_codegen.quantity import Argument
from coscrew_codegen.targets.c import c_name, member, returned
from coscrew_codegen.targets.precision import PRECISIONS, Precision
from tests.attack import TIERED
from tests.c_reader import INCLUDE

EXACTLY = {
    "ksl_sum_error": lambda a, b, s: a + b - s, "ksl_difference_error": lambda a, b, s: a - b - s,
    "ksl_product_error": lambda a, b, p: a * b - p, "fma": lambda a, b, c: a * b + c,
    "fmaf": lambda a, b, c: a * b + c,
}
TEXT = {tier: "".join(path.read_text() for path in INCLUDE.glob(f"*_{tier}.h"))
        for tier in ("fused", "accurate")}

operations = pytest.mark.parametrize("operation", TIERED, ids=lambda op: op.name)
precisions = pytest.mark.parametrize("precision", PRECISIONS, ids=lambda p: p.name)
tiers = pytest.mark.parametrize("tier", TEXT)


def body(operation: Operation, precision: Precision, tier: str) -> str:
    """The text between the braces of the operation's function."""
    name = f"{c_name(operation.name, precision)}_{tier}"
    return re.search(rf"\b{name}\([^)]*\) {{\n(.*?)\n}}\n", TEXT[tier], re.DOTALL)[1]


def names(argument: Argument) -> list[str]:
    """How the text names the argument's components, as Python identifiers."""
    return [identifier(f"{argument.name}{member(argument.quantity, i).replace('.', '->')}")
            for i in range(argument.quantity.size)]


def identifier(text: str) -> str:
    """D->m03, M->at[1][2], dc[0] as identifiers; casts and the f of literals removed."""
    text = re.sub(r"\((double|float)\)", "", text)
    text = re.sub(r"(?<!\w)(\d+\.\d+)f", r"\1", text)
    text = re.sub(r"(\w+)->(\w+)", r"\1__\2", text)
    return re.sub(r"(?<=\w)\[(\d)\](?:\[(\d)\])?", r"_\1\2", text)


def evaluated(text: str, operation: Operation, inputs: Sequence[object],
              errors: Callable[[], object] = int,
              largest_error: Fraction | None = None) -> tuple[object, ...] | None:
    """Run the body on these input components; `errors` gives the error of each result that has its
    error computed.  None if a computed error is larger than the largest."""
    memory: dict[str, object] = dict(EXACTLY)
    components = iter(inputs)
    for argument in operation.inputs:
        memory |= {name: next(components) for name in names(argument)}
    compensated = set(re.findall(r"_error\([^()]*, (\w+)\)", text))
    result = None
    for statement in filter(None, (part.strip() for part in text.split(";"))):
        statement = identifier(re.sub(r"\s+", " ", statement))
        if statement.startswith("return "):
            result = eval(statement.removeprefix("return "), memory)
            continue
        for assignment in re.split(r", (?=\w+ = )", re.sub(r"^const (double|float) ", "", statement)):
            exec(assignment, memory)
            name = assignment.split(" ")[0]
            if name in compensated:
                memory[name] += errors()
            if largest_error and re.match(r"\w+ = ksl", assignment):
                if abs(memory[name]) > largest_error:
                    return None
    if returned(operation):
        return (result,)
    return tuple(memory[name] for argument in operation.outputs for name in names(argument))


def is_truth(found: tuple[sp.Expr, ...], operation: Operation) -> bool:
    return all(sp.expand(x - y) == 0 for x, y in zip(found, operation.truth(), strict=True))


@tiers
@precisions
@operations
def test_c_is_its_truth(operation: Operation, precision: Precision, tier: str):
    symbols = [symbol for a in operation.inputs for symbol in a.symbols]
    assert is_truth(evaluated(body(operation, precision, tier), operation, symbols), operation)


def first_order_error(text: str, operation: Operation) -> bool:
    """Whether errors of size h in the results that are compensated leave errors of that order."""
    numbers, h = random.Random(operation.name), Fraction(1, 10**30)
    inputs = [Fraction(numbers.randrange(1, 1000), 8)
              for a in operation.inputs for _ in range(a.quantity.size)]
    found = evaluated(text, operation, inputs, lambda: h * numbers.randrange(1, 1000),
                      largest_error=h * 10**9)
    return found is None or any(abs(x - exact(*inputs)) > h / 10**9
               for x, (exact, _) in zip(found, exact_functions(operation), strict=True))


@tiers
@operations
def test_a_flipped_sign_is_noticed(operation: Operation, tier: str):
    text = body(operation, PRECISIONS[0], tier)
    assert not first_order_error(text, operation)
    for sign in re.finditer(r"(?<= )[+-](?= )|(?<=fma\()-|(?<=, )-(?=\w)", text):
        flipped = text[:sign.start()] + {"+": "-", "-": "+"}[sign[0]] + text[sign.end():]
        assert first_order_error(flipped, operation), flipped


@precisions
@operations
def test_python_is_its_truth(operation: Operation, precision: Precision,
                             monkeypatch: pytest.MonkeyPatch):
    kernel: Callable = getattr(getattr(coscrew.accurate, precision.name), operation.name).__wrapped__
    for name in ("sum_error", "difference_error", "product_error"):
        if name in kernel.__globals__:
            monkeypatch.setitem(kernel.__globals__, name, EXACTLY[f"ksl_{name}"])
    found = kernel(*(a.symbols if a.quantity.shape else a.value for a in operation.inputs))
    assert is_truth(found if isinstance(found, tuple) else (found,), operation)
