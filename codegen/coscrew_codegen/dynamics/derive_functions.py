"""Derives all functions that a scene selects, with statements on their rounding errors."""

from collections.abc import Callable, Collection
from dataclasses import replace

from coscrew_codegen.accuracy.scene_tiers import stated
from coscrew_codegen.accuracy.tiers import PLAIN
from coscrew_codegen.algebra.recording.gc_pause import uncollected
from coscrew_codegen.dynamics.derivation import Derivation, Keep
from coscrew_codegen.dynamics.integrator_steps import needs, stepped
from coscrew_codegen.dynamics.ranges.accuracy_requests import requested
from coscrew_codegen.dynamics.ranges.argument_ranges import argument_ranges
from coscrew_codegen.dynamics.ranges.representable import refuse_numbers
from coscrew_codegen.dynamics.ranges.residual import residual
from coscrew_codegen.dynamics.ranges.rounding import statement
from coscrew_codegen.program.scene_functions import FunctionProgram, SceneFunctions
from coscrew_codegen.program.values.formats import named
from coscrew_codegen.scene.function_selection import (
    FunctionsError,
    refuse_ambiguous,
    refuse_loops,
    refuse_many,
    refuse_singular,
    selected_functions,
    together,
)
from coscrew_codegen.scene.functions import functions_of
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.scene.scene_function import SceneFunction


def derive(scene: Scene, functions: Collection[str] = (),
           tell: Callable[[str], None] = lambda name: None,
           keep: Keep = lambda name, make: make()) -> SceneFunctions:
    """Derives the functions that a scene selects, or its functions of these names, and the internal
    functions that their steps call.  `tell` is called with each name before it is derived, unless
    `keep` has it.

    Raises RangeError for numbers that one of its precisions cannot represent, ModelError if a
    function divides by zero whatever q is, FunctionsError for functions that the scene lacks, for
    two of one name, and for too many joints."""
    refuse_many(scene)
    refuse_numbers(scene)
    refuse_singular(scene, functions)
    refuse_loops(scene, functions)
    with uncollected():
        return _functions(Derivation(scene, tell, keep), functions)


def _functions(its: Derivation, names: Collection[str]) -> SceneFunctions:
    """The functions of these names, for targets."""
    scene = its.scene
    wanted = names or selected_functions(scene)
    entries = tuple(functions_of(scene, wanted))
    steps, with_tau = ([x.step for x in entries if x.step and x.name in wanted
                        and ("tau" in x.takes) == tau] for tau in (False, True))
    called = together(*map(needs, steps), *(needs(x, takes_tau=True) for x in with_tau))
    entries = tuple(x for x in entries if x.name in wanted or x.name in called)
    refuse_ambiguous(scene, entries)
    made = []
    for entry in entries:
        if not entry.step:
            if reason := entry.absent(its):
                _refuse(its, entry, reason, names)
            else:
                made.append(_stated(its, its.made(entry), entry.name in wanted))
    return stepped(its.collected(made), steps, with_tau)


def _stated(its: Derivation, made: FunctionProgram, public: bool) -> FunctionProgram:
    """The function, public or not; if public, with the statement on its rounding errors and the
    accuracy requested of it."""
    if not public:
        return replace(made, internal=True)
    if its.scene.accuracy:
        made = replace(made, accuracy=requested(made.program, its.scene, its.tree))
    if its.scene.ranges is None:
        return replace(made, rounding=statement(made.program, its.scene, its.tree))
    made = replace(made, ranges=argument_ranges(made.program, its.scene.ranges))
    return replace(made, rounding="  ".join(filter(None, (
        stated(made, PLAIN, named(its.scene.precisions)), residual(its, made)))))


def _refuse(its: Derivation, entry: SceneFunction, reason: str, names: Collection[str]) -> None:
    """Raise FunctionsError if the scene's file selects a function by name that the scene lacks."""
    if not names and entry.name in its.scene.functions:
        raise FunctionsError(f"{its.scene.name}: there is no {entry.name}: {reason} in the scene")
