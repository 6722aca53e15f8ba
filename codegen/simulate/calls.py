"""Compiled functions as Python callables on arrays, which broadcast over leading axes."""

import ctypes
import functools
from collections.abc import Callable, Iterator, Mapping
from math import prod
from types import ModuleType
from typing import TYPE_CHECKING, Generic, Protocol, TypeAlias, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from coscrew_codegen.formats import Precision
from coscrew_codegen.integrators import EMITTED
from coscrew_codegen.native import cache
from coscrew_codegen.scene.names import or_mean
from coscrew_codegen.scene.selected import names
from coscrew_codegen.scene_functions import SceneInterface, Signature
from coscrew_codegen.targets.scene_text import c_name, many, signs
from coscrew_codegen.tiers import tier_named

if TYPE_CHECKING:
    from coscrew._steps import Steps
    from coscrew_codegen.simulate.load import Kernels
else:
    Steps = Generic

_PLAIN = frozenset((float, np.float64, np.float32, np.int64, np.int32))
"""Types of t and h that are passed to C without a check."""

Real = TypeVar("Real", bound=np.floating, covariant=True)
Made: TypeAlias = Callable[..., object]
"""A function made at run time, whose parameters its Signature gives."""


class Function(Protocol[Real]):
    """A function of a scene with one result; its docstring names the arguments."""

    def __call__(self, *arguments: ArrayLike,
                 out: np.ndarray | tuple[np.ndarray | None] | None = ...,
                 **named: ArrayLike) -> NDArray[Real]:
        """The result, written to `out` if that is given."""


class Step(Protocol[Real]):
    """A step of an integrator."""

    def __call__(self, *arguments: ArrayLike,
                 out: tuple[np.ndarray | None, np.ndarray | None] | None = ...,
                 **named: ArrayLike) -> tuple[NDArray[Real], NDArray[Real]]:
        """q and v after the step, written to `out` if that is given."""


class Functions(Steps[Real]):
    """The functions of one precision as attributes."""

    if TYPE_CHECKING:  # shown by editors; others, such as jacobian_hand, have the same type
        inverse_dynamics: Function[Real]
        forward_dynamics: Function[Real]
        mass_matrix: Function[Real]
        bias_torques: Function[Real]
        gravity_torques: Function[Real]
        energy: Function[Real]
        power: Function[Real]
        momentum: Function[Real]
        body_poses: Function[Real]
        body_twists: Function[Real]
        integrated: Function[Real]

    def __init__(self, scene: str, precision: Precision, tier: str = ""):
        self._about = f"{scene} in {precision.name} precision{tier and f', {tier} tier'}"
        self._precision, self._tier = precision.name, tier
        self._kernels: Kernels | None = None  # that they belong to, for pickle

    def __dir__(self) -> list[str]:
        return [name for name in self.__dict__ if not name.startswith("_")]

    def __iter__(self) -> Iterator[str]:
        return iter(dir(self))

    def __getattr__(self, name: str) -> Function[Real]:
        if not dir(self):
            has = [p.name for p in tier_named(self._tier).precisions] if self._tier else []
            why = "the scene is of double precision alone, as it says"
            if has and self._precision not in has:
                why = f"the {self._tier} tier is of {has[0]} precision"
            raise AttributeError(f"{self._about} is not there: {why}", name=name, obj=self)
        scene = self._kernels.scene if self._kernels else None
        possible = names(scene) if scene else ()
        hint = or_mean(name, (*dir(self), *possible))
        if self._tier and name in {x.step_name for x in EMITTED}:
            hint = "; steps have no tier, since their error is not that of rounding"
            possible = ()
        if name in possible:
            hint = f"; it was not selected: functions=[\"default\", {name!r}]"
        raise AttributeError(f"{self._about} has no function {name!r}{hint}", name=name, obj=self)

    def __repr__(self) -> str:
        return f"<{self._about}: {', '.join(dir(self))}>"

    def __reduce__(self) -> tuple[Made, tuple[object, str]]:
        return getattr, (self._kernels, self._precision)

    def __copy__(self) -> "Functions[Real]":
        return self

    def __deepcopy__(self, memo: dict[int, object]) -> "Functions[Real]":
        return self


class _Callable:
    """A function of a scene, as an object whose __reduce__ pickle and cloudpickle use."""

    def __init__(self, of: Functions[np.floating], function: Made):
        self.__dict__.update(vars(function))
        self.__name__ = self.__qualname__ = function.__name__
        self._of = of
        if repeated := vars(function).get("repeated"):
            self.repeated = functools.partial(repeated, self)

    def __reduce__(self) -> tuple[Made, tuple[Functions[np.floating], str]]:
        return getattr, (self._of, self.__name__)

    def __repr__(self) -> str:
        return f"<{self.__name__} of {self._of._about}>"


