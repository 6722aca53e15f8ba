"""Compiled functions as Python callables on arrays, which broadcast over leading axes; arguments in
order or by name, with errors that name the missing one."""

import ctypes
import functools
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import combinations
from types import MethodType, ModuleType
from typing import TYPE_CHECKING, Generic, Protocol, TypeAlias, TypeVar, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from coscrew_codegen.accuracy.tiers import tier_named
from coscrew_codegen.program.scene_functions import (
    SceneInterface,
    Signature,
    c_name,
    many,
    signs,
)
from coscrew_codegen.program.text_module import imported
from coscrew_codegen.program.values.formats import Precision
from coscrew_codegen.runtime import compiled_calls
from coscrew_codegen.runtime.caller_warnings import at_callers_line
from coscrew_codegen.scene.function_selection import all_names, dividing
from coscrew_codegen.scene.integrators import EMITTED
from coscrew_codegen.scene.mechanism.inertia_checks import why_singular
from coscrew_codegen.scene.names import or_mean

if TYPE_CHECKING:
    import inspect

    from coscrew._functions import NamedFunctions
    from coscrew_codegen.runtime.load import Kernels
else:
    NamedFunctions = Generic

_PLAIN = frozenset((float, np.float64, np.float32, np.int64, np.int32))
"""Types of t and h that are passed to C without a check."""
_OF_STEPS = frozenset(("repeated", "sampled", "finer", "driven"))
"""Methods of steps that are compiled."""

Real = TypeVar("Real", bound=np.floating, covariant=True)
Made: TypeAlias = Callable[..., object]
"""A function made at run time, whose parameters its Signature gives."""


class Function(Protocol[Real]):
    """A function of a scene with one result; its docstring names the arguments."""

    def __call__(self, *arguments: ArrayLike,
                 out: np.ndarray | tuple[np.ndarray | None] | None = ...,
                 threads: int = ..., **named: ArrayLike) -> NDArray[Real]:
        """The result, written to `out` if that is given; `threads` share the states of leading
        axes."""


class Step(Protocol[Real]):
    """A step of an integrator."""

    def __call__(self, *arguments: ArrayLike,
                 out: tuple[np.ndarray | None, np.ndarray | None] | None = ...,
                 threads: int = ..., **named: ArrayLike) -> tuple[NDArray[Real], NDArray[Real]]:
        """q and v after the step, written to `out` if that is given; `threads` share the states of
        leading axes."""


class Functions(NamedFunctions[Real]):
    """The functions of one precision as attributes."""

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
        possible = all_names(scene) if scene else ()
        hint = or_mean(name, (*dir(self), *possible))
        if self._tier and name in {y for x in EMITTED for y in (x.step_name, x.step_with_tau)}:
            hint = "; steps have no tier, since their error is not that of rounding"
            possible = ()
        if name in possible:
            hint = f"; it was not selected: functions=[\"default\", {name!r}]"
        elif scene and name in dividing(scene, (name,)) and (problem := why_singular(scene)):
            hint = f": {problem}"
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
        self._of, self._checked = of, MethodType(function, self)
        for name in _OF_STEPS & vars(function).keys():
            setattr(self, name, MethodType(vars(function)[name], self))

    @property
    def __signature__(self) -> "inspect.Signature":
        import inspect

        return inspect.signature(self._checked)

    def __reduce__(self) -> tuple[Made, tuple[Functions[np.floating], str]]:
        return getattr, (self._of, self.__name__)

    def __repr__(self) -> str:
        return f"<{self.__name__} of {self._of._about}>"


def gathered(scene: SceneInterface, precision: Precision,
             functions: Mapping[str, Made]) -> Functions[np.floating]:
    """The functions, whose first argument is `self`, as methods of one object."""
    all_functions: Functions[np.floating] = Functions(scene.name, precision, scene.mark)
    for name, function in functions.items():
        in_c, words = (vars(function).pop(x, None) for x in ("in_c", "words"))
        members = {"__call__": function, "__doc__": words, "__module__": __name__}
        made = type(name, (_Callable,), members)(all_functions, function)
        if in_c:
            type.__setattr__(type(made), "__call__", in_c(made._checked))
        all_functions.__dict__[name] = made
    return all_functions


@functools.cache
def checks(text: str) -> ModuleType:
    """The checks of arguments in generated packages."""
    return imported("coscrew_scene_arrays", text)


