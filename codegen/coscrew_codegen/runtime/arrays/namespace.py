"""Namespaces of functions on arrays: of a scene, of the library."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from functools import cache, partial
from importlib import import_module
from types import ModuleType
from typing import Any

from coscrew_codegen.algebra.lowering.programs import program_of, smooth_program
from coscrew_codegen.algebra.operations import OPERATIONS, Operation
from coscrew_codegen.backends.scene import scene_text
from coscrew_codegen.program import Program
from coscrew_codegen.program.scene_functions import (
    IntegratorStep,
    SceneFunctions,
    SceneInterface,
    Split,
)
from coscrew_codegen.program.values.formats import BY_NAME
from coscrew_codegen.runtime.arrays.array_function import ArrayFunction, Compile
from coscrew_codegen.runtime.arrays.array_libraries import Backend, backend_of
from coscrew_codegen.runtime.arrays.checks import ArraySignature, checked
from coscrew_codegen.runtime.arrays.standard import ArrayLibrary, Shape, library_of
from coscrew_codegen.runtime.caller_warnings import at_callers_line
from coscrew_codegen.scene.names import or_mean

Made = Callable[..., Any]
"""A function of arrays, whose arguments its docstring names."""
Pickled = tuple[Callable[..., object], tuple[object, ...]]
"""As `__reduce__` returns it."""
Others = Callable[[str], "SceneFunctions | None"]
"""Derives the function of this name; None if the scene cannot have it."""


class Arrays:
    """Functions on arrays of one library, as attributes; each is made on first use.  A copy is the
    same object; a pickle holds a function that returns it, and its arguments."""

    def __init__(self, about: str, pickled: Pickled, makers: Mapping[str, Callable[[], Made]],
                 missing: Mapping[str, str] | None = None):
        self._about, self._makers, self._missing = about, makers, missing or {}
        self._pickled = pickled

    def __dir__(self) -> list[str]:
        return sorted(self._makers)

    def __iter__(self) -> Iterator[str]:
        return iter(dir(self))

    def __getattr__(self, name: str) -> Made:
        if name in self._makers:
            vars(self)[name] = made = self._makers[name]()
            return made
        hint = self._missing.get(name) or or_mean(name, tuple(self._makers))
        raise AttributeError(f"{self._about} has no function {name!r}{hint}", name=name, obj=self)

    def __reduce__(self) -> Pickled:
        return self._pickled

    def __copy__(self) -> Arrays:
        return self

    def __deepcopy__(self, memo: dict[int, object]) -> Arrays:
        return self

    def __repr__(self) -> str:
        return f"<{self._about}: {', '.join(self)}>"


def of_scene(xp: ModuleType, interface: SceneInterface, functions: Callable[[], SceneFunctions],
             on_numpy: Mapping[str, object], compile: Compile, kernels: object,
             others: Others = lambda name: None) -> Arrays:
    """The functions of a scene, and steps of integrators, on arrays of a library; `on_numpy` has
    them on NumPy's, by precision; `others` derives functions that are not selected.  They are
    pickled as those of `kernels`.  Raises TypeError for anything but a namespace of arrays, and for
    functions of a tier."""
    library = library_of(xp)
    if interface.mark:
        raise TypeError(f"arrays: the functions of the {interface.mark} tier are in C and NumPy "
                        "alone; wanted kernels without a tier")
    about = f"{interface.name} on arrays of {library.name}"
    pickled = _again, (kernels, xp.__name__)
    if library.name == "numpy":
        return Arrays(about, pickled, {x.name: partial(
            _of_numpy, ArraySignature(x.name, x.inputs, interface.precisions), "\n\n".join(x.words),
            library, {name: getattr(on_numpy[name], x.name) for name in interface.precisions})
            for x in interface.signatures})
    made = _OfScene(functions(), library, backend_of(library), compile, others)
    steps = {x.name: partial(made.step, x) for x in made.scene.steps if not _divides(x)}
    single = {f.name: partial(made.function, f.name) for f in made.scene.functions
              if not f.internal}
    return Arrays(about, pickled, single | steps,
                  {x.name: "; where each state divides the step as it needs, C and NumPy have it "
                   "alone" for x in made.scene.steps if _divides(x)})


@cache
def of_library(xp: ModuleType, on_numpy: ModuleType) -> Arrays:
    """The library's operations on arrays of a library; `on_numpy` has them on NumPy's."""
    library = library_of(xp)
    pickled = _again, (on_numpy.__name__, xp.__name__)
    return Arrays(f"coscrew on arrays of {library.name}", pickled, {
        x.name: partial(_of_operation, x, library, on_numpy) for x in OPERATIONS
        if hasattr(on_numpy, x.name)})


def _again(owner: Any, library: str) -> Arrays:
    """The functions of kernels, or of a module with this name, on arrays of a library."""
    arrays: Arrays = (import_module(owner) if isinstance(owner, str) else owner).arrays(
        import_module(library))
    return arrays


def _of_operation(operation: Operation, library: ArrayLibrary, on_numpy: ModuleType) -> Made:
    words = f"{operation.statement}.\n\n{operation.signature}."
    if library.name == "numpy":
        signature = ArraySignature(operation.name, tuple(
            (a.name, tuple(a.quantity.shape)) for a in operation.inputs), tuple(BY_NAME))
        function = getattr(on_numpy, operation.name)
        return _of_numpy(signature, words, library, dict.fromkeys(BY_NAME, function))
    made = ArrayFunction(operation.name, program_of(operation), smooth_program(operation))
    return _called(made, operation.name, words, tuple(BY_NAME), library, backend_of(library))


class _OfScene:
    """Makes functions of a scene, each once."""

    def __init__(self, scene: SceneFunctions, library: ArrayLibrary, backend: Backend,
                 compile: Compile, others: Others):
        self.scene, self._library, self._backend = scene, library, backend
        self._compile, self._others = compile, others
        self._made: dict[str, Made] = {}
        self._functions: dict[str, ArrayFunction] = {}

    def function(self, name: str) -> Made:
        if name not in self._made:
            self._made[name] = _called(
                self._array_function(name), name,
                "\n\n".join(scene_text.words(self.scene.named(name))),
                self.scene.precisions, self._library, self._backend)
        return self._made[name]

    def _array_function(self, name: str) -> ArrayFunction:
        """The function, with its derivatives if the scene can have them."""
        if name not in self._functions:
            program = self.scene.named(name).program
            self._functions[name] = ArrayFunction(
                f"{self.scene.name}_{name}", program, compile=self._compile,
                derivatives=lambda: self._derivatives(f"{name}_derivatives", program))
        return self._functions[name]

    def _derivatives(self, name: str, program: Program) -> ArrayFunction | None:
        """The function of this name, selected or not, if it gives the derivatives of each result of
        a program by each input; those along velocities are those by coordinates where these are
        plain numbers."""
        if self.scene.nq != self.scene.nv or {"t", "p"} & {a.name for a in program.inputs}:
            return None
        scene = self.scene if self.scene.has(name) else self._others(name)
        if scene is None or (f := scene.named(name)).inputs != program.inputs or [
                a.quantity.size for a in f.program.outputs] != [
                y.quantity.size * x.quantity.size for y in program.outputs for x in program.inputs]:
            return None
        return ArrayFunction(f"{scene.name}_{name}", f.program, compile=self._compile)

    def step(self, step: IntegratorStep) -> Made:
        shapes, library = scene_text.step_shapes(self.scene), self._library
        names = scene_text.step_inputs(self.scene, step.takes_tau)
        signature = ArraySignature(step.name, tuple((x, shapes[x]) for x in names),
                                   self.scene.precisions)

        def function(*given: Any, **by_name: Any) -> Any:
            lead, arrays, _ = checked(signature, library, signature.bound(given, by_name))
            with at_callers_line():
                return stepped(lead, arrays)

        def stepped(lead: Shape, arrays: list[Any]) -> tuple[Any, Any]:
            values = dict(zip(names, arrays, strict=True))
            for x in ("q", "v"):
                values[x] = library.xp.broadcast_to(values[x], (*lead, *shapes[x]))
            values |= {x: library.xp.zeros_like(values["v"]) for x in step.zeros}
            for call in step.calls:
                taken = [a.name for a in self.scene.named(call.function).program.inputs]
                results = self.function(call.function)(
                    *(values[dict(call.given).get(x, x)] for x in taken))
                several = results if len(call.results) > 1 else (results,)
                values.update(zip(call.results, several, strict=True))
            return values["q"], values["v"]

        return _described(function, step.name, "\n\n".join(scene_text.step_words(self.scene, step)))


def _divides(step: IntegratorStep) -> bool:
    return any(isinstance(x, Split) for x in step.body)


def _called(made: ArrayFunction, name: str, words: str, precisions: tuple[str, ...],
            library: ArrayLibrary, backend: Backend) -> Made:
    signature = ArraySignature(name, made.inputs, precisions)

    def function(*given: Any, **by_name: Any) -> Any:
        lead, arrays, precision = checked(signature, library, signature.bound(given, by_name))
        with at_callers_line():
            outputs = backend(made, lead, arrays, precision)
        return outputs[0] if len(outputs) == 1 else tuple(outputs)

    return _described(function, name, words)


def _of_numpy(signature: ArraySignature, words: str, library: ArrayLibrary,
              compiled: Mapping[str, Made]
              ) -> Made:
    """The function of the precision that the arguments have."""
    def function(*given: Any, **by_name: Any) -> Any:
        _, arrays, precision = checked(signature, library, signature.bound(given, by_name))
        with at_callers_line():
            return compiled[precision.name](*arrays)

    return _described(function, signature.name, words)


def _described(function: Made, name: str, words: str) -> Made:
    function.__name__ = function.__qualname__ = name
    function.__doc__ = words
    return function
