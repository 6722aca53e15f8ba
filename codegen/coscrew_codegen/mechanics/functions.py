"""The functions of a scene: each is recorded separately, with only what its outputs need."""

from collections.abc import Callable, Collection
from dataclasses import replace

from coscrew_codegen.collection import uncollected
from coscrew_codegen.integrators import EMITTED
from coscrew_codegen.mechanics import coordinates
from coscrew_codegen.mechanics.accuracy import asked
from coscrew_codegen.mechanics.derivation import Makers
from coscrew_codegen.mechanics.functions_of_bodies import BodyFunctions
from coscrew_codegen.mechanics.functions_of_dynamics import DynamicsFunctions
from coscrew_codegen.mechanics.functions_of_effects import EffectFunctions
from coscrew_codegen.mechanics.functions_of_steps import StepFunctions
from coscrew_codegen.mechanics.ranges import refuse_numbers
from coscrew_codegen.mechanics.rounding import statement
from coscrew_codegen.mechanics.steps import needs, stepped
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.scene.selected import (
    CONTACTS,
    FREE,
    FunctionsError,
    refuse_many,
    refuse_singular,
    selected_functions,
    together,
)
from coscrew_codegen.scene.signs import signs
from coscrew_codegen.scene_functions import Function, SceneFunctions


def derive(scene: Scene, functions: Collection[str] = (),
           tell: Callable[[str], None] = lambda name: None) -> SceneFunctions:
    """The functions that a scene selects, or those with these names that it has, and the internal
    functions that their steps call.  `tell` is called with each name before it is derived.

    Raises RangeError for numbers that one of its precisions cannot represent, ModelError if a
    function divides by zero whatever q is, FunctionsError for functions that it cannot have, and
    for too many joints."""
    refuse_many(scene)
    refuse_numbers(scene)
    refuse_singular(scene, functions)
    with uncollected():
        return _Derivation(scene, tell).functions(functions)


class _Derivation(DynamicsFunctions, BodyFunctions, EffectFunctions, StepFunctions):
    """All of them."""

    def functions(self, names: Collection[str]) -> SceneFunctions:
        """The functions of these names, for targets."""
        scene, tree = self.scene, self.tree
        wanted = names or selected_functions(scene)
        steps = [x for x in EMITTED if x.step_name in wanted]
        with_tau = [x for x in EMITTED if x.step_with_tau in wanted]
        called = together(*map(needs, steps), *(needs(x, takes_tau=True) for x in with_tau))
        found = [self._stated(made, name in wanted)
                 for name, make in self._makers().items() if name in wanted or name in called
                 if (made := make())]
        if not names:
            self._refuse_absent({f.name for f in found})
        return stepped(SceneFunctions(
            scene.name, tree.nq, tree.nv, tree.coordinates, tuple(self.bodies),
            tuple((p.name, float(p.value)) for p in scene.parameters), coordinates.neutral(tree),
            tuple(found), (), scene.precisions, self.timed,
            tuple(signs(scene).items()), scene.tiers), steps, with_tau)

    def _stated(self, made: Function, public: bool) -> Function:
        """The function, public or not, with what is proved of its rounding errors."""
        rounding = statement(made.program, self.scene, self.tree) if public else ""
        return replace(made, internal=not public, rounding=rounding,
                       accuracy=asked(made.program, self.scene, self.tree) if public else None)

    def _makers(self) -> Makers:
        return {**self._of_dynamics(), **self._of_bodies(), **self._of_effects(),
                **self._of_steps()}

    def _refuse_absent(self, found: set[str]) -> None:
        """Raise FunctionsError for a selected function that only scenes of another kind have."""
        for several, reason in ((FREE, "no base is floating"), (CONTACTS, "no limit closes")):
            for name in several:
                if name in self.scene.functions and name not in found:
                    raise FunctionsError(f"{self.scene.name}: there is no {name}: {reason} in the "
                                         "scene")
