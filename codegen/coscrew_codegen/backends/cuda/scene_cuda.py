"""A scene's functions for CUDA: arm.cuh, for host and device, which needs no other file.

The same Programs as in arm.c, on numbers of a class whose operations no flag of a compiler changes:
the bits are those of arm.c.  A thread computes a state.
"""

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

from coscrew_codegen.accuracy.scene_tiers import SceneTier
from coscrew_codegen.algebra.recording.gc_pause import uncollected
from coscrew_codegen.backends.c import c_elementary
from coscrew_codegen.backends.c.c_function import CFunction
from coscrew_codegen.backends.c.c_statements import comment_of
from coscrew_codegen.backends.c.tables import two_over_pi_table
from coscrew_codegen.backends.cuda.cuda_kernels import CudaKernel, kernels
from coscrew_codegen.backends.cuda.cuda_number import CudaNumber
from coscrew_codegen.backends.render import render
from coscrew_codegen.backends.scene import scene_c, scene_c_tier, scene_text
from coscrew_codegen.backends.scene.scene_c_steps import body_of_begun
from coscrew_codegen.backends.scene.scene_text import marked
from coscrew_codegen.backends.target import Files, Target
from coscrew_codegen.program.scene_functions import SceneFunctions
from coscrew_codegen.program.values.formats import (
    BY_NAME,
    DOUBLE,
    PRECISIONS,
    Precision,
    named,
    on_device,
)


@dataclass(frozen=True)
class CudaElementary:
    """An elementary function, and what describes the table of 2/π that it reads."""

    written: c_elementary.ElementaryText
    digits: Mapping[str, object]


@dataclass(frozen=True)
class Block:
    """Functions on numbers of a class, and the elementary functions that they call."""

    made: scene_c_tier.TierSection

    @property
    def working(self) -> Precision:
        """The precision in which they compute, of numbers of the class."""
        return self.made.working

    @property
    def built_in(self) -> Precision:
        """This precision on C's own numbers."""
        return BY_NAME[self.working.name]

    @property
    def functions(self) -> list[CFunction]:
        """Each after those that it calls."""
        return self.made.functions

    @cached_property
    def elementary(self) -> list[CudaElementary]:
        """Each after those that it calls."""
        digits = two_over_pi_table.holes(self.built_in, self.working.suffix)
        return [CudaElementary(x, digits)
                for x in c_elementary.written(self.working, self.made.called, nested=True)]

    @property
    def tables(self) -> str:
        """The tables that they read."""
        return self.made.tables

    @property
    def texts(self) -> Iterator[str]:
        """Yields the texts of all functions that compute."""
        yield from (x.body for x in self.functions)
        for x in self.elementary:
            yield from (x.written.body, *x.written.near, *x.written.far)


@dataclass(frozen=True)
class CudaSection:
    """The functions of one precision; `plain` has those whose results they take."""

    precision: Precision
    scene: SceneFunctions
    plain: SceneFunctions | None = None

    @cached_property
    def blocks(self) -> list[Block]:
        """The functions, behind the plain ones that they call."""
        precision = on_device(self.precision)
        plain = _on_numbers(self.plain) if self.plain else None
        return [*([Block(scene_c_tier.TierSection(precision, plain))] if plain else []),
                Block(scene_c_tier.TierSection(precision, _on_numbers(self.scene), plain))]

    @cached_property
    def kernels(self) -> list[CudaKernel]:
        """Kernels that compute one state, n of them, and runs."""
        return list(kernels(self.scene, _on_numbers(self.scene), self.precision))


def _on_numbers(scene: SceneFunctions) -> SceneFunctions:
    """The scene, with names of functions on numbers of the class."""
    return replace(scene, mark=marked(scene.mark, "number"))


@uncollected()
def files(scene: SceneFunctions, banner: str) -> Files:
    """arm.cuh.  Raises ValueError for names that cannot be used in C."""
    scene_text.check_names(scene)
    about = [*scene_c.about(scene), *_about(scene.name)]
    begun = body_of_begun(on_device(DOUBLE)) if scene.timed and scene.steps else ""
    return _files([CudaSection(p, scene) for p in named(scene.precisions)], scene.name, about,
                  banner, scene_c.macros(scene), scene_c.indices(scene), begun)


@uncollected()
def tier_files(made: SceneTier, banner: str) -> Files:
    """arm_accurate.cuh."""
    sections = []
    for precision, scene in made.in_precisions:
        plain = made.called(scene)
        sections.append(CudaSection(precision, scene, plain if plain.functions else None))
    about = [*scene_c_tier.about(made, f"{made.plain.name}.cuh"), *_about(made.stem)]
    return _files(sections, made.stem, about, banner)


def _files(sections: Sequence[CudaSection], name: str, about: Sequence[str], banner: str,
           macros: Sequence[tuple[str, str]] = (), indices: Sequence[str] = (),
           begun: str = "") -> Files:
    blocks = [block for section in sections for block in section.blocks]
    exact = {block.working.suffix for block in blocks
             if any(_ERROR.search(text) for text in block.texts)}
    names = scene_text.legend([plan for x in blocks for plan in x.made.plans],
                              [f.body for x in blocks for f in x.functions])
    return {f"{name}.cuh": render(
        "cuda/scene.cuh", banner=banner, about=comment_of([*about]), guard=name.upper(),
        upper=sections[0].scene.name.upper(), macros=macros, indices=indices, sections=sections,
        begun=begun,
        names=[comment_of(names)] if names else [],
        numbers=[CudaNumber(p, p.suffix in exact) for p in PRECISIONS],
        exact=[f"ksl_product_{what}{f}" for f in sorted(exact) for what in ("error", "rest")])}


_ERROR = re.compile(r"\bksl_product_(error|rest)_device")


def _about(name: str) -> list[str]:
    return [
        f"For CUDA and C++11: on the device, as on the host, the bits are those of {name}.c, "
        "whatever the flags that contract sums of products, approximate or flush subnormal "
        "numbers; NaN excepted, whose bits are not promised.",
        "…_device computes one state, on host or device.  …_kernel computes n states, one a "
        "thread, with any number of blocks; …_launch starts it.  Row k of an argument begins k "
        "strides behind the first: a stride counts numbers, and 0 says that all states share one "
        "row.  An output may be an input with the same stride, not 0; else it must overlap "
        "neither inputs nor other outputs, which is not checked.  A launch takes at most KSL_BLOCK "
        "threads a block: 128, unless it is defined."]


TARGET = Target("scene for CUDA", ("c",), cuda=files, cuda_tier=tier_files)
