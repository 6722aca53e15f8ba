"""Bounds of the instructions of pairs hi + lo, one by one.

Each number x has three properties: a bound of its size, a bound of its rounding error 'x = exact -
x, and a polynomial in earlier numbers and rounding errors that equals x.  The rounding error of hi
and its correction in lo cancel in these polynomials; the error of a pair is the rest.

    a ± b    at most the size of a or of b is lost, as both are numbers; nothing of the differences
             of Two-Sum (Knuth, Shewchuk), and of a sum whose exact value is what another sum lost
    a b      x = a b - 'x; so a b is x + 'x wherever it occurs
    a / b    x b = a - 'x b
    sin w    x = sin w - 'x, and its error function returns 'x to its own proved error"""

from collections.abc import Callable, Sequence
from fractions import Fraction
from math import prod

from coscrew_codegen.accuracy.rounding_rules import above
from coscrew_codegen.program import Op
from coscrew_codegen.program.elementary.sincos import FUNCTION as SINCOS
from coscrew_codegen.program.elementary.sincos_error import ERROR as SINCOS_ERROR
from coscrew_codegen.program.roundoff import CIRCULAR
from coscrew_codegen.program.values.formats import Precision

Monomial = tuple[str, ...]
"""The names of a product's factors, sorted."""
Polynomial = dict[Monomial, Fraction]
"""Coefficients by monomial."""
ONE: Polynomial = {(): Fraction(1)}
SUMS = {Op.ADD: Op.ADD, Op.EXACT_ADD: Op.ADD, Op.SUB: Op.SUB, Op.EXACT_SUB: Op.SUB}
"""Sums and differences, whatever is known of their roundings."""
ERRORS = {Op.SIN_ERROR: Op.SIN, Op.COS_ERROR: Op.COS}


def monomial(*names: str) -> Polynomial:
    """The product of these numbers."""
    return {tuple(sorted(names)): Fraction(1)}


def plus(f: Polynomial, g: Polynomial, factor: int = 1) -> Polynomial:
    """f + factor g."""
    result = dict(f)
    for key, x in g.items():
        if total := result.get(key, Fraction(0)) + factor * x:
            result[key] = total
        else:
            del result[key]
    return result


