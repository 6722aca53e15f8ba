"""The functions of a scene as their Programs say: on floats, 50-digit numbers or Fractions.

Shares nothing with the targets but the Programs, and needs no compiler.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

import mpmath
import numpy as np

from coscrew_codegen.mechanics.functions import derive
from coscrew_codegen.program import Constant, Input, Op, Operand, Program
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.scene_functions import SceneFunctions

_INFIX = {Op.ADD: "+", Op.SUB: "-", Op.MUL: "*", Op.SCALE: "*", Op.DIV: "/", Op.LESS: "<",
          Op.EQUAL: "=="}


@dataclass(frozen=True)
class Arithmetic:
    """The numbers a Program is evaluated on: constants, numbers of the caller, functions."""

    constant: Callable[[Constant], object]
    number: Callable[[object], object]
    functions: Mapping[str, Callable]  # sin, cos, sqrt, exp, tanh, atan2


def _rational(number: Callable) -> Callable[[object], object]:
    """Fractions divided out, all else as `number` takes it."""
    return lambda x: number(x.numerator) / number(x.denominator) if isinstance(x, Fraction) \
        else number(x)


def _floats(number: type, precision: str) -> Arithmetic:
    return Arithmetic(lambda x: number(float(getattr(x, precision))),
                      lambda x: number(float(x) if isinstance(x, Fraction) else x),
                      {"sqrt": np.sqrt, "sin": np.sin, "cos": np.cos, "exp": np.exp,
                       "tanh": np.tanh, "atan2": np.arctan2})


_MPMATH = {name: getattr(mpmath, name) for name in ("sqrt", "sin", "cos", "exp", "tanh", "atan2")}

DOUBLE, SINGLE = _floats(np.float64, "double"), _floats(np.float32, "single")
MULTIPRECISE = Arithmetic(lambda x: _rational(mpmath.mpf)(x.double), _rational(mpmath.mpf), _MPMATH)
"""In the precision of mpmath's context, constants too."""


def rational(circle: Mapping[Fraction, tuple[Fraction, Fraction]]) -> Arithmetic:
    """Fractions, with (sin, cos) of the angles that occur: rational points of the circle."""
    odd = {**circle, **{-q: (-s, c) for q, (s, c) in circle.items()}}
    return Arithmetic(lambda x: x.double, Fraction, {"sin": lambda q: odd[q][0],
                                                     "cos": lambda q: odd[q][1]})


def evaluator(program: Program, arithmetic: Arithmetic) -> Callable[[Sequence], list]:
    """From the inputs' components to those of the outputs, instruction by instruction."""
    names: dict[str, object] = dict(arithmetic.functions)
    known: dict[str, str] = {}

    def operand(x: Operand) -> str:
        if isinstance(x, Input):
            return f"x[{x.argument}][{x.index}]"
        if isinstance(x, Constant):
            name = f"c{len(names)}"
            names[name] = arithmetic.constant(x)
            return name
        return known[x.name]

    lines = ["def evaluate(x):"]
    for number, step in enumerate(program.instructions):
        operands = [operand(x) for x in step.operands]
        known[step.name] = f"s{number}"
        lines.append(f"    s{number} = {_expression(step.op, operands)}")
    lines.append(f"    return [{', '.join(map(operand, program.results))}]")
    exec("\n".join(lines), names)
    return names["evaluate"]


def _expression(op: Op, x: Sequence[str]) -> str:
    if op in _INFIX:
        return f"{x[0]} {_INFIX[op]} {x[1]}"
    if op is Op.SELECT:
        return f"{x[1]} if {x[0]} else {x[2]}"
    return f"-{x[0]}" if op is Op.NEG else f"{op.value}({', '.join(x)})"