def gathered(scene: SceneInterface, precision: Precision,
             functions: Mapping[str, Made]) -> Functions[np.floating]:
    """The functions, whose first argument is `self`, as methods of one object."""
    found: Functions[np.floating] = Functions(scene.name, precision, scene.mark)
    for name, function in functions.items():
        members = {"__call__": function, "__doc__": function.__doc__, "__module__": __name__}
        found.__dict__[name] = type(name, (_Callable,), members)(found, function)
    return found


@functools.cache
def _checks() -> ModuleType:
    """The checks of generated packages."""
    def text() -> str:
        from coscrew_codegen.render import render  # imports Jinja

        return render("scene/arrays.py", banner="in memory")

    module = ModuleType("coscrew_scene_arrays")
    exec(cache.text("checks", text), module.__dict__)
    return module


def compiled(scene: SceneInterface, library: ctypes.PyDLL, described: Signature,
             precision: Precision) -> Made:
    """A function of the library, with the same name and arguments after `self`."""
    kind, name = np.dtype(precision.numpy_type), c_name(scene, described.name, precision)
    getattr(library, f"know_{precision.name}")(ctypes.py_object(np.ndarray))
    call = getattr(library, f"call_{name}")
    shapes = [shape for _, shape in (*described.read, *described.outputs)]
    call.argtypes = [ctypes.py_object if shape or n >= len(described.read) else ctypes.c_double
                     for n, shape in enumerate(shapes)]
    call.restype = ctypes.c_int
    several = c_name(many(scene), described.name, precision)
    names = {"call": call, "many": _many(library, name, several, described, kind, call,
                                         signs(scene)),
             "empty": np.empty, "plain": _PLAIN, "kind": kind, "Refused": ctypes.ArgumentError}
    exec(_text(described), names)
    function = _described(names[described.name], described)
    if described.moved:
        run = c_name(many(scene), described.name.replace("step", "run", 1), precision)
        vars(function)["repeated"] = _repeated(library, name, run, described, kind)
    return function


def in_numpy(twin: Made, described: Signature) -> Made:
    """A function of a generated package, with the same name and arguments after `self`."""
    given = ", ".join(x for x, _ in described.inputs)
    names = {"twin": twin}
    exec(f"def {described.name}(self, {given}, *, out=None):\n    return twin({given}, out=out)\n",
         names)
    return _described(names[described.name], described)


def _described(function: Made, described: Signature) -> Made:
    function.__doc__ = "\n\n".join(described.words)
    return function


