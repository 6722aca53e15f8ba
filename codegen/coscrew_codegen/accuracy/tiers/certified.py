"""The certified tier: the plain result, bit for bit, and a bound on its error that always holds.

For every value x̂ of the plain program (exactly x) a size s is computed, from absolute values by
sums and products alone, such that, with constants g (growth) and h (slack) known in advance:

    |x̂| <= s,    |x̂ - x| <= g (s + h).

Rounding is monotonic, hence the first.  u is the unit roundoff, η half the least subnormal number;
|fl(z) - z| <= u |fl(z)|, and η more for a product; so z <= (1 + u) fl(z) + η.  Then:

    inputs, constants    g = h = 0, s = |x|
    c = a ± b, c = a b   of exact a, b: s = |ĉ|, g = u; h = η / u for a product
    c = a ± b            s = fl(s_a + s_b), g = (1 + u) max(g_a, g_b) + u, h = h_a + h_b
    c = a b              s = fl(s_a s_b), 1 + g = (1 + u) (1 + g_a) (1 + g_b), h = 2 η / u,
                         once h_a = h_b = 0

h, the effect of underflow, would be multiplied by the other factor.  So a factor is padded
first: s' = fl(s + τ), τ the least normal number / u.  If 2 h <= τ, then
s + h <= (1 + 4 u h / τ) s', and h = 0 from there on: below s = τ / 4u the rounding of s' loses
less than τ / 2, above it h is that small a part of s <= s'.  At the end the bound is fl(C s'),
C >= (1 + u) g, rounded up; C s' > u τ is a normal number, so this product cannot underflow.
Sums of inputs alone are not padded: their error is a multiple of the least subnormal, and where
C s is subnormal so is fl(C s), which is no smaller.

Where something overflows, s and with it the bound are infinite or NaN: no statement is made.

Functions of scenes, with quotients, roots and sines, have bounds of another kind
(certified_scene.py): nearly the errors themselves, at more than twice the cost of these.
"""

from dataclasses import dataclass, replace
from fractions import Fraction
from typing import TYPE_CHECKING

from coscrew_codegen.accuracy.range_proofs import of_plain
from coscrew_codegen.accuracy.tiers import certified_rotations, certified_scene, certified_wide
from coscrew_codegen.accuracy.tiers.tier import Tier, bounds_of_outputs, is_polynomial, rounds_by
from coscrew_codegen.program import (
    ZERO,
    Constant,
    Input,
    Instruction,
    Op,
    Operand,
    Program,
    Ref,
    constant,
)
from coscrew_codegen.program.ops import ERROR_OF
from coscrew_codegen.program.program import name_of
from coscrew_codegen.program.values.formats import SINGLE, Format, Precision

if TYPE_CHECKING:
    from coscrew_codegen.algebra.operations import Operation

LARGEST = 210
"""Largest number of instructions of operations beyond polynomials that have the tier, if they call
elementary functions; SE3_exp is the largest.  Bounds take up to eleven instructions for one, and
must be compiled."""


def certified_operation(operation: "Operation") -> "Operation":
    """The operation with its bounds as further outputs; its formula gives the other outputs only.
    Searched bounds of the plain result's error are left out, since these bounds always hold."""
    bounds = bounds_of_outputs(operation.outputs)
    promise = ", ".join(f"|error of {a.name}| <= {b.name}"
                        for a, b in zip(operation.outputs, bounds, strict=True))
    order = (*operation.order, *(b.name for b in bounds)) if operation.order else ()
    return replace(operation, statement=f"{operation.statement}; {promise} unless inf or NaN",
                   outputs=(*operation.outputs, *bounds), order=order, normwise=(), rounding="")


def _made(program: Program, precision: Precision) -> Program:
    """The tier's program of an operation."""
    if is_polynomial(program):
        return certified(program, precision)
    # both options of an operation's choice are formulas for the same value
    made = certified_scene.of_scene(program, precision, kinks=False)
    return certified_rotations.infinite_unless_rotations(made, program)


def _has(program: Program) -> bool:
    held = program.counts.keys()
    return is_polynomial(program) or (rounds_by(certified_scene.BOUNDED, program)
                                      and bool(held & ERROR_OF.keys())
                                      and len(program.instructions) <= LARGEST)


def certified(program: Program, precision: Format) -> Program:
    """The polynomial plain program, extended by the bounds of its results in this precision."""
    certifier = _Certifier(program, precision)
    for step in program.instructions:
        certifier.follow(step)
    bounds = tuple(map(certifier.bound, program.results))
    return replace(program, outputs=(*program.outputs, *bounds_of_outputs(program.outputs)),
                   instructions=(*program.instructions, *certifier.steps),
                   results=(*program.results, *bounds))


