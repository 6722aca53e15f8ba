"""A scene's functions in a tier as C: arm_accurate.h and arm_accurate.c, which need no other file.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

from coscrew_codegen.collection import uncollected
from coscrew_codegen.formats import Precision, named
from coscrew_codegen.render import render
from coscrew_codegen.scene_functions import SceneFunctions
from coscrew_codegen.scene_tiers import SceneTier
from coscrew_codegen.targets import c_elementary, scene_text
from coscrew_codegen.targets.c_function import CFunction
from coscrew_codegen.targets.c_statements import comment_of
from coscrew_codegen.targets.nesting import Plan
from coscrew_codegen.targets.scene_c import IN_WORDS, functions_of
from coscrew_codegen.targets.scene_c_parts import Parts
from coscrew_codegen.targets.target import Files, Target

_ERRORS = ("ksl_product_error", "ksl_product_errorf", "ksl_product_rest",
           "ksl_product_restf")


@dataclass(frozen=True)
class Section:
    """The functions of one precision, and what a template needs to write them."""

    precision: Precision
    scene: SceneFunctions

    @cached_property
    def plans(self) -> list[Plan]:
        """What is assigned in each function."""
        return scene_text.plans(self.scene)

    @cached_property
    def parts(self) -> Parts:
        """The functions that are cut."""
        return Parts(self.scene, self.plans)

    @cached_property
    def functions(self) -> list[CFunction]:
        """All functions, each after those that it calls."""
        return list(functions_of(self.scene, self.plans, self.parts, self.precision))

    @property
    def working(self) -> Precision:
        """The precision in which they compute."""
        return scene_text.working([plan.program for plan in self.plans], self.precision)

    @property
    def called(self) -> frozenset[str]:
        """The elementary functions that they call."""
        return c_elementary.called(x.body for x in self.functions)


@dataclass(frozen=True)
class Written:
    """A section, and the functions that no other section calls."""

    section: Section
    elementary: list[c_elementary.Written]

    @property
    def exact(self) -> bool:
        """Whether rounding errors of products are computed."""
        return any(map(self.calls, _ERRORS))

    def calls(self, name: str) -> bool:
        """Whether one of _ERRORS is called."""
        bodies = (*(x.body for x in self.section.functions), *(
            text for x in self.elementary for text in (*x.near, *x.far, x.body)))
        return any(f"{name}(" in body for body in bodies)


def _of_all(sections: Sequence[Section]) -> frozenset[str]:
    """The elementary functions that several sections call, all in one precision."""
    if len(sections) < 2 or len({x.working for x in sections}) > 1:
        return frozenset()
    return c_elementary.shared(x.called for x in sections)


@uncollected()
def files(made: SceneTier, banner: str) -> Files:
    """arm_accurate.h and arm_accurate.c.  Raises ValueError for names that C cannot use."""
    sections = [Section(p, scene) for p, scene in made.in_precisions]
    for section in sections:
        scene_text.check_names(section.scene)
    precisions = named({x.working.name for x in sections})
    bodies = [function.body for x in sections for function in x.functions]
    names = scene_text.legend([plan for x in sections for plan in x.plans], bodies)
    common = _of_all(sections)
    written = [Written(x, c_elementary.written(x.working, x.called - common, nested=True))
               for x in sections]
    shared = {"banner": banner, "name": made.stem, "upper": made.plain.name.upper(),
              "guard": made.stem.upper(), "sections": sections}
    return {
        f"{made.stem}.h": render("scene/tier.h", about=comment_of(_about(made)), **shared),
        f"{made.stem}.c": render(
            "scene/tier.c", names=[comment_of(names)] if names else [], products=precisions,
            parts=any(x.parts.cuts for x in sections), written=written,
            inlining=any(x.called for x in sections), working=precisions[0],
            elementary=c_elementary.written(precisions[0], common, nested=True), **shared)}


def _about(made: SceneTier) -> list[str]:
    return [f"{made.plain.name}: dynamics of a scene, in {IN_WORDS[made.plain.precisions]}.",
            made.tier.title,
            f"Coordinates, units, parameters and macros are those of {made.plain.name}.h, which "
            "has the steps: they have no tier."]


TARGET = Target("tiers of a scene in C", ("c",), tier=files)
