"""A-priori error bounds of a Program, by tracking each rounding to the results.

Every rounding is x̂ = x (1 + δ), |δ| <= u.  In a program of +, -, × each result is a polynomial in
the inputs and the δ, which is expanded exactly up to second order in the δ:

- first order: Σ |terms in one δ| <= c1 u S,
- second order, where the first cancels (compensated programs): <= c2 u² S,

where S is the sum of the absolute values of the terms of the exact result's expanded polynomial.
The last rounding is treated separately, since its error is relative to the result: |x̂ - x| <= u
|x̂| + c1 u S (1 + O(u)). The rounding errors that compensated programs compute are themselves terms
in δ, so that the corrections cancel here as they do in the program.

A wide program computes single-precision results in double, whose u is 2^-5 times the square of
single's: its first order counts as second.  Valid barring overflow and underflow."""

from collections import defaultdict
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cache

from coscrew_codegen.program import Constant, Input, Instruction, Op, Operand, Program, Ref, scales
from coscrew_codegen.program.interpreter import Arithmetic, evaluate
from coscrew_codegen.program.program import is_rounded

Monomial = tuple[Input, ...]  # sorted; a power repeats its variable
Number = int | Fraction  # most coefficients are whole numbers; as int they are many times faster
Polynomial = Mapping[Monomial, Number]
Deltas = tuple[int, ...]  # the roundings that a term is proportional to, by number; sorted


@dataclass(frozen=True)
class Bound:
    """|x̂ - x| <= u |x̂| + (c1 u + c2 u²) S; without u |x̂| unless the last operation is `rounded`.

    `terms` is the polynomial x; S is the same with absolute values throughout."""

    rounded: bool
    c1: Fraction
    c2: Fraction
    terms: Polynomial


@dataclass(frozen=True)
class _Series:
    """A value as a sum of polynomials, by the δ they are proportional to; () is the exact value."""

    terms: Mapping[Deltas, Polynomial] = field(default_factory=dict)

    def polynomial(self, deltas: Deltas) -> Polynomial:
        return self.terms.get(deltas, {})


@cache  # called for every language and precision
def bounds_of(program: Program) -> tuple[Bound, ...] | None:
    """A bound per result component; None unless the program is a polynomial with exact constants.
    """
    if any(step.op not in _RULES or any(map(is_rounded, step.operands))
           for step in program.instructions):
        return None
    inputs = [[_Series({(): {(Input(number, i),): 1}}) for i in range(argument.quantity.size)]
              for number, argument in enumerate(program.inputs)]
    values = evaluate(program, inputs, _SERIES)
    if program.wide:
        return tuple(map(_wide_bound, values))
    return tuple(_bound(value, _last_rounding(result, program))
                 for value, result in zip(values, program.results, strict=True))


def in_words(program: Program) -> str:
    """The bounds as the comments of kernels state them; empty if the program has none."""
    bounds = bounds_of(program)
    if bounds is None:
        return ""
    if not any(bound.rounded for bound in bounds):
        return "Exact."
    for order, unit in ((1, "u S"), (2, "u^2 S")):
        constants = [(bound.c1, bound.c2)[order - 1] for bound in bounds]
        if any(constants):
            return (f"Error <= u |result| + {_by_part(program, constants)} {unit}, S the sum of "
                    "the |terms| of the expanded formula; barring over- and underflow.")
    return "Error <= u |result|, barring over- and underflow."


def _by_part(program: Program, constants: list[Fraction]) -> str:
    """The largest constant; one for each part of the result if they differ."""
    largest: dict[str, Fraction] = {}
    remaining = iter(constants)
    for argument in program.outputs:
        for row, column in argument.quantity.indices:
            number, _ = argument.quantity.place(row, column)
            name = argument.quantity.parts[number].name
            largest[name] = max(largest.get(name, Fraction(0)), next(remaining))
    if len(set(largest.values())) == 1:
        return str(max(largest.values()))
    return f"({', '.join(f'{name}: {constant}' for name, constant in largest.items())})"


def _last_rounding(result: Operand, program: Program) -> int | None:
    """Number of the instruction that rounds the result last; negations and scalings are exact."""
    steps = {step.name: (number, step) for number, step in enumerate(program.instructions)}
    while isinstance(result, Ref):
        number, step = steps[result.name]
        if scales(step):
            result = next(x for x in step.operands if not isinstance(x, Constant))
        elif step.op.rounds:
            return number
        elif step.op is Op.NEG:
            result = step.operands[0]
        else:
            return None
    return None


