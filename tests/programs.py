"""Evaluates Programs of scenes directly, on floats, 50-digit numbers or Fractions.

Shares nothing with the targets but the Program itself.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache

import mpmath
import numpy as np

from coscrew_codegen.dynamics.function import SceneFunctions
from coscrew_codegen.dynamics.functions import derive
from coscrew_codegen.dynamics.scene import Scene
from coscrew_codegen.program import Constant, Input, Op, Program, Ref

Values = Sequence[object]

_RATIONAL: dict[Op, Callable] = {
    Op.ADD: lambda a, b: a + b, Op.SUB: lambda a, b: a - b, Op.MUL: lambda a, b: a * b,
    Op.SCALE: lambda a, b: a * b, Op.DIV: lambda a, b: a / b, Op.NEG: lambda a: -a, Op.ABS: abs,
    Op.LESS: lambda a, b: a < b, Op.EQUAL: lambda a, b: a == b}


@dataclass(frozen=True)
class Arithmetic:
    """The numbers a Program is evaluated on."""

    constant: Callable[[Constant], object]
    functions: Mapping[Op, Callable]
    select: Callable = lambda test, a, b: a if test else b

    def evaluate(self, program: Program, inputs: Sequence[Values]) -> list[object]:
        """All components of the outputs for these components of the inputs."""
        known: dict[str, object] = {}

        def value(x):
            if isinstance(x, Ref):
                return known[x.name]
            return inputs[x.argument][x.index] if isinstance(x, Input) else self.constant(x)

        for step in program.instructions:
            operands = map(value, step.operands)
            known[step.name] = self.select(*operands) if step.op is Op.SELECT else \
                self.functions[step.op](*operands)
        return [value(x) for x in program.results]


def _floats(number: type, precision: str) -> Arithmetic:
    names = {Op.SQRT: np.sqrt, Op.SIN: np.sin, Op.COS: np.cos, Op.EXP: np.exp, Op.TANH: np.tanh,
             Op.ATAN2: np.arctan2}
    constant = cache(lambda x: number(float(getattr(x, precision))))
    return Arithmetic(constant, {**_RATIONAL, **names}, lambda test, a, b: np.where(test, a, b)[()])


DOUBLE, SINGLE = _floats(np.float64, "double"), _floats(np.float32, "single")
MULTIPRECISE = Arithmetic(
    lambda x: mpmath.mpf(x.double.numerator) / x.double.denominator,
    {**_RATIONAL, Op.SQRT: mpmath.sqrt, Op.SIN: mpmath.sin, Op.COS: mpmath.cos, Op.EXP: mpmath.exp,
     Op.TANH: mpmath.tanh, Op.ATAN2: mpmath.atan2})
"""In the precision of mpmath's context."""


def exact(circle: Mapping[Fraction, tuple[Fraction, Fraction]]) -> Arithmetic:
    """Fractions, with (sin, cos) of the angles that occur: rational points of the circle."""
    return Arithmetic(lambda x: x.double, {**_RATIONAL, Op.SIN: lambda q: circle[q][0],
                                           Op.COS: lambda q: circle[q][1]})


class Evaluated:
    """The functions of a scene, called by name: f("forward_dynamics", q=…, v=…, tau=…).

    What a function does not take is left out; p is, unless given, what the scene says."""

    def __init__(self, scene: Scene, arithmetic: Arithmetic = DOUBLE,
                 number: Callable = np.float64):
        self.scene, self.arithmetic, self.number = scene, arithmetic, number
        self.functions: SceneFunctions = derive(scene)
        self.programs = {f.name: f.program for f in self.functions.functions}

    def __call__(self, name: str, **values: object) -> object:
        """A list of components; of a scalar, the number."""
        program = self.programs[name]
        given = {"t": 0, "p": [p.value for p in self.scene.parameters], **values}
        found = self.arithmetic.evaluate(program, [
            [self._number(x) for x in np.ravel(np.array(given[a.name], dtype=object))]
            for a in program.inputs])
        return found if program.outputs[0].quantity.shape else found[0]

    def _number(self, x: object) -> object:
        if isinstance(x, Fraction):
            return self.number(x.numerator) / self.number(x.denominator)
        return self.number(x)


def multiprecise(scene: Scene) -> Evaluated:
    """On numbers of mpmath's precision."""
    return Evaluated(scene, MULTIPRECISE, mpmath.mpmathify)


def single(scene: Scene) -> Evaluated:
    """On float32."""
    return Evaluated(scene, SINGLE, np.float32)
