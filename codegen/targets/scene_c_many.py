"""A scene's functions of many states as C: arm_many.h and arm_many.c.

The same Programs as in arm.c, on vectors with a number of each of several states, as many as a
register holds: the bits are those of one state.  Loops over arm.c's functions where the compiler or
the processor has no such vectors, and of steps that divide themselves as a state needs.
"""

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

from coscrew_codegen.collection import uncollected
from coscrew_codegen.formats import Precision, in_lanes, named
from coscrew_codegen.render import render
from coscrew_codegen.scene_functions import SceneFunctions, Signature, Split
from coscrew_codegen.scene_tiers import SceneTier
from coscrew_codegen.targets import c_elementary, scene_c_tier, scene_text
from coscrew_codegen.targets import scene_c_arguments as arguments
from coscrew_codegen.targets.c_function import CFunction
from coscrew_codegen.targets.c_statements import comment_of
from coscrew_codegen.targets.scene_c import IN_WORDS
from coscrew_codegen.targets.scene_calls import callables
from coscrew_codegen.targets.scene_text import c_name, count, many, marked
from coscrew_codegen.targets.target import Files, Target


@dataclass(frozen=True)
class Array:
    """An argument, and how many numbers a state has of it."""

    name: str
    size: int


@dataclass(frozen=True)
class Section:
    """The functions of one precision; `plain` has those whose results they take."""

    precision: Precision
    scene: SceneFunctions
    plain: SceneFunctions | None = None

    @cached_property
    def working(self) -> Precision:
        """The precision in which they compute."""
        return scene_text.working([f.program for f in self.scene.functions], self.precision)

    @property
    def wide(self) -> bool:
        """Whether that is not the precision of their arguments."""
        return self.working != self.precision

    @cached_property
    def on_lanes(self) -> SceneFunctions:
        """The functions on vectors, under names of their own."""
        # Single-precision results would be vectors of other lengths than the double they go into.
        functions = (f for f in self.scene.functions if not (self.wide and f.plain))
        return _on_lanes(replace(self.scene, functions=tuple(functions)),
                         "wide" if self.wide else "")

    @cached_property
    def _made(self) -> list[scene_c_tier.Section]:
        """What writes them on vectors, behind the plain ones that they call."""
        precision = in_lanes(self.working)
        plain = _on_lanes(self.plain) if self.plain and not self.wide else None
        return [*([scene_c_tier.Section(precision, plain)] if plain else []),
                scene_c_tier.Section(precision, self.on_lanes, plain)]

    @property
    def parts(self) -> bool:
        """Whether functions are cut."""
        return any(x.parts.cuts for x in self._made)

    @cached_property
    def kernels(self) -> list[CFunction]:
        """The functions on vectors, each after those that it calls."""
        return [_static(x) for made in self._made for x in made.functions]

    @property
    def exact(self) -> bool:
        """Whether they compute rounding errors of products."""
        return bool(_exact([self]))

    @property
    def called(self) -> frozenset[str]:
        """The elementary functions that they call."""
        return c_elementary.called(x.body for x in self.kernels)

    @property
    def elementary(self) -> list[c_elementary.Written]:
        """These, on vectors."""
        return c_elementary.written(in_lanes(self.working), self.called, nested=True)

    @property
    def reductions(self) -> list[c_elementary.Written]:
        """These, of one number, where angles are reduced one by one."""
        names = {x.name for x in self.elementary if x.near}
        return c_elementary.written(self.working, names, nested=True)

    @property
    def vector(self) -> str:
        """The type of vectors."""
        return in_lanes(self.working).c_type

    @property
    def rows(self) -> str:
        """What ends the names of the functions that read and write states."""
        return f"{'wide' if self.wide else 'lanes'}{self.precision.suffix}"

    @property
    def narrowed(self) -> str:
        """The conversion of results."""
        return f"({self.precision.c_type})" if self.wide else ""

    @property
    def block(self) -> range:
        """The numbers of as many as 16 bytes hold: rows are transposed in blocks of so many."""
        return range(16 // self.precision.bytes)

    @property
    def mask(self) -> str:
        """All bits but the sign."""
        return hex(2**(8 * self.working.bytes - 1) - 1)

    @property
    def packed(self) -> str:
        """What ends the names of x86 instructions."""
        return "ps" if self.working.suffix else "pd"

    @property
    def functions(self) -> list[dict[str, object]]:
        """The public functions: what a template needs."""
        on_lanes = {*(f.name for f in self.on_lanes.functions),
                    *(step.name for step in self.on_lanes.steps)}
        return [self._many(f, f.name in on_lanes) for f in callables(self.scene)]

    def _many(self, function: Signature, on_lanes: bool) -> dict[str, object]:
        real = self.precision.c_type
        both = [x for x in function.outputs if x in function.inputs]
        read = [Array(x, count(shape)) for x, shape in (*function.read, *both)]
        written = [Array(x, count(shape)) for x, shape in function.outputs]
        taken = [f"const {real} *{x}, ptrdiff_t {x}_stride" for x, _ in function.read]
        taken += [f"{real} *{x}, ptrdiff_t {x}_stride" for x, _ in function.outputs]
        rooms = {x.name: max(x.size, 1) for x in (*read, *written)}
        ordered = (*function.inputs, *(x for x in function.outputs if x not in both))
        return {
            "name": function.name, "internal": False, "read": read, "written": written,
            "comment": comment_of(
                [f"{c_name(self.scene, function.name, self.precision)} of n states."]),
            "head": arguments.head(c_name(many(self.scene), function.name, self.precision),
                                   ["ptrdiff_t n", *taken]),
            "rooms": ", ".join(f"{x}_states[{size}]" for x, size in rooms.items()),
            "kernel": self._call(self.on_lanes, function, ordered) if on_lanes else "",
            "single": self._single(function, ordered)}

    def _call(self, scene: SceneFunctions, function: Signature,
              ordered: Sequence[tuple[str, tuple[int, ...]]]) -> str:
        outputs = {x for x, _ in function.outputs}
        passed = [f"{x}_states" if shape or x in outputs else f"*{x}_states"
                  for x, shape in ordered]
        return f"{c_name(scene, function.name, self.working)}({', '.join(passed)});"

    def _single(self, function: Signature, ordered: Sequence[tuple[str, tuple[int, ...]]]) -> str:
        outputs = {x for x, _ in function.outputs}
        passed = [f"{x} + k * {x}_stride" if shape or x in outputs else f"{x}[k * {x}_stride]"
                  for x, shape in ordered]
        return f"{c_name(self.scene, function.name, self.precision)}({', '.join(passed)});"


def _on_lanes(scene: SceneFunctions, *marks: str) -> SceneFunctions:
    """The functions that have the same calls for every state, with arguments in the precision in
    which they compute, for this file alone, under names of their own."""
    return replace(scene, mark=marked(scene.mark, *marks, "lanes"), steps=tuple(
        x for x in scene.steps if not any(isinstance(call, Split) for call in x.body)),
        functions=tuple(replace(f, internal=True, program=replace(f.program, wide=False))
                        for f in scene.functions))


def _static(function: CFunction) -> CFunction:
    head = function.head if function.internal else f"static {function.head}"
    return replace(function, head=head)


@uncollected()
def files(scene: SceneFunctions, banner: str) -> Files:
    """arm_many.h and arm_many.c."""
    return _files([Section(p, scene) for p in named(scene.precisions)], scene.name, banner)


@uncollected()
def tier_files(made: SceneTier, banner: str) -> Files:
    """arm_accurate_many.h and arm_accurate_many.c."""
    sections = []
    for precision, scene in made.in_precisions:
        plain = made.called(scene)
        sections.append(Section(precision, scene, plain if plain.functions else None))
    return _files(sections, made.stem, banner)


def _files(sections: Sequence[Section], of: str, banner: str) -> Files:
    scene = sections[0].scene
    name = f"{of}_many"
    shared = {"banner": banner, "name": name, "of": of, "upper": scene.name.upper(),
              "guard": name.upper(), "sections": sections}
    return {
        f"{name}.h": render("scene/many.h", about=comment_of([*_about(sections, of)]),
                             **shared),
        f"{name}.c": render(
            "scene/many.c", products=named({x.working.name for x in sections if x.reductions}),
            parts=any(x.parts for x in sections), exact=_exact(sections), **shared)}


def _exact(sections: Sequence[Section]) -> list[str]:
    """The rounding errors of products that are computed, by the names of their functions for one
    number."""
    found = set()
    for x in sections:
        elementary = (*x.elementary, *x.reductions)
        texts = (*(f.body for f in x.kernels), *(f.body for f in elementary),
                 *(text for f in elementary for text in (*f.near, *f.far)))
        if any(_PRODUCTS.search(text) for text in texts):
            found.add(x.working.suffix)
    return [f"ksl_product_{what}{f}" for f in sorted(found) for what in ("error", "rest")]


_PRODUCTS = re.compile(r"\bksl_product_(error|rest)(_lanes)?f?\(")


def _about(sections: Sequence[Section], of: str) -> Iterator[str]:
    precisions = IN_WORDS[tuple(x.precision.name for x in sections)]
    yield f"{of}: its functions of n states, in {precisions}."
    yield (f"The bits are those of {of}.h's functions.  Row k of an argument begins k strides "
           "behind the first: a stride counts numbers, and 0 says that all states share one row.  "
           "n may be 0.  An output may be an input with the same stride, not 0; else it must "
           "overlap neither inputs nor other outputs, which is not checked.  No heap, no state: "
           "all functions are thread-safe.")
    yield ("As many states as a register holds are computed at a time: compile for your processor "
           f"(-march=native, or the oldest one that must run it).  Link with {of}.c.")


TARGET = Target("many states of a scene in C", ("c",), many=files, many_tier=tier_files)
