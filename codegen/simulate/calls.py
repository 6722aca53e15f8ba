"""Compiled functions as Python calls them: arrays in, arrays out, broadcasting over leading axes."""

import ctypes
import functools
import inspect
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
    call = getattr(library, f"{name}_call")
    shapes = [shape for _, shape in (*described.read, *described.outputs)]
    call.argtypes = [ctypes.py_object if shape or n >= len(described.read) else
                     _REAL[precision.name] for n, shape in enumerate(shapes)]
    call.restype = ctypes.c_int
    many = _many(library, name, described, kind)
    signature = inspect.Signature([inspect.Parameter(x, inspect.Parameter.POSITIONAL_OR_KEYWORD)
                                   for x, _ in described.inputs])
    function = (_moving if described.moved else _returning)(call, many, described, kind, signature)
    function.__name__ = function.__qualname__ = described.name
    function.__signature__ = signature
    function.__doc__ = "\n\n".join(described.words)
    if described.moved:
        function.repeated = _repeated(library, name, kind)
    return function


def _repeated(library: ctypes.PyDLL, name: str, kind: np.dtype) -> Callable:
    """n steps of one state in one call: (n, t, h, p, q, v) -> (q, v)."""
    run = getattr(_unlocked(library._name), f"{name}_run")
    run.restype = None
    run.argtypes = [ctypes.c_ssize_t, ctypes.c_double, ctypes.c_double, *[ctypes.c_void_p] * 3]

    def function(n: int, t: float, h: float, p: np.ndarray, q: np.ndarray, v: np.ndarray
                 ) -> tuple[np.ndarray, np.ndarray]:
        p, q, v = (np.array(x, kind, order="C", ndmin=1) for x in (p, q, v))
        run(n, t, h, p.ctypes.data, q.ctypes.data, v.ctypes.data)
        return q, v

    return function


def _returning(call: Callable, many: Callable, described: scene_calls.Callable, kind: np.dtype,
               signature: inspect.Signature) -> Callable:
    count, shapes, empty = len(described.inputs), [s for _, s in described.outputs], np.empty
    single, shape = len(shapes) == 1, shapes[0]

    def function(*values, **named):
        if len(values) == count and not named:
            try:
                if single:
                    result = empty(shape, kind)
                    if call(*values, result):
                        return result if shape else result[()]
                else:
                    results = [empty(s, kind) for s in shapes]
                    if call(*values, *results):
                        return tuple(x[()] for x in results)
            except ctypes.ArgumentError:
                pass  # t or h is an array
        return many(_bound(signature, described.name, values, named))

    return function


def _moving(call: Callable, many: Callable, described: scene_calls.Callable, kind: np.dtype,
            signature: inspect.Signature) -> Callable:
    count, array = len(described.inputs), np.array

    def function(*values, **named):
        if len(values) == count and not named:
            q, v = values[-2], values[-1]
            if type(q) is np.ndarray and type(v) is np.ndarray:
                q, v = array(q), array(v)
                try:
                    if call(*values[:-2], q, v):
                        return q, v
                except ctypes.ArgumentError:
                    pass  # t or h is an array
        return many(_bound(signature, described.name, values, named))

    return function


def _bound(signature: inspect.Signature, name: str, values: tuple, named: dict) -> dict:
    try:
        return signature.bind(*values, **named).arguments
    except TypeError as error:
        raise TypeError(f"{name}{signature}: {error}") from None


def _many(library: ctypes.PyDLL, name: str, described: scene_calls.Callable,
          kind: np.dtype) -> Callable:
    """The function for any arguments: checked, cast, and broadcast."""
    loop = getattr(_unlocked(library._name), f"{name}_many")
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
            kept.append(np.ascontiguousarray(array))
            words += [kept[-1].ctypes.data, step]
        loop(*words, *(x.ctypes.data for x in results))
        found = tuple(x[()] for x in results)
        return found[0] if len(found) == 1 else found

    return function


@functools.cache
def _unlocked(path: str) -> ctypes.CDLL:
    """The library again, its functions called without Python's lock."""
    return ctypes.CDLL(path)
