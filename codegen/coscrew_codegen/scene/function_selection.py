"""The functions and tiers of a scene by name, and their selection: by `functions` and `tiers` in
its file, by --functions and --tier, or by load_scene.

A function that is not selected is neither derived, emitted nor compiled.
"""

from collections.abc import Collection, Iterable, Sequence

from coscrew_codegen.program.reported_error import ReportedError
from coscrew_codegen.scene.functions import derivatives_of, functions_of
from coscrew_codegen.scene.functions.loops import closure, with_closed_loops
from coscrew_codegen.scene.functions.steps import (
    carried_half_drift,
    closing_contacts,
    free_momentum,
    integrated,
    law_switches,
    moved_states,
    state_rates,
    step_parts,
    with_free_momentum,
)
from coscrew_codegen.scene.functions.whole_scene import bristles, contacts
from coscrew_codegen.scene.mechanism.inertia_checks import why_singular
from coscrew_codegen.scene.names import did_you_mean
from coscrew_codegen.scene.patterns import is_pattern, matching
from coscrew_codegen.scene.recorded_quantities import recorded_functions
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.scene.scene_function import SceneFunction

DEFAULT, ALL = "default", "all"
"""Words for several functions: the default ones, and all that a scene can have."""

FREE = (free_momentum.FUNCTION.name, with_free_momentum.FUNCTION.name)
"""Functions by which steps keep the momenta of floating bases."""
CONTACTS = (closing_contacts.FUNCTION.name, step_parts.FUNCTION.name)
"""Functions by which steps resolve contacts of limits."""
ALL_CONTACTS = contacts.FUNCTION.name
"""Points, forces and depths of all contacts of bodies."""
BRISTLES = bristles.FUNCTION.name
"""The function of the energy that bristles store and of their power."""
CARRIED = carried_half_drift.FUNCTION.name
"""The function by which steps move free bases that touch the ground."""
STATE_RATES, SWITCHES = OF_STATES = (state_rates.FUNCTION.name, law_switches.FUNCTION.name)
"""The rates of states of effects, and the switches of their laws."""
MOVED_STATES = moved_states.FUNCTION.name
"""The function by which steps of the Euler methods move states of effects."""
CLOSURE, CLOSED = LOOPS = (closure.FUNCTION.name, with_closed_loops.FUNCTION.name)
"""The closures of loops, and the function by which steps keep loops closed."""
MOVED = integrated.FUNCTION.name
"""The function by which steps move coordinates."""
MOST = 1000
"""Largest number of joints that move: their functions are 100 MB of C, too much for compilers."""


class FunctionsError(ReportedError, ValueError):
    """A function that the scene does not have; the message gives the nearest name."""


def names(scene: Scene) -> tuple[str, ...]:
    """The functions that ALL stands for, in the order in which they are emitted: all that the scene
    can have but derivatives of functions."""
    return _possible(scene, functions_of(scene))


def all_names(scene: Scene) -> tuple[str, ...]:
    """All functions that the scene can have, in the order in which they are emitted."""
    return *names(scene), *_possible(scene, derivatives_of(scene))


def _possible(scene: Scene, functions: Iterable[SceneFunction]) -> tuple[str, ...]:
    """The names of those that the scene can select, that do not divide by a singular matrix, and
    that do not ignore its closed loops."""
    singular, loops = bool(why_singular(scene)), bool(scene.model.loops)
    return tuple(x.name for x in functions if not (
        x.internal or (singular and x.divides) or (loops and ignores_loops(x))))


def ignores_loops(x: SceneFunction) -> bool:
    """Returns whether a function, or the one that it differentiates, is wrong where loops are
    closed."""
    return x.of_tree or bool(x.differentiates and x.differentiates.of_tree)


def dividing(scene: Scene, functions: Collection[str] = ()) -> tuple[str, ...]:
    """The functions that divide by the mass matrix, and functions that only these call; derivatives
    of functions among them, if these names need them."""
    return tuple(x.name for x in functions_of(scene, functions) if x.divides and not x.internal)


def _matching(scene: Scene, word: str) -> tuple[str, ...]:
    """The functions that a word selects of a scene whose mass matrix is regular; a pattern selects
    derivatives of functions if it matches no others: *_tangent."""
    return matching(word, _names(functions_of(scene))) or matching(
        word, _names(derivatives_of(scene)))


def _names(functions: Iterable[SceneFunction]) -> tuple[str, ...]:
    return tuple(x.name for x in functions if not x.internal)


def left_out(scene: Scene) -> str:
    """Writes one line on the functions that the scene selects, by DEFAULT, ALL or patterns, but
    cannot have; "" if there are none."""
    problem, words = why_singular(scene), scene.functions or (DEFAULT,)
    selected = {name for word in words for name in _matching(scene, word)}
    if not problem or not ({DEFAULT, ALL}.intersection(words) or
                           selected.intersection(dividing(scene, selected))):
        return ""
    return f"forward_dynamics and steps are left out: {problem}"


def refuse_singular(scene: Scene, functions: Collection[str]) -> None:
    """Raise FunctionsError if one of these functions divides by a mass matrix that is singular."""
    wanted = [name for name in reversed(dividing(scene, functions)) if name in functions]
    problem = why_singular(scene) if wanted else ""
    for name in wanted:  # steps first, which call the others
        if problem:
            raise FunctionsError(f"{scene.name}: {name} divides by the mass matrix, but {problem}")