def compiled(scene: SceneInterface, library: ctypes.PyDLL, checked_by: ModuleType,
             described: Signature, precision: Precision) -> Made:
    """A function of the library, with the same name and arguments after `self`.  It checks them;
    its `in_c` makes of it the function in C that calls it where arguments want a check."""
    kind, name = np.dtype(precision.numpy_type), c_name(scene, described.name, precision)
    loop = getattr(_unlocked(library._name), f"many_{name}")
    loop.restype, loop.argtypes = None, [ctypes.c_ssize_t, *[ctypes.c_void_p] * 4, ctypes.c_ssize_t]
    in_c = functools.partial(_in_c, library, name, described, precision)
    of_rows = compiled_calls.CompiledFunction(described, kind, in_c(_declined), loop, checked_by,
                                              signs(scene))
    in_lanes = _lanes(library, name, c_name(many(scene), described.name, precision))

    def checked(of: _Callable | None, arguments: Mapping[str, ArrayLike], out: object,
                threads: object) -> object:
        kernels = of._of._kernels if of else None
        return of_rows(arguments, out, threads, functools.partial(in_lanes, kernels))

    function = _written(described, checked)
    vars(function)["in_c"] = in_c
    if described.repeats:
        several = c_name(many(scene), described.name.replace("step", "run", 1), precision)
        vars(function).update(_many_steps(library, name, several, described, precision,
                                          checked_by, signs(scene)))
    return function


def _declined(*_: object, **__: object) -> object:
    return NotImplemented


def _in_c(library: ctypes.PyDLL, name: str, described: Signature, precision: Precision,
          checked: Made) -> Made:
    """The function in C, which calls `checked` for arguments that it cannot take."""
    getattr(library, f"know_{precision.name}")(ctypes.c_size_t(object.__basicsize__))
    make = getattr(library, f"new_{name}")
    make.restype, make.argtypes = ctypes.py_object, [ctypes.py_object]
    kind = np.dtype(precision.numpy_type)
    results = tuple((shape, kind) for _, shape in described.outputs)
    names = tuple(sys.intern(x) for x in (*(x for x, _ in described.inputs), "out", "threads"))
    function: Made = make((checked, np.ndarray, _PLAIN, int, np.empty, results, names))
    return function


def _lanes(library: ctypes.PyDLL, name: str, several: str) -> Callable[["Kernels | None", int],
                                                                       None]:
    """Returns a callback that installs the function of many states, named `several`, once it is
    compiled and pays."""
    place = ctypes.c_void_p.in_dll(library, f"lanes_{name}")

    def prepare(kernels: "Kernels | None", states: int) -> None:
        if kernels and not place.value:
            with at_callers_line(above=3):  # CompiledFunction.__call__, checked, function
                loop = kernels._lanes.function(several, states)
            if loop:
                place.value = ctypes.cast(loop, ctypes.c_void_p).value

    return prepare


def in_numpy(twin: Made, described: Signature) -> Made:
    """A function of a generated package, with the same name and arguments after `self`; one thread
    computes."""
    def checked(of: _Callable, arguments: Mapping[str, ArrayLike], out: object, threads: object
                ) -> object:
        compiled_calls.positive(threads)
        return twin(**arguments, out=out)

    return _written(described, checked)


def _written(described: Signature, checked: Made) -> Made:
    """A function of `self` and of arguments in order or by name, whose signature is spelled out."""
    name, inputs = described.name, described.inputs

    def function(self: object, *given: ArrayLike, out: object = None, threads: object = 1,
                 **named: ArrayLike) -> object:
        return checked(self, bound(name, inputs, given, named), out, threads)

    function.__name__ = function.__qualname__ = name
    vars(function)["__signature__"] = _signature(tuple(x for x, _ in inputs))
    return _described(function, described)


def _signature(names: tuple[str, ...]) -> "inspect.Signature":
    from inspect import Parameter, Signature

    either, by_name = Parameter.POSITIONAL_OR_KEYWORD, Parameter.KEYWORD_ONLY
    return Signature([*(Parameter(x, either) for x in ("self", *names)),
                      Parameter("out", by_name, default=None),
                      Parameter("threads", by_name, default=1)])


def _described(function: Made, described: Signature) -> Made:
    vars(function)["words"] = function.__doc__ = "\n\n".join(described.words)
    return function


