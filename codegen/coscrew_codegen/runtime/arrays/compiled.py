"""Functions of arrays in C, in lanes: compiled when they are first needed, and cached."""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Sequence
from functools import cache

from coscrew_codegen.backends.render import render, runtime
from coscrew_codegen.program.scene_functions import FunctionProgram, SceneFunctions, c_name, many
from coscrew_codegen.program.values.formats import PRECISIONS, Precision
from coscrew_codegen.runtime import source_text
from coscrew_codegen.runtime.arrays.array_function import ArrayFunction
from coscrew_codegen.runtime.console import doing

_NAME = "states"
"""Name of the only function of such a library."""


@cache
def handler(function: ArrayFunction, precision: Precision, include: str) -> object | None:
    """The handler for XLA, as ctypes has it; None where nothing compiles.  `include` is the folder
    of XLA's headers."""
    scene = _scene(function)
    text = {f"{scene.name}_xla.c": render(
        "scene/xla.c", name=scene.name, upper=scene.name.upper(),
        handlers=[_handler(scene, function, p) for p in PRECISIONS]),
        **runtime("runtime/arrays/*.h")}
    opened = _opened(function, precision, text, (f"{scene.name}_xla.c", f"-I{include}"))
    return opened and getattr(opened, _symbol(scene, precision))


@cache
def loop(function: ArrayFunction, precision: Precision) -> Callable[..., None] | None:
    """The function of n states: n, then of each argument and result a pointer and a stride; None
    where nothing compiles."""
    opened = _opened(function, precision, {})
    if not opened:
        return None
    address = getattr(opened, c_name(many(_scene(function)), _NAME, precision))
    count = len(function.inputs) + len(function.shapes)
    address.restype = None
    address.argtypes = [ctypes.c_ssize_t, *[ctypes.c_void_p, ctypes.c_ssize_t] * count]
    made: Callable[..., None] = address
    return made


def _scene(function: ArrayFunction) -> SceneFunctions:
    """The function as the only one of a scene."""
    return SceneFunctions(function.name, 0, 0, (), (), (), (),
                          (FunctionProgram(_NAME, function.name, function.program),))


def _symbol(scene: SceneFunctions, precision: Precision) -> str:
    return f"{scene.name}_xla{precision.suffix}"


def _handler(scene: SceneFunctions, function: ArrayFunction, precision: Precision
             ) -> dict[str, object]:
    return {"precision": precision, "name": _symbol(scene, precision),
            "function": c_name(many(scene), _NAME, precision),
            "arguments": range(len(function.inputs)), "results": range(len(function.shapes))}


def _opened(function: ArrayFunction, precision: Precision, texts: dict[str, str],
            unit: Sequence[str] = ()) -> ctypes.CDLL | None:
    """The library, opened such that its functions run without Python's global lock."""
    scene = _scene(function)
    with doing(f"writing {scene.name}"):
        text = source_text.of_many(scene)
    units = text.units((precision.name,))
    if unit:
        units["handler"] = (unit[0], *text.only(precision), *unit[1:])
    assert function.compile
    return function.compile(scene.name, units, {**text.files, **texts})
