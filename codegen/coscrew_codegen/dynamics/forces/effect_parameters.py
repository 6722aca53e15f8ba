"""Converts effects' parameters to the form that effects' laws expect."""

from collections.abc import Mapping, Sequence
from fractions import Fraction

from coscrew_codegen.algebra.recording import numbers as n
from coscrew_codegen.algebra.recording.numbers import Number
from coscrew_codegen.algebra.recording.recorder import Recorder
from coscrew_codegen.program.folding import constant_pi
from coscrew_codegen.program.values.parameter import Parameter
from coscrew_codegen.scene.effect import Values
from coscrew_codegen.scene.formulas import Formula
from coscrew_codegen.scene.scene import Setting


def settings(recorder: Recorder, values: Mapping[str, Setting], t: Number) -> Values:
    """The values as Numbers, tuples of them, words."""
    return Values({name: _setting(recorder, value, t) for name, value in values.items()})


def _setting(recorder: Recorder, value: Setting, t: Number) -> object:
    if isinstance(value, Formula):
        return value.value(t, _functions(recorder))
    if isinstance(value, (Fraction, Parameter)):
        return recorder.number(value)
    if isinstance(value, Sequence) and not isinstance(value, str):
        return tuple(_setting(recorder, x, t) for x in value)
    return value


def _functions(recorder: Recorder) -> dict[str, object]:
    return {"sin": n.sin, "cos": n.cos, "exp": n.exp, "tanh": n.tanh, "sqrt": n.sqrt,
            "abs": n.absolute, "min": n.minimum, "max": n.maximum, "number": recorder.number,
            "less": n.less, "where": n.where, "pi": recorder.number(constant_pi())}