def _bound(value: _Series, last: int | None) -> Bound:
    c1, c2 = (_constant(value, order, last) for order in (1, 2))
    return Bound(last is not None, c1, c2, value.polynomial(()))


_WIDER = Fraction(1, 32)  # u of double as a multiple of u² of single


def _wide_bound(value: _Series) -> Bound:
    computed = any(value.terms[deltas] for deltas in value.terms if deltas)
    return Bound(computed, Fraction(0), _constant(value, 1, None) * _WIDER, value.polynomial(()))


def _constant(value: _Series, order: int, last: int | None) -> Fraction:
    """max over monomials of Σ |error terms of this order| / |term of the exact value|."""
    exact = value.polynomial(())
    totals: dict[Monomial, Number] = defaultdict(int)
    for deltas, polynomial in value.terms.items():
        if len(deltas) == order and last not in deltas:
            for monomial, coefficient in polynomial.items():
                totals[monomial] += coefficient if coefficient > 0 else -coefficient
    return max((abs(Fraction(total) / exact[m]) if m in exact else _unbounded(m)
                for m, total in totals.items() if total), default=Fraction(0))


def _unbounded(monomial: Monomial) -> Fraction:
    raise ValueError(f"an error term in {monomial} that the exact value does not have")


def _exact(constant: Constant) -> _Series:
    value = constant.double
    number = value.numerator if value.denominator == 1 else value
    return _Series({(): {(): number}} if number else {})


def _applied(step: Instruction, number: int) -> Callable[..., _Series]:
    """The function that computes instruction `number`, whose rounding is the δ of that number."""
    if scales(step):
        return _product
    rule = _RULES[step.op]
    return lambda *operands: rule(operands, number)


def _combined(*scaled: tuple[int, _Series]) -> _Series:
    """Σ factor · series, for factors 1 and -1.  Most δ occur in one series only: its polynomials
    are kept, not copied."""
    sums: dict[Deltas, Polynomial] = {}
    for factor, series in scaled:
        for deltas, polynomial in series.terms.items():
            signed = polynomial if factor == 1 else {m: -c for m, c in polynomial.items()}
            sums[deltas] = _added(sums[deltas], signed) if deltas in sums else signed
    return _Series({deltas: polynomial for deltas, polynomial in sums.items() if polynomial})


def _added(a: Polynomial, b: Polynomial) -> Polynomial:
    """a + b without terms that are zero."""
    total = dict(a)
    for monomial, coefficient in b.items():
        total[monomial] = total.get(monomial, 0) + coefficient
    return {m: c for m, c in total.items() if c}


def _product(a: _Series, b: _Series) -> _Series:
    sums: dict[Deltas, dict[Monomial, Number]] = {}
    for x, p in a.terms.items():
        for y, q in b.terms.items():
            if len(x) + len(y) > 2:
                continue
            into = sums.setdefault(tuple(sorted(x + y)), defaultdict(int))
            for m, c in p.items():
                for n, d in q.items():
                    into[tuple(sorted(m + n))] += c * d
    return _Series({deltas: kept for deltas, polynomial in sums.items()
                    if (kept := {m: c for m, c in polynomial.items() if c})})


def _roundoff(value: _Series, number: int) -> _Series:
    """δ · value: the error that rounding `number` adds, up to second order."""
    return _Series({tuple(sorted((*deltas, number))): polynomial
                    for deltas, polynomial in value.terms.items() if len(deltas) < 2})


def _rounded(value: _Series, number: int) -> _Series:
    """value (1 + δ), with the δ of rounding `number`."""
    return _Series({**value.terms, **_roundoff(value, number).terms})


_RULES: Mapping[Op, Callable[[tuple[_Series, ...], int], _Series]] = {
    Op.ADD: lambda x, n: _rounded(_combined((1, x[0]), (1, x[1])), n),
    Op.SUB: lambda x, n: _rounded(_combined((1, x[0]), (-1, x[1])), n),
    Op.MUL: lambda x, n: _rounded(_product(x[0], x[1]), n),
    Op.NEG: lambda x, n: _combined((-1, x[0])),
    Op.EXACT_ADD: lambda x, n: _combined((1, x[0]), (1, x[1])),
    Op.EXACT_SUB: lambda x, n: _combined((1, x[0]), (-1, x[1])),
    Op.PRODUCT_ERROR: lambda x, n: _combined((1, _product(x[0], x[1])), (-1, x[2])),
    Op.PRODUCT_REST: lambda x, n: _rounded(_combined((1, _product(x[0], x[1])), (-1, x[3])), n),
}

_SERIES = Arithmetic(_exact, _applied)