@dataclass(frozen=True)
class _Size:
    """s, g and h of the value x; if `operand` is None, s is |x|, computed where it is needed."""

    x: Operand
    growth: Fraction = Fraction(0)
    slack: Fraction = Fraction(0)
    operand: Operand | None = None


class _Certifier:
    """Issues the instructions that compute sizes and bounds, each once."""

    def __init__(self, program: Program, precision: Format):
        self.steps: list[Instruction] = []
        self._inputs, self._precision = program.inputs, precision
        self._sizes: dict[Operand, _Size] = {}
        self._issued: set[str] = set()
        self._padding = precision.smallest_normal / precision.u  # τ

    def follow(self, step: Instruction) -> None:
        """Compute the size of a plain instruction's result."""
        x, u, eta = Ref(step.name), self._precision.u, self._precision.eta
        a, b = (self._size(y) for y in (*step.operands, *step.operands)[:2])
        if step.op is Op.NEG:
            self._sizes[x] = a
        elif not a.growth and not b.growth:
            self._sizes[x] = _Size(x, u, eta / u if step.op is Op.MUL else Fraction(0))
        elif step.op is Op.MUL:
            a, b = (self._padded(y, step.component) for y in (a, b))
            growth = (1 + u) * (1 + a.growth) * (1 + b.growth) - 1
            self._sizes[x] = _Size(x, growth, 2 * eta / u,
                                   self._combined(step, Op.MUL, a, b))
        else:
            growth = (1 + u) * max(a.growth, b.growth) + u
            self._sizes[x] = _Size(x, growth, a.slack + b.slack,
                                   self._combined(step, Op.ADD, a, b))

    def bound(self, result: Operand) -> Operand:
        """The bound C s' of a result; 0 if nothing was rounded."""
        size = self._size(result)
        if not size.growth:
            return ZERO
        name = f"{self._name(size.x)}_bound"
        size = self._padded(size, name)
        most = self._precision.rounded_up((1 + self._precision.u) * size.growth)
        return self._issue(name, Op.MUL, (constant(most), self._s(size, name)), name)

    def _size(self, x: Operand) -> _Size:
        if (isinstance(x, Constant)
                and not x.double == x.single == self._precision.rounded_up(x.double)):
            raise ValueError(f"{x} is rounded: no bound is known")
        return self._sizes.get(x, _Size(x))

    def _combined(self, step: Instruction, op: Op, a: _Size, b: _Size) -> Ref:
        component = f"{step.component}_size"
        return self._issue(f"{step.name}_size", op,
                           (self._s(a, component), self._s(b, component)), component)

    def _padded(self, size: _Size, component: str) -> _Size:
        """s' = fl(s + τ) where there is slack."""
        if not size.slack:
            return size
        tau = self._padding
        if 2 * size.slack > tau:
            raise ValueError(f"{self._name(size.x)}: too many products for the padding")
        operands = self._s(size, component), constant(tau)
        s = self._issue(f"{self._name(size.x)}_padded", Op.ADD, operands, component)
        lost = 4 * self._precision.u * size.slack / tau
        return _Size(size.x, size.growth * (1 + lost), operand=s)

    def _s(self, size: _Size, component: str) -> Operand:
        """The operand that holds s."""
        if size.operand is not None or isinstance(size.x, Constant):
            return size.operand or size.x
        return self._issue(f"{self._name(size.x)}_abs", Op.ABS, (size.x,), component)

    def _name(self, x: Operand) -> str:
        if isinstance(x, Input):
            return str(self._inputs[x.argument].symbols[x.index].name)
        return name_of(x)

    def _issue(self, name: str, op: Op, operands: tuple[Operand, ...], component: str) -> Ref:
        if name not in self._issued:
            self._issued.add(name)
            self.steps.append(Instruction(name, op, operands, component))
        return Ref(name)


def _of_scene(program: Program, precision: Precision) -> Program:
    """The tier's program of a scene's function."""
    if precision == SINGLE:
        return certified_wide.of_scene(program)
    return certified_scene.of_scene(program, precision)


TIER = Tier(
    "certified", 3, "Certified tier: plain results, and bounds on their errors that always hold.",
    ("#00805d", "#3ccf9f"), _made, has=_has,
    operation=certified_operation, scene=_of_scene, bounds=True, proof=of_plain,
    promise="""\
|tau - exact| <= tau_bound for each component of a result tau: exact is what exact arithmetic makes
of the arguments as they are and of the model's decimals.  Where a bound is infinite or NaN, no
statement is made.""",
    in_words="""\
The certified tier: every operation returns (result, bound), the plain result, bit for bit, and a
bound on each component's error.  It holds for all numbers, underflow included.  Where something
overflowed, the bound is infinite or NaN: no statement is made.""")
