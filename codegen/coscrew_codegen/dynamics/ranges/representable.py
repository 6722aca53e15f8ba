"""Refuses numbers that a precision cannot represent, before anything is emitted.

Numbers of a scene must be 0 or normal in its precisions: larger ones would become infinite, smaller
ones would lose digits or become 0.  Their products may also be subnormal, since files contain
residues such as 1.7e-19 kg m² for zero.  Quotients with a denominator that may change are not
constants: they are checked for the scene at rest.
"""

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import mpmath

from coscrew_codegen.program import Constant, Instruction, Op, Program
from coscrew_codegen.program.interpreter import Arithmetic, evaluate, exactly
from coscrew_codegen.program.reported_error import ReportedError
from coscrew_codegen.program.scene_functions import FunctionProgram
from coscrew_codegen.program.tables import TableColumn
from coscrew_codegen.program.values.formats import Precision, named
from coscrew_codegen.program.values.parameter import Scalar
from coscrew_codegen.scene.mechanism.model import value
from coscrew_codegen.scene.scene import Scene

NORMAL, SUBNORMAL = "smallest_normal", "smallest_subnormal"
_AXES = ("x", "y", "z")
_MOMENTS = ("xx", "yy", "zz", "xy", "xz", "yz")
_REMEDY = ('; precision = "double" in the scene file, or --precision double, leaves single '
           "precision out")


class RangeError(ReportedError, ValueError):
    """"SCENE: body 'tool': mass 1e+60 kg is outside single precision's range: …"."""


@dataclass(frozen=True)
class _Written:
    """A number of the scene with its place and name: "body 'tool'", "mass"."""

    where: str
    name: str
    number: Scalar
    unit: str


def refuse_numbers(scene: Scene) -> None:
    """Raise RangeError for the first number of the scene that one of its precisions cannot
    represent."""
    for x in _written(scene):
        number = value(x.number)
        _refuse(scene, Constant(number, number), NORMAL,
                f"{x.where}: {x.name} {float(number):g} {x.unit}".rstrip())


def refuse_products(scene: Scene, function: FunctionProgram) -> None:
    """Raise RangeError for the first constant of the function, a product of the scene's numbers,
    that one of its precisions cannot represent."""
    for where, constant in _constants(function):
        _refuse(scene, constant, SUBNORMAL, f"{where}: its numbers are multiplied "
                f"to {_shown(constant.double)} in {function.name}, which")


def refuse_quotients(scene: Scene, function: FunctionProgram, inputs: Mapping[str, Sequence[float]]
                     ) -> None:
    """Raise RangeError for the first quotient of the function that one of the scene's precisions
    cannot represent, for inputs by name."""
    program, precisions = function.program, named(scene.precisions)
    if Op.DIV not in program.counts:
        return
    alike = all(x.double == x.single for _, x in _constants(function))
    for precision in precisions:
        if precision == precisions[0] or not alike:
            quotients = _quotients(program, precision, inputs)
        largest = precision.limit("max")
        for where, quotient in quotients:
            if abs(quotient) > largest:
                _refuse(scene, Constant(quotient, quotient), SUBNORMAL,
                        f"{where or function.name}: its numbers are divided to "
                        f"{_shown(quotient)} at rest in {function.name}, which")


def _quotients(program: Program, precision: Precision, inputs: Mapping[str, Sequence[float]]
               ) -> list[tuple[str, Fraction]]:
    """(part of the scene, exact value) of each quotient of finite numbers.  Undefined values are
    NaN, as are those computed from them."""
    results: list[tuple[str, Fraction]] = []

    def function(step: Instruction, _: int) -> Callable[..., float]:
        def apply(*operands: float) -> float:
            if step.op is Op.DIV and all(map(math.isfinite, operands)) and operands[1]:
                results.append((_part(step), Fraction(operands[0]) / Fraction(operands[1])))
            try:
                return float(_VALUES[step.op](*operands))
            except (ArithmeticError, ValueError):
                return math.nan
        return apply

    evaluate(program, [inputs[a.name] for a in program.inputs],
             Arithmetic(lambda x: float(precision.value(x)), function, math.nan))
    return results


_VALUES: Mapping[Op, Callable[..., Any]] = {**exactly(math), Op.GATHER: TableColumn.at}


def _refuse(scene: Scene, constant: Constant, least: str, what: str) -> None:
    for precision in named(scene.precisions):
        smallest, largest = precision.limit(least), precision.limit("max")
        number = precision.value(constant)
        if number and not smallest <= abs(number) <= largest:
            remedy = _REMEDY if precision.name == "single" and "double" in scene.precisions else ""
            raise RangeError(f"{scene.name}: {what} is outside {precision.name} precision's range: "
                             f"0, and {float(smallest):.2g} to {float(largest):.2g} in size"
                             f"{remedy}")


def _shown(x: Fraction) -> str:
    """The number with three digits; only its power of ten if it exceeds the range of floats."""
    try:
        if (near := float(x)) or not x:
            return f"{near:.3g}"
    except OverflowError:
        pass
    digits = mpmath.log10(mpmath.mpf(abs(x.numerator)) / x.denominator)
    return f"about {'-' if x < 0 else ''}1e{round(digits):+d}"


def _written(scene: Scene) -> Iterator[_Written]:
    for body in scene.model.bodies:
        if inertia := body.inertia:
            where = f"body {body.name!r}"
            yield _Written(where, "mass", inertia.mass, "kg")
            for name, x in zip(_AXES, inertia.com, strict=True):
                yield _Written(where, f"com {name}", x, "m")
            for name, x in zip(_MOMENTS, inertia.moments, strict=True):
                yield _Written(where, f"inertia {name}", x, "kg m²")
    for joint in scene.model.joints:
        where = f"joint {joint.name!r}"
        for name, x in zip(_AXES, joint.placement.t, strict=True):
            yield _Written(where, f"origin {name}", x, "m")
        if joint.mimic and any(applied.effect.mimic for applied in scene.effects):
            yield _Written(where, "mimic's multiplier", joint.mimic.multiplier, "")
            yield _Written(where, "mimic's offset", joint.mimic.offset, "")
    for applied in scene.effects:
        for parameter in applied.effect.parameters:
            given = applied.values.get(parameter.name)
            for part in given if isinstance(given, tuple) else (given,):
                if isinstance(part, Scalar):
                    yield _Written(f"effect {applied.name}", parameter.name, part, parameter.unit)


def _constants(function: FunctionProgram) -> Iterator[tuple[str, Constant]]:
    """The constants of a function, with the parts of the scene that they belong to."""
    program = function.program
    for step in program.instructions:
        for x in step.operands:
            if isinstance(x, Constant):
                yield _part(step) or function.name, x
    for x in program.results:
        if isinstance(x, Constant):
            yield f"result of {function.name}", x


def _part(step: Instruction) -> str:
    """The part of the scene that an instruction belongs to."""
    return step.component.rpartition(":")[0]