class PairInstructions:
    """The instructions of a program so far, in a precision; operands are names, inputs and
    constants."""

    def __init__(self, precision: Precision) -> None:
        self.precision, self.u, self.eta = precision, precision.u, precision.eta
        self.sizes: dict[str, Fraction] = {}
        self.forms: dict[str, Polynomial] = {}
        self.sine, self.rest = SINCOS.error(precision), above(SINCOS_ERROR.error(precision))
        self._equal: dict[Monomial, Polynomial] = {}
        self._sums: dict[str, tuple[Op, str, str]] = {}
        self._shares: dict[str, tuple[str, str]] = {}  # a sum, and the operand whose share it is

    def add_number(self, name: str, size: Fraction) -> None:
        """Adds an input or a constant, up to this size."""
        self.sizes[name], self.forms[name] = size, monomial(name)

    def times(self, f: Polynomial, g: Polynomial = ONE) -> Polynomial:
        """The product of two polynomials, in the fewest numbers."""
        result: Polynomial = {}
        for key, x in f.items():
            for other, y in g.items():
                both = tuple(sorted(key + other))
                known = self._equal.get(both, {both: Fraction(1)})
                result = plus(result, {k: z * x * y for k, z in known.items()})
        return result

    def bound(self, f: Polynomial) -> Fraction:
        """Bounds the size of a polynomial."""
        return sum((abs(x) * prod((self.sizes[y] for y in key), start=Fraction(1))
                    for key, x in f.items()), Fraction(0))

    def circular(self, op: Op, x: str) -> Polynomial:
        """The exact sine or cosine of a number, as a number of known size."""
        word, one = f"{op.value} {x}", Fraction(1)
        self.sizes[word] = one if op is Op.COS else min(self.sizes[x], one)
        return monomial(word)

    def add_instruction(self, op: Op, name: str, operands: Sequence[str], least: Fraction,
                        inside: Callable[[Polynomial], Fraction] | None) -> tuple[float, float]:
        """Adds an instruction; returns bounds of the size and the rounding error of its result.
        `least` bounds a divisor from below; `inside` bounds a polynomial by its distance from a
        value of known size."""
        for x in operands:
            if x not in self.forms:
                self.add_number(x, abs(Fraction(x)))
        exact, form, top = self._exact(op, name, operands)
        if op is Op.DIV:
            top = self.sizes[operands[0]] / least
        else:
            top = min(top, self.bound(form), *([inside(form)] if inside else []))
        lost = Fraction(above(self._lost(op, operands, exact, top)))
        most = min(top + lost, self._most_computed(op, operands, top + lost, top))
        self.sizes[name], self.sizes[f"'{name}"] = Fraction(above(most)), lost
        self._keep(op, name, operands, form, lost)
        return above(most), above(lost)

    def _exact(self, op: Op, name: str, operands: Sequence[str]
               ) -> tuple[bool, Polynomial, Fraction]:
        """Returns whether nothing is lost, the exact value, and a bound of its size."""
        a, b = operands[0], operands[-1]
        f, g = self.forms[a], self.forms[b]
        if op in SUMS:
            form = plus(f, g, 1 if SUMS[op] is Op.ADD else -1)
            return self._is_exact(SUMS[op], name, a, b, form), form, self.sizes[a] + self.sizes[b]
        if op is Op.MUL:
            return False, self.times(f, g), self.sizes[a] * self.sizes[b]
        if op in (Op.PRODUCT_ERROR, Op.PRODUCT_REST):
            form = plus(self.times(f, self.forms[operands[1]]), g, -1)
        elif op in CIRCULAR or op in ERRORS:
            form = plus(self.circular(ERRORS.get(op, op), a), g if op in ERRORS else {}, -1)
        elif op is Op.NEG:
            form = plus({}, f, -1)
        else:
            assert op is Op.DIV, op
            return False, monomial(name), Fraction(0)
        return op is Op.NEG, form, self.bound(form)

    def _is_exact(self, op: Op, name: str, a: str, b: str, form: Polynomial) -> bool:
        """Returns whether a sum is known to lose nothing."""
        none = (op, "", "")
        of_a, of_b = self._sums.get(a, none), self._sums.get(b, none)
        share, left = self._shares.get(b, ("", "")), False
        if share == (a, of_a[2]) and op is not of_a[0]:
            self._shares[name], left = (a, of_a[1]), True
        elif op is Op.SUB and of_a[:2] == (Op.ADD, b):
            self._shares[name] = a, of_a[2]
        elif op is Op.SUB and of_b[:2] == (Op.SUB, a):
            self._shares[name] = b, of_b[2]
        self._sums[name] = op, a, b
        lost = [key for key, x in form.items() if abs(x) == 1 and key[0][1:] in self._sums
                and key[0][0] == "'"]
        return left or op is Op.SUB and share[1] == a or len(lost) == len(form) == 1

    def _lost(self, op: Op, operands: Sequence[str], exact: bool, top: Fraction) -> Fraction:
        """Bounds what is lost of a value up to `top`."""
        if exact:
            return Fraction(0)
        sizes = [self.sizes[x] for x in operands]
        if op in CIRCULAR or op in ERRORS:
            size = self.sizes[f"{ERRORS.get(op, op).value} {operands[0]}"]
            return Fraction(self.rest) * size + 2 * self.eta if op in ERRORS else \
                self.sine * max(self.u * min(Fraction(1), 2 * size), 2 * self.eta)
        if op is Op.PRODUCT_ERROR or op is Op.MUL and any(
                x[0] in "-0123456789" and y == _below(2 * y)
                for x, y in zip(operands, sizes, strict=True)):
            return self.eta
        half = max(self.u * _below(top), self.eta) if top else Fraction(0)
        return min(half, *sizes) if op in SUMS else half

    def _most_computed(self, op: Op, operands: Sequence[str], otherwise: Fraction, top: Fraction
                       ) -> Fraction:
        """Bounds the rounded number."""
        if op in CIRCULAR:
            return Fraction(1)
        if op in ERRORS or not top:
            return otherwise
        unit = 2 * max(self.u * _below(top), self.eta)
        return -(-top // unit) * unit

    def _keep(self, op: Op, name: str, operands: Sequence[str], form: Polynomial, lost: Fraction
              ) -> None:
        """Keeps what a number equals."""
        rest = monomial(f"'{name}")
        if op is Op.DIV:
            a, b = operands
            self.forms[name] = form
            self._equal[tuple(sorted((name, b)))] = plus(
                self.forms[a], monomial(f"'{name}", b), -1)
        elif op is Op.MUL and len(form) == 1 and abs(next(iter(form.values()))) == 1:
            (key, sign), = form.items()
            self._equal[key] = {(name,): sign, (f"'{name}",): sign}
            self.forms[name] = monomial(name)
        else:
            self.forms[name] = plus(form, rest, -1) if lost else form

    def as_value(self, names: Sequence[str], most: Fraction) -> Polynomial:
        """The sum of these numbers, which stands for a value and is at most `most`; from here on
        they are new numbers, whose own polynomials are forgotten."""
        more = sum((self.sizes[x] for x in names[1:]), Fraction(0))
        self.sizes[names[0]] = min(self.sizes[names[0]], most + more)
        self.forms |= {x: monomial(x) for x in names}
        return {(x,): Fraction(1) for x in names}


def _below(x: Fraction) -> Fraction:
    """The largest power of two below x."""
    power = Fraction(2)**(x.numerator.bit_length() - x.denominator.bit_length())
    return power if power < x else power / 2