def _repeated(library: ctypes.PyDLL, name: str, several: str, described: Signature, kind: np.dtype
              ) -> Made:
    """n steps in one call: (n, t, h, p, q, v) -> (q, v).  Leading axes of p, q and v, of any that
    have them, are states; `several` is the name of the function in lanes."""
    run = getattr(_unlocked(library._name), f"run_{name}")
    run.restype = None
    run.argtypes = [ctypes.c_ssize_t, ctypes.c_double, ctypes.c_double, *[ctypes.c_void_p] * 3]

    def function(of: _Callable, n: int, t: float, h: float, p: np.ndarray, q: np.ndarray,
                 v: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        p, q, v = (np.array(x, kind, order="C", ndmin=1) for x in (p, q, v))
        lead = np.broadcast_shapes(*(x.shape[:-1] for x in (p, q, v)))
        q, v = _over_all(q, lead), _over_all(v, lead)
        strides = {"p": p.shape[-1] if p.ndim > 1 else 0, "q": q.shape[-1], "v": v.shape[-1]}
        p = _over_all(p, lead) if p.ndim > 1 else p
        states, kernels = prod(lead), of._of._kernels
        rows = {"p": p.ctypes.data, "q": q.ctypes.data, "v": v.ctypes.data}
        lanes = kernels._lanes.function(several, states * n) if lead and kernels else None
        if lanes:
            scalars = [ctypes.c_double(x) for name, x in (("t", t), ("h", h))
                       if name in dict(described.inputs)]
            lanes(*map(ctypes.c_ssize_t, (states, n)), *scalars, *(
                ctypes.c_ssize_t(x) for name, _ in described.inputs if name in rows
                for x in (rows[name], strides[name])))
            return q, v
        for k in range(states):
            run(n, t, h, *(rows[x] + k * strides[x] * kind.itemsize for x in rows))
        return q, v

    return function


def _over_all(rows: np.ndarray, lead: tuple[int, ...]) -> np.ndarray:
    """A row for every state, each of its own."""
    return np.array(np.broadcast_to(rows, (*lead, rows.shape[-1])), order="C")


def _text(described: Signature) -> str:
    """The text of a function.  With its arguments spelled out it is half a microsecond faster than
    with *values, and Python itself refuses missing and unknown ones."""
    given = [x for x, _ in described.inputs]
    results = [f"result_{n}" for n in range(len(described.outputs))]
    made = [f"{x}.copy()" if described.moved else f"empty({shape}, kind)"
            for x, shape in described.outputs]  # copies that a step changes, or empty results
    if len(made) == 1:
        made = [f"{made[0]} if out is None else out"]
    wanted = [f"type({x}) in plain" for x, shape in described.read if not shape]
    wanted += ["out is None"] if len(made) > 1 else []
    wanted.append(f"call({', '.join((*(x for x, _ in described.read), *results))})")
    found = ", ".join(x if shape else f"{x}[()] if out is None else out"
                      for x, (_, shape) in zip(results, described.outputs, strict=True))
    return "\n".join((
        f"def {described.name}(self, {', '.join(given)}, *, out=None):",
        "    try:",
        *(f"        {x} = {value}" for x, value in zip(results, made, strict=True)),
        f"        if {' and '.join(wanted)}:",
        f"            return {found}",
        "    except (Refused, AttributeError, TypeError):",
        "        pass  # an argument without copy(), or not a number: the checks below say so",
        f"    return many(self, {{{', '.join(f'{x!r}: {x}' for x in given)}}}, out)", ""))


def _many(library: ctypes.PyDLL, name: str, several: str, described: Signature, kind: np.dtype,
          call: Made, signs: tuple[tuple[int, str, bool], ...]) -> Made:
    """The function for any arguments, which it checks, casts and broadcasts; `several` is the name
    of that in lanes."""
    loop = getattr(_unlocked(library._name), f"many_{name}")
    loop.restype = None
    pointer, stride = ctypes.c_void_p, ctypes.c_ssize_t
    loop.argtypes = [stride, *[pointer, stride] * len(described.read),
                     *[pointer] * len(described.outputs)]
    checks = _checks()

    def function(of: _Callable | None, arguments: Mapping[str, ArrayLike], out: object) -> object:
        lead, arrays = checks.arrays(kind, **{
            x: (arguments[x], shape, *([signs] if x == "p" else []))
            for x, shape in described.inputs})
        given = dict(zip(arguments, arrays, strict=True))
        shapes = [(*lead, *shape) for _, shape in described.outputs]
        results = [x if _is_place(x, kind, arrays) else np.empty(shape, kind)
                   for x, shape in zip(checks.places(out, shapes, kind), shapes, strict=True)]
        if described.moved:
            for (x, _), result in zip(described.outputs, results, strict=True):
                result[...] = given[x]
        if lead or not call(*(np.array(given[x]) if shape else float(given[x])
                              for x, shape in described.read), *results):
            kernels = of._of._kernels if of else None
            lanes = kernels._lanes.function(several, prod(lead)) if kernels else None
            _over(loop, lanes, lead, given, described, results)
        return checks.delivered(out, *(x[()] for x in results))

    return function


def _is_place(x: np.ndarray | None, kind: np.dtype, arrays: list[np.ndarray]) -> bool:
    """Whether C may write to `x` while it reads the arrays."""
    return (x is not None and x.dtype == kind and x.flags.carray
            and not any(np.may_share_memory(x, array) for array in arrays))


def _over(loop: Made, lanes: Made | None, lead: tuple[int, ...], given: dict[str, np.ndarray],
          described: Signature, results: list[np.ndarray]) -> None:
    """Call the loop over all states, or the function in lanes."""
    words: list[int] = [prod(lead)]
    kept = []
    for x, shape in described.read:
        array, step = given[x], 0
        if array.ndim > len(shape):
            array, step = np.broadcast_to(array, (*lead, *shape)), prod(shape)
        kept.append(np.require(array, None, ("C", "A")))
        words += [kept[-1].ctypes.data, step]
    if lanes is None:
        loop(*words, *(x.ctypes.data for x in results))
        return
    for result, (_, shape) in zip(results, described.outputs, strict=True):
        words += [result.ctypes.data, prod(shape)]
    lanes(*map(ctypes.c_ssize_t, words))


@functools.cache
def _unlocked(path: str) -> ctypes.CDLL:
    """The library opened so that its functions run without Python's global lock."""
    return ctypes.CDLL(path)
