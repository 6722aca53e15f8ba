"""Norms and divisions by them, safe over the whole range of exponents.

Numbers are first multiplied by a power of two, exactly, so that squares neither overflow nor
underflow.  Thus a norm overflows only if it is itself too large, and loses digits only if it is
itself subnormal.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import sympy as sp

from coscrew_codegen.algebra.operations.operation import (
    CALM_LARGE,
    CALM_MODEST,
    CALM_TINY,
    ENLARGING,
    HALF_STEP,
    LARGE,
    MODEST,
    NORM_THRESHOLD,
    RAISING,
    REDUCING,
    STEPS,
    TINY,
    scaled,
)


@dataclass(frozen=True)
class Let:
    """let(name, value): the value, bound to the name.

    `fine` says that results are computed to twice the digits, so series need more terms and other
    formulas are better.  `smooth` says that they are differentiated, so 0/0 must be its limit even
    if it is multiplied by zero, and squares of intermediate results must not overflow."""

    bind: Callable[[str, sp.Expr | sp.Matrix], sp.Expr | sp.Matrix]
    fine: bool = False
    smooth: bool = False

    def __call__(self, name: str, value: sp.Expr | sp.Matrix) -> sp.Expr | sp.Matrix:
        return self.bind(name, value)



def l2(x: sp.Matrix) -> sp.Expr:
    """sqrt(x·x)."""
    return sp.sqrt(x.dot(x))


def leading_part(first: sp.Matrix, second: sp.Matrix) -> sp.Piecewise:
    """second·second where every |component of first| < threshold, else first·first."""
    return sp.Piecewise((second.dot(second), _small(first)), (first.dot(first), True))


def chosen_part(let: Let, first: sp.Matrix, second: sp.Matrix) -> sp.Matrix:
    """second where every |component of first| < threshold, else first."""
    small = sp.Eq(let("small", sp.Piecewise((1, _small(first)), (0, True))), 1)
    return let("p", sp.Matrix([sp.Piecewise((b, small), (a, True))
                               for a, b in zip(first, second, strict=True)]))


def _small(first: sp.Matrix) -> sp.Basic:
    return sp.And(*(sp.Abs(x) < NORM_THRESHOLD for x in first))


def nonzero(n: sp.Expr) -> sp.Piecewise:
    """n, or 1 where n = 0, so that dividing leaves a zero quantity zero."""
    return sp.Piecewise((sp.Integer(1), sp.Eq(n, 0)), (n, True))


def divided(x: sp.Matrix, n: sp.Expr) -> sp.Matrix:
    """x / n, component by component."""
    return x.applyfunc(lambda component: component / n)


def largest_size(let: Let, name: str, x: Sequence[sp.Expr]) -> sp.Expr:
    """The largest |component|."""
    largest, *sizes = let(f"{name}_size", sp.Matrix(x).applyfunc(sp.Abs))
    for number, size in enumerate(sizes, start=1):
        largest = let(f"{name}_largest{number}",
                      sp.Piecewise((size, largest < size), (largest, True)))
    return largest


def power_of_two(let: Let, name: str, x: Sequence[sp.Expr], reduced: bool = False) -> sp.Expr:
    """A power of two s such that s x suits norms and quotients by them (MODEST, LARGE); s >= 1 if
    x is `reduced` already."""
    tiny, modest, large = ((CALM_TINY, CALM_MODEST, CALM_LARGE) if let.smooth else
                           (TINY, MODEST, LARGE))
    largest = largest_size(let, name, x)
    reducing = () if reduced else ((REDUCING, largest > large),)
    return let(name, sp.Piecewise((RAISING, largest < tiny), (ENLARGING, largest < modest),
                                  *reducing, (sp.Integer(1), True)))


def stepwise_power(let: Let, name: str, largest: sp.Expr) -> sp.Expr:
    """A power of two s with 1 <= s largest < 2^40 (double 2^300); less only where `largest` is
    below 2^-120 (2^-900)."""
    first, second, third = STEPS
    return let(name, sp.Piecewise(
        (third, largest < 1 / second), (second, largest < 1 / first), (first, largest < 1),
        (sp.Integer(1), largest < first), (1 / first, largest < second),
        (1 / second, largest < third), (1 / third, True)))


def calm(let: Let, largest: sp.Expr) -> sp.Expr:
    """Chooses a stepwise power in the place of `largest`; for derivatives, a power that leaves
    entries around 1 unchanged."""
    return let("calm", scaled(largest, HALF_STEP)) if let.smooth else largest


def inverse_power(let: Let, name: str, s: sp.Expr, reduced: bool = False) -> sp.Expr:
    """1 / s for a power of two s."""
    large = () if reduced else ((1 / REDUCING, s < 1),)
    return let(name, sp.Piecewise((1 / RAISING, s > ENLARGING), (1 / ENLARGING, s > 1), *large,
                                  (sp.Integer(1), True)))


def moderate(let: Let, name: str, x: sp.Matrix) -> sp.Matrix:
    """x times a power of two, which changes no direction and no angle."""
    s = power_of_two(let, name, tuple(x))
    return let(f"scaled_{name}", x.applyfunc(lambda component: scaled(component, s)))


def safe_norm(let: Let, x: sp.Matrix, reduced: bool = False) -> sp.Expr:
    """|x|, without overflow or underflow of intermediate results."""
    s = power_of_two(let, "s", tuple(x), reduced)
    y = let("y", x.applyfunc(lambda component: scaled(component, s)))
    return scaled(let("n", l2(y)), inverse_power(let, "r", s, reduced))


def safe_normalized(let: Let, x: sp.Matrix, part: sp.Matrix) -> sp.Matrix:
    """x / |part|; x if the part is zero.

    Small components are scaled up before the division and down after it, others down before and up
    after, so that no intermediate result overflows or has fewer digits than the result."""
    s = power_of_two(let, "s", tuple(part))
    y = let("y", part.applyfunc(lambda component: scaled(component, s)))
    up = let("up", sp.Piecewise((s, s > 1), (sp.Integer(1), True)))
    down = let("down", sp.Piecewise((s, s < 1), (sp.Integer(1), True)))
    n = let("n", l2(y))
    divisor = let("divisor", sp.Piecewise((up, sp.Eq(n, 0)), (n, True)))
    before, after = sp.Matrix([up] * len(x)), sp.Matrix([down] * len(x))
    if x != part:  # components of the part are all small where it is scaled up
        sizes = let("size", x.applyfunc(sp.Abs))
        before = let("before", sizes.applyfunc(
            lambda size: sp.Piecewise((up, size < MODEST), (down, True))))
        after = let("after", sizes.applyfunc(
            lambda size: sp.Piecewise((down, size < MODEST), (up, True))))
    q = divided(let("sized", sp.Matrix(list(map(scaled, x, before)))), divisor)
    return sp.Matrix(list(map(scaled, let("quotient", q), after)))


def prefixed(let: Let, prefix: str) -> Let:
    """`let` with a prefix to every name, for formulas used twice in a kernel."""
    return replace(let, bind=lambda name, value: let(f"{prefix}_{name}", value))


unnamed = Let(lambda name, value: value)
"""Returns values without binding them: turns a derivation into a formula."""