class Evaluated:
    """The functions of a scene by name: f("forward_dynamics", q=…, v=…, tau=…) is a list of
    numbers, or of a scalar output the number.

    What a function does not take may be given and is left out; p is, if not given, what the scene
    says, and t is zero."""

    def __init__(self, scene: Scene, arithmetic: Arithmetic = DOUBLE,
                 functions: SceneFunctions | None = None):
        self.scene, self.arithmetic = scene, arithmetic
        self.functions = functions or derive(scene)
        self.programs = {f.name: f.program for f in self.functions.functions}
        self._evaluators: dict[str, Callable] = {}

    def __call__(self, name: str, **values: object) -> object:
        program, number = self.programs[name], self.arithmetic.number
        if name not in self._evaluators:
            self._evaluators[name] = evaluator(program, self.arithmetic)
        given = {"t": 0, "p": [x.value for x in self.scene.parameters], **values}
        found = self._evaluators[name]([[number(x) for x in _components(given[a.name])]
                                        for a in program.inputs])
        found = [number(x) for x in found]
        return found if program.outputs[0].quantity.shape else found[0]


def _components(value: object) -> Sequence:
    return value if isinstance(value, (list, tuple, np.ndarray)) else [value]


class Moving:
    """A state (t, q, v) of a scene that takes steps; positions move as `integrated` says."""

    def __init__(self, scene: Scene, q: Sequence, v: Sequence, arithmetic: Arithmetic = DOUBLE,
                 tau: Sequence | None = None):
        self.f = Evaluated(scene, arithmetic)
        number = arithmetic.number
        self.q, self.v = list(map(number, q)), list(map(number, v))
        self.t = number(0)
        self.tau = tau if tau is not None else [number(0)] * self.f.functions.nv

    def moved(self, q: Sequence, phi: Sequence) -> list:
        """q ⊕ phi."""
        return self.f("integrated", q=q, phi=phi)

    def acceleration(self, t: object, q: Sequence, v: Sequence) -> list:
        """a."""
        return self.f("forward_dynamics", t=t, q=q, v=v, tau=self.tau)

    def implicit(self, h: object, steps: int = 1) -> "Moving":
        """Linearly implicit steps: v + h a, then q ⊕ h v."""
        for _ in range(steps):
            a = self.f("implicit_acceleration", h=h, t=self.t, q=self.q, v=self.v)
            self._advance(h, a)
        return self

    def explicit(self, h: object, steps: int = 1) -> "Moving":
        """Semi-implicit steps of Euler: v + h a, then q ⊕ h v."""
        for _ in range(steps):
            self._advance(h, self.acceleration(self.t, self.q, self.v))
        return self

    def _advance(self, h: object, a: Sequence) -> None:
        self.v = [v + h * x for v, x in zip(self.v, a, strict=True)]
        self.q = self.moved(self.q, [h * v for v in self.v])
        self.t = self.t + h

    def rk4(self, h: object, steps: int = 1) -> "Moving":
        """Steps of Runge and Kutta's, of order 4: on quaternions, in the chart phi around q."""
        for _ in range(steps):
            self._rk4(h)
        return self

    def _rk4(self, h: object) -> None:
        zero = [0 * v for v in self.v]
        u, a = self.v, self.acceleration(self.t, self.q, self.v)
        rates = [(u, a)]
        for part in (h / 2, h / 2, h):
            phi = [part * x for x in rates[-1][0]]
            v = [x + part * y for x, y in zip(self.v, rates[-1][1], strict=True)]
            u = self.f("chart_rate", v=v, phi=phi) if "chart_rate" in self.f.programs else v
            rates.append((u, self.acceleration(self.t + part, self.moved(self.q, phi), v)))
        phi, dv = zero, zero
        for weight, (u, a) in zip((1, 2, 2, 1), rates, strict=True):
            phi = [x + weight * y * h / 6 for x, y in zip(phi, u, strict=True)]
            dv = [x + weight * y * h / 6 for x, y in zip(dv, a, strict=True)]
        self.q, self.t = self.moved(self.q, phi), self.t + h
        self.v = [x + y for x, y in zip(self.v, dv, strict=True)]

    def energy(self) -> object:
        """Kinetic and potential."""
        return sum(self.f("energy", t=self.t, q=self.q, v=self.v))
