"""Evaluates the Programs of a scene's functions on floats, 50-digit numbers or Fractions.

Shares only the Programs with the targets, and needs no compiler.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Generic, TypeAlias, TypeVar

import mpmath
import numpy as np

from coscrew_codegen.dynamics.derivation import tree_for
from coscrew_codegen.dynamics.derive_functions import derive
from coscrew_codegen.program import Op, Program
from coscrew_codegen.program.interpreter import Arithmetic, by_operation, exactly, interpreter
from coscrew_codegen.program.scene_functions import SceneFunctions
from coscrew_codegen.scene.scene import Scene

N = TypeVar("N")
Real = TypeVar("Real", bound=np.floating)
Given: TypeAlias = int | float | Fraction | mpmath.mpf


@dataclass(frozen=True)
class Numbers(Generic[N]):
    """A kind of numbers for evaluation, and the conversion of the caller's numbers to it."""

    arithmetic: Arithmetic[N]
    number: Callable[[Given | N], N]


def _multiprecise(x: Given) -> mpmath.mpf:
    """The number in the precision of mpmath's context."""
    return mpmath.mpf(x.numerator) / mpmath.mpf(x.denominator) if isinstance(x, Fraction) \
        else mpmath.mpf(x)


def _floats(number: type[Real], precision: str) -> Numbers[Real]:
    return Numbers(by_operation(lambda x: number(float(getattr(x, precision))), exactly(np),
                                number(np.nan)),
                   lambda x: number(float(x) if isinstance(x, Fraction) else x))


DOUBLE, SINGLE = _floats(np.float64, "double"), _floats(np.float32, "single")
MULTIPRECISE = Numbers(by_operation(lambda x: _multiprecise(x.double), exactly(mpmath)),
                       _multiprecise)
"""Numbers and constants in the precision of mpmath's context."""


def _divided(a: mpmath.mpf, b: mpmath.mpf) -> mpmath.mpf:
    return a / b if b else mpmath.nan


def without_errors(precision: str) -> Numbers[mpmath.mpf]:
    """The arithmetic with the constants of a precision; a division by zero gives NaN."""
    functions = {**exactly(mpmath), Op.DIV: _divided}
    return Numbers(by_operation(lambda x: _multiprecise(getattr(x, precision)), functions,
                                mpmath.nan), _multiprecise)


def rational(circle: Mapping[Fraction, tuple[Fraction, Fraction]]) -> Numbers[Fraction]:
    """Fractions; the sine and cosine of each angle are given, as rational points of the circle."""
    odd = {**circle, **{-q: (-s, c) for q, (s, c) in circle.items()}}
    functions: dict[Op, Callable[..., Fraction]] = {
        **exactly(), Op.SIN: lambda q: odd[q][0], Op.COS: lambda q: odd[q][1]}
    return Numbers(by_operation(lambda x: x.double, functions), lambda x: Fraction(x))


def evaluator(program: Program, numbers: Numbers[N]
              ) -> Callable[[Sequence[Sequence[N]]], list[N]]:
    """From the inputs' components to those of the outputs."""
    return interpreter(program, numbers.arithmetic)


