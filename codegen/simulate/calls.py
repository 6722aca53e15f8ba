"""Compiled functions as Python calls them: arrays in, arrays out, broadcast over leading axes."""

import ctypes
import functools
from collections.abc import Callable, Iterator, Mapping
from difflib import get_close_matches
from math import prod
from types import ModuleType

import numpy as np

from coscrew_codegen.scene_functions import SceneFunctions
from coscrew_codegen.render import render
from coscrew_codegen.targets import scene_calls
from coscrew_codegen.targets.precision import Precision
from coscrew_codegen.targets.scene_c import c_name

_REAL = {"double": ctypes.c_double, "single": ctypes.c_float}


class Functions:
    """The functions of one precision as attributes."""

    def __init__(self, scene: str, precision: Precision, functions: Mapping[str, Callable]):
        self._about = f"{scene} in {precision.name} precision"
        self.__dict__.update(functions)

    def __dir__(self) -> list[str]:
        return [name for name in self.__dict__ if not name.startswith("_")]

    def __iter__(self) -> Iterator[str]:
        return iter(dir(self))

    def __getattr__(self, name: str) -> Callable:
        if not dir(self):
            raise AttributeError(f"{self._about} is not there: the scene is of double precision "
                                 "alone, as it says", name=name, obj=self)
        near = get_close_matches(name, dir(self), n=1, cutoff=0.0)
        hint = f": did you mean {near[0]!r}?" if near else ""
        raise AttributeError(f"{self._about} has no function {name!r}{hint}", name=name, obj=self)

    def __repr__(self) -> str:
        return f"<{self._about}: {', '.join(dir(self))}>"


@functools.cache
def _checks() -> ModuleType:
    """The checks of generated packages."""
    module = ModuleType("coscrew_scene_arrays")
    exec(render("scene/arrays.py", banner="in memory"), module.__dict__)
    return module


def compiled(scene: SceneFunctions, library: ctypes.PyDLL, described: scene_calls.Callable,
             precision: Precision) -> Callable:
    """A function of the library as a Python function of the same name and arguments."""
    kind, name = np.dtype(precision.numpy_type), c_name(scene, described.name, precision)
    call = getattr(library, f"call_{name}")
    shapes = [shape for _, shape in (*described.read, *described.outputs)]
    call.argtypes = [ctypes.py_object if shape or n >= len(described.read) else
                     _REAL[precision.name] for n, shape in enumerate(shapes)]
    call.restype = ctypes.c_int
    names = {"call": call, "many": _many(library, name, described, kind), "empty": np.empty,
             "array": np.array, "kind": kind, "Refused": ctypes.ArgumentError}
    exec(_text(described), names)
    function = names[described.name]
    function.__doc__ = "\n\n".join(described.words)
    if described.moved:
        function.repeated = _repeated(library, name, kind)
    return function


def _repeated(library: ctypes.PyDLL, name: str, kind: np.dtype) -> Callable:
    """n steps of one state in one call: (n, t, h, p, q, v) -> (q, v)."""
    run = getattr(_unlocked(library._name), f"run_{name}")
    run.restype = None
    run.argtypes = [ctypes.c_ssize_t, ctypes.c_double, ctypes.c_double, *[ctypes.c_void_p] * 3]

    def function(n: int, t: float, h: float, p: np.ndarray, q: np.ndarray, v: np.ndarray
                 ) -> tuple[np.ndarray, np.ndarray]:
        p, q, v = (np.array(x, kind, order="C", ndmin=1) for x in (p, q, v))
        run(n, t, h, p.ctypes.data, q.ctypes.data, v.ctypes.data)
        return q, v

    return function


def _text(described: scene_calls.Callable) -> str:
    """The text of a function: with arguments spelled out, it takes half a microsecond less than
    with *values, and Python itself refuses missing and unknown ones."""
    given = [x for x, _ in described.inputs]
    made = [f"array({x})" if described.moved else f"empty({shape}, kind)"
            for x, shape in described.outputs]  # copies, which a step moves; or results' room
    results = [f"result_{n}" for n in range(len(made))]
    passed = ", ".join((*(x for x, _ in described.read), *results))
    found = ", ".join(x if shape else f"{x}[()]"
                      for x, (_, shape) in zip(results, described.outputs, strict=True))
    return "\n".join((
        f"def {described.name}({', '.join(given)}):",
        "    try:",
        *(f"        {x} = {value}" for x, value in zip(results, made, strict=True)),
        f"        if call({passed}):",
        f"            return {found}",
        "    except (Refused, ValueError):",
        "        pass  # t or h is an array, or what cannot be one came: the checks tell",
        f"    return many({{{', '.join(f'{x!r}: {x}' for x in given)}}})", ""))


def _many(library: ctypes.PyDLL, name: str, described: scene_calls.Callable,
          kind: np.dtype) -> Callable:
    """The function for any arguments: checked, cast, and broadcast."""
    loop = getattr(_unlocked(library._name), f"many_{name}")
    loop.restype = None
    pointer, stride = ctypes.c_void_p, ctypes.c_ssize_t
    loop.argtypes = [stride, *[pointer, stride] * len(described.read),
                     *[pointer] * len(described.outputs)]

    def function(arguments: dict) -> object:
        lead, arrays = _checks().arrays(kind, **{
            x: (arguments[x], shape) for x, shape in described.inputs})
        given = dict(zip(arguments, arrays, strict=True))
        results = [np.empty((*lead, *shape), kind) for _, shape in described.outputs]
        if described.moved:
            for (x, _), result in zip(described.outputs, results, strict=True):
                result[...] = given[x]
        words: list[int] = [prod(lead)]
        kept = []
        for x, shape in described.read:
            array, step = given[x], 0
            if array.ndim > len(shape):
                array, step = np.broadcast_to(array, (*lead, *shape)), prod(shape)
            kept.append(np.require(array, None, ("C", "A")))
            words += [kept[-1].ctypes.data, step]
        loop(*words, *(x.ctypes.data for x in results))
        found = tuple(x[()] for x in results)
        return found[0] if len(found) == 1 else found

    return function


@functools.cache
def _unlocked(path: str) -> ctypes.CDLL:
    """The library again, its functions called without Python's lock."""
    return ctypes.CDLL(path)
