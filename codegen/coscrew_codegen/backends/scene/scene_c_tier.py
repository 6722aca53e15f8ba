"""A scene's functions in a tier as C: arm_accurate.h and arm_accurate.c, which need no other file.
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

from coscrew_codegen.accuracy.scene_tiers import SceneTier
from coscrew_codegen.algebra.recording.gc_pause import uncollected
from coscrew_codegen.backends.c import c_double, c_elementary
from coscrew_codegen.backends.c.c_function import CFunction
from coscrew_codegen.backends.c.c_statements import WIDTH, comment_of, listed
from coscrew_codegen.backends.nesting import NestingPlan
from coscrew_codegen.backends.render import render
from coscrew_codegen.backends.scene import scene_c_arguments as arguments
from coscrew_codegen.backends.scene import scene_text
from coscrew_codegen.backends.scene.scene_c import IN_WORDS, functions_of
from coscrew_codegen.backends.scene.scene_c_parts import FunctionParts
from coscrew_codegen.backends.scene.scene_text import c_name
from coscrew_codegen.backends.target import Files, Target
from coscrew_codegen.program.scene_functions import FunctionProgram, SceneFunctions
from coscrew_codegen.program.values.formats import Precision, named

_ERRORS = ("ksl_product_error", "ksl_product_errorf", "ksl_product_rest",
           "ksl_product_restf")


@dataclass(frozen=True)
class TierSection:
    """The functions of one precision, and what a template needs to write them; `plain` has
    those whose results they take."""

    precision: Precision
    scene: SceneFunctions
    plain: SceneFunctions | None = None

    @cached_property
    def plans(self) -> list[NestingPlan]:
        """Assignments of each function."""
        return scene_text.plans(self.scene)

    @cached_property
    def parts(self) -> FunctionParts:
        """The functions that are cut."""
        return FunctionParts(self.scene, self.plans)

    @cached_property
    def functions(self) -> list[CFunction]:
        """All functions, each after those that it calls."""
        taking = {f.name: f for f in self.scene.functions if f.plain}
        return [self._behind_plain(taking[x.name], x) if x.name in taking else x
                for x in functions_of(self.scene, self.plans, self.parts, self.precision)]

    def _behind_plain(self, function: FunctionProgram, written: CFunction) -> CFunction:
        """The function, whose body begins with the call of the plain one."""
        assert self.plain
        declared = [f"{arguments.written(a, self.precision).replace('*', '')};"
                    for a in function.computed]
        results = [a.name if a.quantity.shape else f"&{a.name}" for a in function.computed]
        call = listed(f"{c_name(self.plain, function.name, self.precision)}(",
                      [*(a.name for a in function.inputs), *results], ");", WIDTH - 2)
        rows = [f"  {row}" for line in (*declared, call) for row in line.split("\n")]
        return replace(written, body="\n".join((*rows, written.body)))

    @property
    def working(self) -> Precision:
        """The precision in which they compute."""
        return scene_text.working([plan.program for plan in self.plans], self.precision)

    @property
    def public(self) -> bool:
        """True if they are declared in the header."""
        return not all(f.internal for f in self.scene.functions)

    @property
    def called(self) -> frozenset[str]:
        """The elementary functions that they call."""
        return c_elementary.called(x.body for x in self.functions)


@dataclass(frozen=True)
class TierText:
    """A section, and the functions that no other section calls."""

    section: TierSection
    elementary: list[c_elementary.ElementaryText]


def _exact(sections: Sequence[TierSection],
           elementary: Iterable[c_elementary.ElementaryText]) -> list[str]:
    """Returns those of _ERRORS that are called: rounding errors of products."""
    bodies = [*(x.body for section in sections for x in section.functions),
              *(text for x in elementary for text in (*x.near, *x.far, x.body))]
    return [name for name in _ERRORS if any(f"{name}(" in body for body in bodies)]


def _of_all(sections: Sequence[TierSection]) -> frozenset[str]:
    """The elementary functions that all of several sections call."""
    if len(sections) < 2:
        return frozenset()
    return c_elementary.shared(x.called for x in sections)


@uncollected()
def files(made: SceneTier, banner: str) -> Files:
    """arm_accurate.h and arm_accurate.c.  Raises ValueError for names that C cannot use."""
    sections = list(_sections(made))
    for section in sections:
        scene_text.check_names(section.scene)
    precisions = named({x.working.name for x in sections})
    bodies = [function.body for x in sections for function in x.functions]
    names = scene_text.legend([plan for x in sections for plan in x.plans], bodies)
    wide = [x for x in sections if x.working == sections[-1].working]
    common = _of_all(wide)
    written = [TierText(x, c_elementary.written(
        x.working, x.called - common if x in wide else x.called, nested=True)) for x in sections]
    shared_functions = c_elementary.written(wide[0].working, common, nested=True)
    exact = _exact(sections, (*shared_functions, *(f for x in written for f in x.elementary)))
    shared = {"banner": banner, "name": made.stem, "upper": made.plain.name.upper(),
              "guard": made.stem.upper(), "sections": [x for x in sections if x.public]}
    return {
        f"{made.stem}.h": render(
            "scene/tier.h", about=comment_of(about(made, f"{made.plain.name}.h")),
            double=c_double.of_scene(made.plain.name.upper(), (
                (x.precision, x.working) for x in sections)), **shared),
        f"{made.stem}.c": render(
            "scene/tier.c", names=[comment_of(names)] if names else [], products=precisions,
            parts=any(x.parts.cuts for x in sections), written=written,
            inlining=bool(exact) or any(x.called for x in sections), exact=exact,
            working=wide[0].working, elementary=shared_functions, **shared)}


def _sections(made: SceneTier) -> Iterator[TierSection]:
    """The functions of each precision, behind the plain ones that they call."""
    for precision, scene in made.in_precisions:
        plain = made.called(scene)
        if plain.functions:
            yield TierSection(precision, plain)
        yield TierSection(precision, scene, plain)


_COUNTS = ("In the counts of operations, a product error or rest is a product less a number, "
           "rounded once, as fma does it; a sine error is a sine less a number.")


def about(made: SceneTier, plain: str) -> list[str]:
    """Returns the comment at the top of the tier's header; `plain` is that of the scene without
    tiers."""
    return [f"{made.plain.name}: dynamics of a scene, in {IN_WORDS[made.plain.precisions]}.",
            made.tier.title,
            *filter(None, [" ".join(made.tier.promise.split())]),
            *([_COUNTS] if made.tier.exact else []),
            f"Coordinates, units, parameters and macros are those of {plain}, which "
            "has the steps: they have no tier."]


TARGET = Target("tiers of a scene in C", ("c",), tier=files)
