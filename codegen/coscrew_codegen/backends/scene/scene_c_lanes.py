"""A scene's functions of one precision on vectors, and the public ones that call them for n states.

Each public function reads as many states as a vector of its arguments' precision holds, calls the
function on vectors, and writes the results.  Where the instructions need double precision and the
arguments are single, it calls that twice, for half of the states each.
"""

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

from coscrew_codegen.backends.c import c_elementary
from coscrew_codegen.backends.c.c_function import CFunction
from coscrew_codegen.backends.c.c_statements import comment_of
from coscrew_codegen.backends.c.tables import c_tables
from coscrew_codegen.backends.python_extension.scene_calls import callables
from coscrew_codegen.backends.scene import scene_c_arguments as arguments
from coscrew_codegen.backends.scene import scene_c_tier, scene_text
from coscrew_codegen.backends.scene.scene_text import c_name, count, many, marked
from coscrew_codegen.program.scene_functions import SceneFunctions, Signature
from coscrew_codegen.program.values.formats import Precision, in_lanes

Inputs = Sequence[tuple[str, tuple[int, ...]]]
_PRODUCTS = re.compile(r"\bksl_product_(error|rest)(_lanes)?f?\(")


@dataclass(frozen=True)
class VectorArray:
    """An argument, and how many numbers a state has of it."""

    name: str
    size: int


