"""Operations that screws and coscrews have in common, written once for both.

Screws are transformed by [Ad], coscrews by [Ad]*.  In names, `inv` after the letter transforms the
inverse of the quantity, its negative; `inv` before it applies the inverse transform.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import sympy as sp

from coscrew_codegen.algebra.matrices import (
    ang,
    inverse_operator,
    lin,
    rotation,
    shifted,
    stack,
    translation,
    turned,
)
from coscrew_codegen.algebra.operations.formulas.linear_formulas import linear_space
from coscrew_codegen.algebra.operations.formulas.norm import (
    Let,
    chosen_part,
    divided,
    leading_part,
    nonzero,
    safe_norm,
    safe_normalized,
)
from coscrew_codegen.algebra.operations.operation import Operation
from coscrew_codegen.program.values.quantity import (
    ANGULAR_FIRST,
    ANY,
    MAT3X3,
    MAT6X6,
    ROTATION,
    SCALAR,
    SE3,
    VEC3,
    Argument,
    Quantity,
)

JOINTS = ("tx", "ty", "tz", "rx", "ry", "rz")


@dataclass(frozen=True)
class Space:
    """Screws or coscrews: the quantity, its letter, its operator, the part that its norm uses."""

    kind: Quantity
    letter: str
    operator: Callable[[sp.Matrix], sp.Matrix]
    operator_name: str  # in names of functions: Ad, CoAd
    operator_words: str  # in equations: [Ad], [Ad]*
    norm_first: Callable[[sp.Matrix], sp.Matrix]  # the norm is this part's, unless it is about 0:
    norm_second: Callable[[sp.Matrix], sp.Matrix]  # then this part's
    norm_words: str

    @property
    def family(self) -> str:
        return self.kind.name

    def argument(self, suffix: str) -> Argument:
        return Argument(f"{self.letter}{suffix}", self.kind)

    @property
    def op(self) -> Callable[..., Operation]:
        """An operation of the family."""
        return partial(Operation, self.family)


def space_operations(space: Space) -> tuple[Operation, ...]:
    """All operations that screws and coscrews have in common."""
    return (*linear_space(space.family, space.kind, space.letter), *_norms(space), *_parts(space),
            *_transforms(space), *_joint_columns(space), *_operator_matrix(space))


def _norms(space: Space) -> tuple[Operation, ...]:
    kind, xi, xo = space.kind.name, space.argument("i"), space.argument("o")
    self, norm = Argument("self", space.kind), Argument("norm", SCALAR)

    def norm_of(x: sp.Matrix) -> sp.Expr:
        return sp.sqrt(leading_part(space.norm_first(x), space.norm_second(x)))

    def bound_norm(let: Let, x: sp.Matrix) -> sp.Expr:
        return safe_norm(let, chosen_part(let, space.norm_first(x), space.norm_second(x)))

    def normalized(x: sp.Matrix) -> sp.Matrix:
        return divided(x, nonzero(norm_of(x)))

    def bound_normalized(let: Let, x: sp.Matrix) -> sp.Matrix:
        part = chosen_part(let, space.norm_first(x), space.norm_second(x))
        return safe_normalized(let, x, part)

    zero = f"the zero {kind} stays zero"
    return (
        space.op(f"{kind}_norm", f"|{xi.name}|: {space.norm_words}", (xi,), (norm,),
                 norm_of, bound_norm),
        space.op(f"{kind}_normalize", f"self = self / |self|, with {kind}_norm; {zero}", (self,),
                 (self,), normalized, bound_normalized),
        space.op(f"{kind}_normalized", f"{xo.name} = {xi.name} / |{xi.name}|, with {kind}_norm; "
                 f"{zero}", (xi,), (xo,), normalized, bound_normalized),
    )


def _parts(space: Space) -> tuple[Operation, ...]:
    kind, letter, xi, xo = space.kind.name, space.letter, space.argument("i"), space.argument("o")
    one, two = space.argument("1"), space.argument("2")
    l, a = Argument("lin", VEC3, ANY), Argument("ang", VEC3, ANY)
    top = Argument("x", ANGULAR_FIRST)
    return (
        space.op(f"{kind}_from_lin_ang", f"{xo.name} = (lin; ang)", (l, a), (xo,), stack),
        space.op(f"{kind}_to_angular_first", f"x = (ang; lin) of {xi.name}", (xi,), (top,),
                 lambda x: stack(ang(x), lin(x))),
        space.op(f"{kind}_from_angular_first", f"{xo.name} = (lin; ang) of x = (ang; lin)",
                 (top,), (xo,), lambda x: stack(ang(x), lin(x))),
        space.op(f"add_{letter * 2}t", f"{xo.name} = ({letter}1.lin + {letter}2.lin ; "
                 f"{letter}1.ang)", (one, two), (xo,),
                 lambda x, y: stack(lin(x) + lin(y), ang(x))),
    )


def _transforms(space: Space) -> tuple[Operation, ...]:
    operator, letter, words = space.operator, space.letter, space.operator_words
    xi, xo = space.argument("i"), space.argument("o")
    t, R = Argument("t", VEC3, ANY), Argument("R", MAT3X3, ROTATION)
    D = Argument("D", SE3)
    i, o = xi.name, xo.name

    def by_displacement(let: Let, D: sp.Matrix, x: sp.Matrix) -> sp.Matrix:
        return operator(shifted(translation(D))) * let("w", operator(turned(rotation(D))) * x)

    def by_inverse(let: Let, D: sp.Matrix, x: sp.Matrix) -> sp.Matrix:
        return operator(turned(rotation(D).T)) * let("w", operator(shifted(-translation(D))) * x)

    def op(suffix: str, equation: str, argument: Argument, formula: Callable[..., sp.Matrix],
           derivation: Callable[..., sp.Matrix] | None = None) -> Operation:
        return space.op(f"product_{space.operator_name}{suffix}", f"{o} = {equation}",
                        (argument, xi), (xo,), formula, derivation)

    return (
        op(f"t{letter}", f"{words}(t) {i}", t, lambda t, x: operator(shifted(t)) * x),
        op(f"tinv{letter}", f"{words}(t)^-1 {i}", t, lambda t, x: operator(shifted(-t)) * x),
        op(f"t{letter}inv", f"{words}(t) (-{i})", t, lambda t, x: -operator(shifted(t)) * x),
        op(f"r{letter}", f"{words}(R) {i}", R, lambda R, x: operator(turned(R)) * x),
        op(f"rinv{letter}", f"{words}(R)^-1 {i}", R, lambda R, x: operator(turned(R.T)) * x),
        op(f"r{letter}inv", f"{words}(R) (-{i})", R, lambda R, x: -operator(turned(R)) * x),
        op(letter, f"{words}(D) {i} = {words}(t) {words}(R) {i}", D,
           lambda D, x: operator(D) * x, by_displacement),
        op(f"inv{letter}", f"{words}(D)^-1 {i} = {words}(R^T) {words}(-t) {i}", D,
           lambda D, x: inverse_operator(operator, D) * x, by_inverse),
        op(f"{letter}inv", f"{words}(D) (-{i})", D, lambda D, x: -operator(D) * x,
           lambda let, D, x: by_displacement(let, D, -x)),
    )


def _joint_columns(space: Space) -> tuple[Operation, ...]:
    """h of the six primitive joints: a column of the operator, and its negative."""
    D, xo = Argument("D", SE3), space.argument("o")

    def column(joint: int, sign: int) -> Operation:
        basis = sign * sp.eye(6)[:, joint]
        name = f"h{space.letter}{JOINTS[joint]}" + ("inv" if sign < 0 else "")
        minus = "-" if sign < 0 else ""
        return space.op(
            name, f"{xo.name} = {minus}h_{JOINTS[joint]}: {minus}column {joint} of "
            f"{space.operator_words}(D)", (D,), (xo,), lambda D: space.operator(D) * basis)

    return tuple(column(joint, sign) for sign in (1, -1) for joint in range(6))


def _operator_matrix(space: Space) -> tuple[Operation, ...]:
    D, M = Argument("D", SE3), Argument("M", MAT6X6)
    return (space.op(space.operator_name, f"M = {space.operator_words}(D)", (D,), (M,),
                     space.operator),)