class Evaluated(Generic[N]):
    """The functions of a scene by name.  f("forward_dynamics", q=…, v=…, tau=…) is a list of
    numbers, or a number if the output is a scalar.  Each function is derived when it is first
    called.

    Inputs that a function does not take are ignored; p defaults to the scene's values, t to zero.
    """

    def __init__(self, scene: Scene, numbers: Numbers[N],
                 functions: SceneFunctions | None = None):
        self.scene, self.numbers, self._derived = scene, numbers, functions
        tree = tree_for(scene)
        self.nq, self.nv, self.coordinates = tree.nq, tree.nv, tree.coordinates
        self._programs: dict[str, Program] = {}
        self._evaluators: dict[str, Callable[[Sequence[Sequence[N]]], list[N]]] = {}

    def program(self, name: str) -> Program:
        """The function's Program; derived with the others if those are given."""
        if name not in self._programs:
            functions = (self._derived or derive(self.scene, (name,))).functions
            self._programs[name] = next(f.program for f in functions if f.name == name)
        return self._programs[name]

    def __call__(self, name: str, **values: Given | Sequence[Given]) -> list[N] | N:
        result = self.components(name, **values)
        return result if self.program(name).outputs[0].quantity.shape else result[0]

    def components(self, name: str, **values: Given | Sequence[Given]) -> list[N]:
        """All numbers of the results."""
        program, number = self.program(name), self.numbers.number
        if name not in self._evaluators:
            self._evaluators[name] = evaluator(program, self.numbers)
        given: dict[str, Given | Sequence[Given]] = {
            "t": 0, "p": [x.value for x in self.scene.parameters], **values}
        result = self._evaluators[name]([[number(x) for x in _components(given[a.name])]
                                         for a in program.inputs])
        return [number(x) for x in result]


def _components(value: Given | Sequence[Given]) -> Sequence[Given]:
    return list(value) if isinstance(value, (Sequence, np.ndarray)) else [value]


class Moving:
    """A state (t, q, v) of a scene that takes steps in double; positions move by `integrated`."""

    def __init__(self, scene: Scene, q: Sequence[Given], v: Sequence[Given]):
        self.f = Evaluated(scene, DOUBLE)
        number = DOUBLE.number
        self.q, self.v = list(map(number, q)), list(map(number, v))
        self.t = number(0)
        self.tau = [number(0)] * self.f.nv

    def moved(self, q: Sequence[Given], phi: Sequence[Given]) -> list[np.float64]:
        """q ⊕ phi."""
        return self.f.components("integrated", q=q, phi=phi)

    def acceleration(self, t: Given, q: Sequence[Given], v: Sequence[Given]) -> list[np.float64]:
        """a."""
        return self.f.components("forward_dynamics", t=t, q=q, v=v, tau=self.tau)

    def implicit(self, h: float, steps: int = 1) -> "Moving":
        """Linearly implicit steps: v + h a, then q ⊕ h v."""
        for _ in range(steps):
            a = self.f.components("implicit_acceleration", h=h, t=self.t, q=self.q, v=self.v)
            self._advance(h, a)
        return self

    def _advance(self, h: float, a: Sequence[np.float64]) -> None:
        self.v = [v + h * x for v, x in zip(self.v, a, strict=True)]
        self.q = self.moved(self.q, [h * v for v in self.v])
        self.t = self.t + h

    def rk4(self, h: float, steps: int = 1) -> "Moving":
        """Steps of the classical Runge-Kutta method, of order 4; for quaternions, in the chart phi
        around q."""
        for _ in range(steps):
            self._rk4(h)
        return self

    def _rk4(self, h: float) -> None:
        zero = [0 * v for v in self.v]
        u, a = self.v, self.acceleration(self.t, self.q, self.v)
        rates = [(u, a)]
        for part in (h / 2, h / 2, h):
            phi = [part * x for x in rates[-1][0]]
            v = [x + part * y for x, y in zip(self.v, rates[-1][1], strict=True)]
            u = (v if self.f.nq == self.f.nv else
                 self.f.components("chart_rate", v=v, phi=phi))
            rates.append((u, self.acceleration(self.t + part, self.moved(self.q, phi), v)))
        phi, dv = zero, zero
        for weight, (u, a) in zip((1, 2, 2, 1), rates, strict=True):
            phi = [x + weight * y * h / 6 for x, y in zip(phi, u, strict=True)]
            dv = [x + weight * y * h / 6 for x, y in zip(dv, a, strict=True)]
        self.q, self.t = self.moved(self.q, phi), self.t + h
        self.v = [x + y for x, y in zip(self.v, dv, strict=True)]

    def energy(self) -> float:
        """Kinetic and potential."""
        return sum(self.f.components("energy", t=self.t, q=self.q, v=self.v))