@dataclass(frozen=True)
class VectorKernels:
    """Functions on vectors of one precision, each after those that it calls."""

    precision: Precision  # of the numbers
    sections: tuple[scene_c_tier.TierSection, ...]

    @cached_property
    def functions(self) -> list[CFunction]:
        """Their text."""
        return [_static(x) for section in self.sections for x in section.functions]

    @property
    def tables(self) -> str:
        """The tables that they read."""
        return c_tables.written([f.program for x in self.sections for f in x.scene.functions],
                                in_lanes(self.precision))

    @cached_property
    def elementary(self) -> list[c_elementary.ElementaryText]:
        """The elementary functions that they call, on vectors."""
        called = c_elementary.called(x.body for x in self.functions)
        return c_elementary.written(in_lanes(self.precision), called, nested=True)

    @cached_property
    def exact(self) -> list[str]:
        """The rounding errors of products that are computed, by the names of their functions for
        one number."""
        texts = (*(x.body for x in self.functions),
                 *(text for x in self.elementary for text in (*x.near, *x.far, x.body)))
        f = self.precision.suffix
        return [f"ksl_product_{what}{f}" for what in ("error", "rest")] \
            if any(map(_PRODUCTS.search, texts)) else []

    @property
    def mask(self) -> str:
        """All bits but the sign."""
        return hex(2**(8 * self.precision.bytes - 1) - 1)

    @property
    def packed(self) -> str:
        """Ending of the names of x86 instructions."""
        return "ps" if self.precision.suffix else "pd"

    @property
    def chosen(self) -> str:
        """The type of AVX-512's choice of numbers of a vector."""
        return f"__mmask{64 // self.precision.bytes}"

    @property
    def block(self) -> range:
        """The numbers of as many as 16 bytes hold: rows are transposed in blocks of so many."""
        return range(16 // self.precision.bytes)


@dataclass(frozen=True)
class VectorSection:
    """The functions of one precision; `plain` has those whose results they take."""

    precision: Precision
    scene: SceneFunctions
    plain: SceneFunctions | None = None

    @cached_property
    def working(self) -> Precision:
        """The precision in which they compute."""
        return scene_text.working([f.program for f in self.scene.functions], self.precision)

    @property
    def wide(self) -> str:
        """The type of vectors in which they compute, if it is not that of their arguments."""
        return in_lanes(self.working).c_type if self.working != self.precision else ""

    @property
    def vector(self) -> str:
        """The type of vectors of arguments."""
        return in_lanes(self.precision).c_type

    @cached_property
    def _on_lanes(self) -> SceneFunctions:
        """The functions on vectors, under names of their own.  Wide ones take plain results as
        arguments, since these are computed for twice as many states."""
        scene = self.scene
        if self.wide:
            scene = replace(scene, functions=tuple(replace(f, plain=None)
                                                   for f in scene.functions))
        return _on_lanes(scene, "wide" if self.wide else "")

    @cached_property
    def _plain(self) -> SceneFunctions | None:
        return _on_lanes(self.plain) if self.plain else None

    @cached_property
    def kernels(self) -> list[VectorKernels]:
        """The functions on vectors, those in the arguments' precision first."""
        own = in_lanes(self.precision)
        plain = (scene_c_tier.TierSection(own, self._plain),) if self._plain else ()
        if not self.wide:
            made = scene_c_tier.TierSection(own, self._on_lanes, self._plain)
            return [VectorKernels(self.precision, (*plain, made))]
        return [VectorKernels(self.precision, plain), VectorKernels(
            self.working, (scene_c_tier.TierSection(in_lanes(self.working), self._on_lanes),))]

    @property
    def parts(self) -> bool:
        """True if functions are cut."""
        return any(x.parts.cuts for kernels in self.kernels for x in kernels.sections)

    @property
    def functions(self) -> list[dict[str, object]]:
        """The public functions, each step followed by its run: what a template needs."""
        return [x for f in callables(self.scene) for x in (
            self._many(f), *([self._run(f)] if f.moved else []))]

    def _many(self, function: Signature) -> dict[str, object]:
        of = c_name(self.scene, function.name, self.precision)
        parameters = list(_parameters(function.arguments, self.precision))
        return {**self._described(function, function.name, f"{of} of n states.", parameters),
                **(self._halves(function) if self.wide else {"kernel": self._kernel(function)})}

    def _run(self, step: Signature) -> dict[str, object]:
        """n states, as many steps of each."""
        scalars = [x for x, shape in step.read if not shape]
        arrays = tuple(x for x in step.inputs if x[1])
        parameters = ["ptrdiff_t steps", *(f"double {x}" for x in scalars),
                      *_parameters([x for x in step.arguments if x[1]], self.precision)]
        real, of = self.precision.c_type, c_name(self.scene, step.name, self.precision)
        at = {"t": f"({real})begun(t, h, (double)step)", "h": f"({real})h"}
        one = [at.get(x, f"{x} + k * {x}_stride") for x, _ in step.inputs]
        several = [f"ksl_each_lanes{self.precision.suffix}({at[x]})" if x in at else f"{x}_states"
                   for x, _ in step.inputs]
        return {
            **self._described(
                replace(step, inputs=arrays), step.name.replace("step", "run", 1),
                f"{of} of n states, `steps` times one after the other"
                f"{', from the time t on' if 't' in scalars else ''}.", parameters),
            "kernel": f"{c_name(self._on_lanes, step.name, self.precision)}"
                      f"({', '.join(several)});",
            "single": f"{of}({', '.join(one)});", "repeated": True}

    def _described(self, function: Signature, name: str, words: str, parameters: Sequence[str]
                   ) -> dict[str, object]:
        """Returns what the template needs of any function."""
        both = [x for x in function.outputs if x in function.inputs]
        read = [VectorArray(x, count(shape)) for x, shape in (*function.read, *both)]
        written = [VectorArray(x, count(shape)) for x, shape in function.outputs]
        passed = [f"{x} + k * {x}_stride" if shape or (x, shape) in function.outputs
                  else f"{x}[k * {x}_stride]" for x, shape in _ordered(function)]
        return {
            "name": function.name, "internal": False, "comment": comment_of([words]),
            "head": arguments.head(c_name(many(self.scene), name, self.precision),
                                   ["ptrdiff_t n", *parameters]),
            "read": read, "written": written, "rooms": _rooms((*read, *written), "states"),
            "single": f"{c_name(self.scene, function.name, self.precision)}({', '.join(passed)});",
            "plain": "", "repeated": False}

    def _kernel(self, function: Signature) -> str:
        return _call(self._on_lanes, function.name, self.precision, _ordered(function),
                     function.outputs, "states")

    def _halves(self, function: Signature) -> dict[str, object]:
        """The calls of a function that computes in double precision."""
        made = self.scene.named(function.name)
        computed = [(a.name, tuple(a.quantity.shape)) for a in made.computed]
        results = [VectorArray(x, count(shape)) for x, shape in computed]
        read = [*(VectorArray(x, count(shape)) for x, shape in function.inputs), *results]
        written = [VectorArray(x, count(shape)) for x, shape in function.outputs]
        plain = self._plain and computed and _call(
            self._plain, function.name, self.precision, (*function.inputs, *computed), computed,
            "states")
        return {"plain": plain or "", "widened": read,
                "rooms": _rooms((*read, *written), "states"),
                "wide_rooms": _rooms((*read, *written), "wide"),
                "kernel": _call(self._on_lanes, function.name, self.working,
                                (*function.inputs, *computed, *function.outputs),
                                function.outputs, "wide")}


def _on_lanes(scene: SceneFunctions, *marks: str) -> SceneFunctions:
    """The functions with arguments in the precision in which they compute, for this file alone,
    under names of their own."""
    return replace(scene, mark=marked(scene.mark, *marks, "lanes"), functions=tuple(
        replace(f, internal=True, program=replace(f.program, wide=False))
        for f in scene.functions))


def _static(function: CFunction) -> CFunction:
    head = function.head if function.internal else f"static {function.head}"
    return replace(function, head=head)


def _parameters(of: Sequence[tuple[str, tuple[int, ...], bool]], precision: Precision
                ) -> Iterator[str]:
    """The parameters of arguments: pointers, each with its stride."""
    for x, _, written in of:
        yield f"{'' if written else 'const '}{precision.c_type} *{x}"
        yield f"ptrdiff_t {x}_stride"


def _ordered(function: Signature) -> Inputs:
    """The arguments of the function of one state."""
    return (*function.inputs, *(x for x in function.outputs if x not in function.inputs))


def _rooms(arrays: Iterable[VectorArray], what: str) -> str:
    sizes = {x.name: max(x.size, 1) for x in arrays}
    return ", ".join(f"{x}_{what}[{size}]" for x, size in sizes.items())


def _call(scene: SceneFunctions, name: str, precision: Precision, given: Inputs, outputs: Inputs,
          what: str) -> str:
    """The call of a function on vectors."""
    passed = [f"{x}_{what}" if shape or (x, shape) in outputs else f"*{x}_{what}"
              for x, shape in given]
    return f"{c_name(scene, name, precision)}({', '.join(passed)});"