def by_default(scene: Scene) -> tuple[str, ...]:
    """The functions of a scene that selects none: functions whose `default` holds, and functions
    whose results it records or expects."""
    recorded = recorded_functions(scene)
    possible = {*names(scene)}
    return tuple(x.name for x in functions_of(scene) if x.name in possible and (
        x.name in recorded or x.default.holds(scene, x.target)))


def refuse_loops(scene: Scene, functions: Collection[str]) -> None:
    """Raise FunctionsError if one of these functions does not know the scene's closed loops."""
    if not scene.model.loops or not functions:
        return
    for x in functions_of(scene, functions):
        if x.name in functions and ignores_loops(x):
            loops = ", ".join(y.name for y in scene.model.loops)
            raise FunctionsError(f"{scene.name}: {x.name} does not know closed loops ({loops}); "
                                 "wanted a scene without [loops], or functions without it")


def refuse_ambiguous(scene: Scene, functions: Iterable[SceneFunction]) -> None:
    """Raise FunctionsError if two of these functions have one name, as the tangent of jacobian_hand
    has that of the Jacobian of a body called hand_tangent."""
    known: dict[str, SceneFunction] = {}
    for x in functions:
        if (other := known.setdefault(x.name, x)) is not x:
            raise FunctionsError(f"{scene.name}: {x.name} is {_reading(other)}, and "
                                 f"{_reading(x)}, too; rename one")


def _reading(x: SceneFunction) -> str:
    """Says in words what a function's name stands for."""
    if x.differentiates:
        return f"a derivative of {x.differentiates.name}"
    return f"a function of {x.target!r}" if x.target else "a function of the scene"


def refuse_many(scene: Scene) -> None:
    """Raises FunctionsError for a scene of more than MOST joints that move."""
    count = sum(joint.kind.moves for joint in scene.model.joints)
    if count > MOST:
        raise FunctionsError(f"{scene.name}: {count} joints move; wanted at most {MOST}, since no "
                             "C compiler takes the functions of more")


def selected_functions(scene: Scene) -> tuple[str, ...]:
    """The functions that the scene selects, each once, in their order.  Raises FunctionsError."""
    result = resolved(scene, scene.functions)
    own = names(scene)
    known = own if result.issubset(own) else all_names(scene)
    return tuple(name for name in known if name in result)


def resolved(scene: Scene, words: Sequence[str]) -> set[str]:
    """The functions that these words select: names, patterns of them, DEFAULT, ALL; without words,
    DEFAULT. Raises FunctionsError with the nearest name for each unknown word, and for a word that
    selects only functions that divide by a singular mass matrix."""
    known, result, problems = names(scene), set[str](), []
    for word in words or (DEFAULT,):
        if word in (DEFAULT, ALL):
            result.update(by_default(scene) if word == DEFAULT else known)
        elif of := _matching(scene, word):
            possible = {*of}.intersection(known if {*of} <= {*known} else all_names(scene))
            if not possible:
                refuse_singular(scene, of)
                refuse_loops(scene, of)
            result.update(possible)
        else:
            what = "matches no function of the scene" if is_pattern(word) else \
                "is no function of the scene"
            problems.append(f"{word!r} {what}; "
                            f"{did_you_mean(word, (*all_names(scene), DEFAULT, ALL))}")
    if problems:
        raise FunctionsError("; ".join(problems))
    return result


def together(*lists: Iterable[str]) -> tuple[str, ...]:
    """The names, each once, in the order of their first occurrence."""
    return tuple(dict.fromkeys(name for several in lists for name in several))


class TiersError(ReportedError, ValueError):
    """A tier that scenes do not have; the message lists the tiers of scenes."""


def known_tiers() -> tuple[str, ...]:
    """The tiers that scenes have, the cheapest first."""
    from coscrew_codegen.accuracy.tiers import OF_SCENES  # imported on use: most scenes are plain

    return tuple(tier.name for tier in OF_SCENES)


def tiers_on_request() -> tuple[str, ...]:
    """Returns the tiers of functions with a requested accuracy."""
    from coscrew_codegen.accuracy.tiers import OF_SCENES

    return tuple(tier.name for tier in OF_SCENES if tier.on_request)


def tiers_in_ranges() -> tuple[str, ...]:
    """Returns the tiers that need the stated ranges of arguments."""
    from coscrew_codegen.accuracy.tiers import OF_SCENES

    return tuple(tier.name for tier in OF_SCENES if tier.fixed)


def selected_tiers(words: Sequence[str]) -> tuple[str, ...]:
    """The tiers of these names besides plain, which every scene has; the cheapest first.  Raises
    TiersError."""
    if not words:
        return ()
    from coscrew_codegen.accuracy.tiers import PLAIN, TIERS

    names = known_tiers()
    for word in words:
        if word not in names:
            of_library = word in {tier.name for tier in TIERS}
            hint = f"the library alone has it; wanted one of {', '.join(names)}" if of_library \
                else did_you_mean(word, names)
            raise TiersError(f"{word!r} is no tier of scenes; {hint}")
    return tuple(name for name in names if name in words and name != PLAIN.name)
