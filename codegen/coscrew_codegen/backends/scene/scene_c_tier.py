"""A scene's functions in a tier as C: arm_accurate.h, arm_accurate.c in double precision and
arm_accuratef.c in single, which need coscrew_runtime.h alone."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

from coscrew_codegen.accuracy.scene_tiers import SceneTier
from coscrew_codegen.algebra.recording.gc_pause import uncollected
from coscrew_codegen.backends.c import c_elementary
from coscrew_codegen.backends.c.c_function import CFunction
from coscrew_codegen.backends.c.c_statements import WIDTH, listed
from coscrew_codegen.backends.c.tables import c_tables
from coscrew_codegen.backends.nesting import NestingPlan
from coscrew_codegen.backends.scene import scene_c, scene_c_runtime, scene_text
from coscrew_codegen.backends.scene import scene_c_arguments as arguments
from coscrew_codegen.backends.scene.scene_c import IN_WORDS, functions_of
from coscrew_codegen.backends.scene.scene_c_parts import FunctionParts
from coscrew_codegen.backends.scene.scene_text import c_name
from coscrew_codegen.backends.target import Files, Target
from coscrew_codegen.program.scene_functions import FunctionProgram, SceneFunctions
from coscrew_codegen.program.values.formats import DOUBLE, SINGLE, Precision


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
        return FunctionParts(self.scene, self.plans,
                             loops=not (self.precision.lanes or self.precision.device))

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
    def tables(self) -> str:
        """The tables that they read."""
        return c_tables.written([f.program for f in self.scene.functions], self.working)

    @property
    def called(self) -> frozenset[str]:
        """The elementary functions that they call."""
        return c_elementary.called(x.body for x in self.functions)


@uncollected()
def files(made: SceneTier, banner: str) -> Files:
    """arm_accurate.h, arm_accurate.c, arm_accuratef.c and coscrew_runtime.h.  Raises ValueError for
    names that C cannot use."""
    sections = list(_sections(made))
    for section in sections:
        scene_text.check_names(section.scene)
    of = {p: [x for x in sections if x.precision == p] for p, _ in made.in_precisions}
    sources = [_source(made, p, some) for p, some in of.items()]
    public = {p: [f for x in some for f in x.functions] for p, some in of.items()}
    return {
        f"{made.stem}.h": scene_c.header(made.stem, made.plain.name,
                                         about(made, f"{made.plain.name}.h"), public, banner),
        **{x.path: x.text(banner) for x in sources}, **scene_c_runtime.files()}


def _source(made: SceneTier, precision: Precision, sections: Sequence[TierSection]
            ) -> scene_c.Source:
    """The functions whose arguments have one precision."""
    remedy = "this tier computes in double, also in single precision; the pairs tier does not"
    if precision == DOUBLE and SINGLE in dict(made.in_precisions) and _only_own(made):
        remedy = f"{made.stem}f.c has the same functions in single precision"
    return scene_c.Source(
        made.stem, made.plain.name, precision, [plan for x in sections for plan in x.plans],
        [scene_c.Section(x.working, x.functions, x.tables) for x in sections],
        any(x.parts.cuts for x in sections),
        remedy if DOUBLE in {x.working for x in sections} else "")


def _only_own(made: SceneTier) -> bool:
    """Returns whether single precision is computed in single precision."""
    scene = dict(made.in_precisions)[SINGLE]
    return scene_text.working([f.program for f in scene.functions], SINGLE) == SINGLE


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
            f"Coordinates, units, parameters and indices are those of {plain}, which "
            "has the steps: they have no tier."]


TARGET = Target("tiers of a scene in C", ("c",), tier=files)