def _many_steps(library: ctypes.PyDLL, name: str, several: str, described: Signature,
                precision: Precision, checked_by: ModuleType,
                signed: tuple[tuple[int, str, bool], ...]) -> dict[str, Made]:
    """Methods of a step that take many steps in one call."""
    its = compiled_calls.steps(_unlocked(library._name), name, several, described,
                               np.dtype(precision.numpy_type), checked_by, signed, precision.name)

    def repeated(self: _Callable, n: int, t: float, h: float, p: ArrayLike, q: ArrayLike,
                 v: ArrayLike, *, threads: int = 1) -> tuple[np.ndarray, np.ndarray]:
        """q and v after n steps of h, the first of them at t.

        t and p are given even if the scene does not use them.  Leading axes of p, q and v, of any
        that have them, are states, which `threads` share."""
        return its.repeated(self._of, n, t, h, p, q, v, threads)

    def sampled(self: _Callable, takes: Sequence[compiled_calls.Take], p: np.ndarray, q: np.ndarray,
                v: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """q and v of one state after each of consecutive (n, t, h): n steps of h, the first of them
        at t.  p, q and v are not checked."""
        return its.sampled(takes, p, q, v)

    def finer(self: _Callable, takes: Sequence[compiled_calls.Take], p: np.ndarray, q: np.ndarray,
              v: np.ndarray, factor: int) -> tuple[np.ndarray, np.ndarray]:
        """Likewise, each step split as one longer by the factor would be."""
        return its.sampled(takes, p, q, v, factor)

    def driven(self: _Callable, by: compiled_calls.InC, n: int, t: float, h: float, p: np.ndarray,
               q: np.ndarray, v: np.ndarray) -> compiled_calls.Driven:
        """p, q and v after n steps under a controller in C, and the first value of the controller
        that is not finite."""
        return its.driven(self._of, by, n, t, h, p, q, v)

    methods: dict[str, Made] = {"repeated": repeated, "sampled": sampled}
    methods |= {"finer": finer} if its.finer else {}
    return methods | ({"driven": driven} if its.drive else {})


@functools.cache
def _unlocked(path: str) -> ctypes.CDLL:
    """The library opened so that its functions run without Python's global lock."""
    return ctypes.CDLL(path)


Shape = tuple[int, ...]
Given = TypeVar("Given")


def bound(function: str, inputs: Sequence[tuple[str, Shape]], given: Sequence[Given],
          named: Mapping[str, Given]) -> dict[str, Given]:
    """The arguments by name, in the order of `inputs`, which holds names and shapes of last axes.

    Raises TypeError for missing, repeated and unknown ones.  If arguments are given in order, the
    missing one is the one whose omission makes the others' shapes fit."""
    names = [name for name, _ in inputs]
    if len(given) == len(names) and not named:
        return dict(zip(names, given, strict=True))
    head = f"{function}({', '.join(names)})"
    wanted = "; wanted " + (", ".join(f"{name} {shape}" for name, shape in inputs) or "none")
    if unknown := [name for name in named if name not in names]:
        raise TypeError(f"{head}: no argument {unknown[0]!r}{or_mean(unknown[0], names)}{wanted}")
    if len(given) > len(names):
        raise TypeError(f"{head}: got {len(given)} arguments{wanted}")
    if missing := len(names) - len(given) - len(named):
        raise TypeError(f"{head}: {_missing(inputs, given, named, missing)}{wanted}")
    arguments = dict(zip(names, given, strict=False))
    if twice := [name for name in named if name in arguments]:
        raise TypeError(f"{head}: {twice[0]} is given twice, in order and by name{wanted}")
    arguments.update(named)
    return {name: arguments[name] for name in names}


def _missing(inputs: Sequence[tuple[str, Shape]], given: Sequence[object],
             named: Mapping[str, object], count: int) -> str:
    """"p is missing", if shapes show it; else the number of arguments."""
    others = [x for x in inputs if x[0] not in named]
    fitting = [kept for kept in combinations(others, len(given))
               if all(_fits(x, shape) for x, (_, shape) in zip(given, kept, strict=True))]
    got = f"got {len(given) + len(named) or 'no'} argument{'s' * (len(given) + len(named) != 1)}"
    if len(fitting) == 1:
        lost = [name for name, _ in others if name not in {kept for kept, _ in fitting[0]}]
        return f"{' and '.join(lost)} {'is' if count == 1 else 'are'} missing; {got}"
    return f"{count} of {', '.join(name for name, _ in others)} {'is' if count == 1 else 'are'} " \
           f"missing; {got}"


def _fits(x: object, shape: Shape) -> bool:
    """Returns whether the last axes have these lengths; a number has no axes."""
    try:
        actual: Shape = tuple(np.shape(cast("ArrayLike", x)))
    except ValueError:  # nested lists of several lengths
        return False
    return actual[len(actual) - len(shape):] == shape if shape else not actual
