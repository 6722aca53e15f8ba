"""Converts effects' parameters to the form that effects' laws expect."""

from collections.abc import Mapping, Sequence
from fractions import Fraction
from functools import partial

from coscrew_codegen.algebra.recording import numbers as n
from coscrew_codegen.algebra.recording.numbers import Number
from coscrew_codegen.algebra.recording.recorder import Recorder, array
from coscrew_codegen.program import differentiate
from coscrew_codegen.program.differentiate import Dual
from coscrew_codegen.program.folding import constant_pi
from coscrew_codegen.program.values.parameter import Parameter
from coscrew_codegen.scene.effect import Values
from coscrew_codegen.scene.formulas import PLACE, TIME, Formula
from coscrew_codegen.scene.scene import Setting


def settings(recorder: Recorder, values: Mapping[str, Setting], t: Number) -> Values:
    """The values as Numbers, tuples of them, words."""
    return Values({name: _setting(recorder, value, t) for name, value in values.items()})


def _setting(recorder: Recorder, value: Setting, t: Number) -> object:
    if isinstance(value, Formula):
        return value.value(t, _functions(recorder)) if value.of == TIME else partial(
            _surface, value)
    if isinstance(value, (Fraction, Parameter)):
        return recorder.number(value)
    if isinstance(value, Sequence) and not isinstance(value, str):
        return tuple(_setting(recorder, x, t) for x in value)
    return value


def _surface(height: Formula, x: Number, y: Number) -> tuple[Number, Number, Number]:
    """The height at a place, and its slopes: the tangent of its Program."""
    recorder, outer = Recorder([array("x", ()), array("y", ())]), x.recorder
    places = {name: recorder.argument(name)[0] for name in PLACE}
    value = height.value(places["x"], _functions(recorder) | {
        name: lambda name=name: places[name] for name in PLACE})
    program, one = recorder.program("height", [(array("H", ()), [value])]), outer.number(1)
    (result,) = differentiate.tangent(program, outer.arithmetic, n, [
        [Dual(x, (one, None))], [Dual(y, (None, one))]])
    along_x, along_y = (outer.number(0) if s is None else s for s in result.slopes)
    return result.value, along_x, along_y


def _functions(recorder: Recorder) -> dict[str, object]:
    return {"sin": n.sin, "cos": n.cos, "exp": n.exp, "tanh": n.tanh, "sqrt": n.sqrt,
            "abs": n.absolute, "min": n.minimum, "max": n.maximum, "number": recorder.number,
            "less": n.less, "where": n.where, "index": n.index, "gather": n.gather,
            "pi": recorder.number(constant_pi())}
