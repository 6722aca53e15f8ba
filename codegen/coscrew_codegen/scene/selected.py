"""The functions of a scene by name, and their selection: by `functions` in its file, by --functions
or by load_scene.

A function that is not selected is neither derived, emitted nor compiled.
"""

from collections.abc import Collection, Iterable, Sequence

from coscrew_codegen.errors import ReportedError
from coscrew_codegen.identifiers import identifiers
from coscrew_codegen.integrators import DEFAULT as DEFAULT_INTEGRATOR
from coscrew_codegen.integrators import EMITTED, named
from coscrew_codegen.scene.effect_quantities import functions_of_effects
from coscrew_codegen.scene.model import WORLD, Kind
from coscrew_codegen.scene.names import did_you_mean
from coscrew_codegen.scene.patterns import is_pattern, matching
from coscrew_codegen.scene.possible import why_singular
from coscrew_codegen.scene.recorded import recorded_functions
from coscrew_codegen.scene.scene import Scene

DEFAULT, ALL = "default", "all"
"""Words for several functions: those of a scene that selects none, and all it can have."""

DYNAMICS = ("inverse_dynamics", "forward_dynamics", "mass_matrix", "bias_torques",
            "gravity_torques", "energy", "power", "momentum", "body_poses", "body_twists")
FREE = ("free_momentum", "with_free_momentum")
"""Functions of scenes with a floating base."""
CONTACTS = ("closing_contacts", "parts")
"""Functions of scenes with limits that can be hit."""
MOVED = "integrated"
DIVIDING = {"forward_dynamics", *FREE, *CONTACTS,
            *(name for x in EMITTED for name in (x.step_name, x.step_with_tau))}
"""Functions that divide by the mass matrix, and those that only these call."""
MANY = 100
"""Velocities (NV) above which the mass matrix is not a default function: its text grows with their
square, that of the others linearly."""
MOST = 1000
"""Largest number of joints that move: their functions are 100 MB of C, too much for compilers."""


class FunctionsError(ReportedError, ValueError):
    """A function that the scene does not have; the message gives the nearest name."""


def jacobians(scene: Scene) -> dict[str, str]:
    """Bodies by the names of their Jacobians: jacobian_hand."""
    bodies, links = [body.name for body in scene.model.bodies], scene.model.links()
    return {f"jacobian_{name}": body for name, body in zip(identifiers(bodies), bodies, strict=True)
            if links[body] != WORLD}


def reactions(scene: Scene) -> dict[str, str]:
    """Joints that move by the names of their reactions: reaction_elbow."""
    joints = [joint.name for joint in scene.model.joints if joint.kind is not Kind.FIXED]
    return {f"reaction_{name}": joint
            for name, joint in zip(identifiers(joints), joints, strict=True)}


def names(scene: Scene) -> tuple[str, ...]:
    """All functions that the scene can have, in the order in which they are emitted."""
    singular = why_singular(scene)
    return tuple(name for name in _names(scene) if not singular or name not in DIVIDING)


def _names(scene: Scene) -> tuple[str, ...]:
    """The functions of a scene whose mass matrix is regular."""
    return (*DYNAMICS, *jacobians(scene), *reactions(scene), *functions_of_effects(scene), MOVED,
            *FREE, *CONTACTS, *(x.step_name for x in EMITTED),
            *(x.step_with_tau for x in EMITTED))


def left_out(scene: Scene) -> str:
    """One line on the functions that the scene selects, by DEFAULT, ALL or patterns, and cannot
    have; "" if there are none."""
    problem, words = why_singular(scene), scene.functions or (DEFAULT,)
    if not problem or not ({DEFAULT, ALL}.intersection(words) or DIVIDING.intersection(
            name for word in words for name in matching(word, _names(scene)))):
        return ""
    return f"forward_dynamics and steps are left out: {problem}"


def refuse_singular(scene: Scene, functions: Collection[str]) -> None:
    """Raise FunctionsError if one of these functions divides by a mass matrix that is singular."""
    problem = why_singular(scene) if DIVIDING.intersection(functions) else ""
    for name in reversed(_names(scene)):  # steps first, which call the others
        if problem and name in DIVIDING and name in functions:
            raise FunctionsError(f"{scene.name}: {name} divides by the mass matrix, but {problem}")


def by_default(scene: Scene) -> tuple[str, ...]:
    """The functions of a scene that selects none: its dynamics (without the mass matrix if there
    are more than MANY velocities); reactions that effects, records or expectations need; effects
    that are recorded or expected; momenta of floating bases; contacts; the step of its integrator,
    or of the default one if SciPy's."""
    integrator = named(scene.run.integrator)
    if not integrator.emitted:
        integrator = named(DEFAULT_INTEGRATOR)
    recorded = {x.on for x in scene.effects if x.effect.reaction}
    found = {*DYNAMICS, *(name for name, joint in reactions(scene).items() if joint in recorded),
             *recorded_functions(scene), MOVED, *FREE, *CONTACTS, integrator.step_name}
    if speeds(scene) > MANY:
        found.remove("mass_matrix")
    return tuple(name for name in names(scene) if name in found)


def speeds(scene: Scene) -> int:
    """The number of velocities of the joints, including followers."""
    return sum(joint.kind.nv for joint in scene.model.joints)


def refuse_many(scene: Scene) -> None:
    """Raise FunctionsError for a scene of more than MOST joints that move."""
    count = sum(joint.kind is not Kind.FIXED for joint in scene.model.joints)
    if count > MOST:
        raise FunctionsError(f"{scene.name}: {count} joints move; wanted at most {MOST}, since of "
                             "more no C compiler takes the functions")


def selected_functions(scene: Scene) -> tuple[str, ...]:
    """The functions that the scene selects, each once, in their order.  Raises FunctionsError."""
    found = resolved(scene, scene.functions)
    return tuple(name for name in names(scene) if name in found)


def resolved(scene: Scene, words: Sequence[str]) -> set[str]:
    """The functions that these words select: names, patterns of them, DEFAULT, ALL; without words,
    DEFAULT.  Raises FunctionsError with the nearest name for each unknown word, and for a word
    that selects nothing but what divides by a singular mass matrix."""
    known, found = names(scene), set[str]()
    unknown = []
    for word in words or (DEFAULT,):
        if word in (DEFAULT, ALL):
            found.update(by_default(scene) if word == DEFAULT else known)
        elif of := matching(word, _names(scene)):
            if not set(of).intersection(known):
                refuse_singular(scene, of)
            found.update(of)
        else:
            what = "matches no function of the scene" if is_pattern(word) else \
                "is no function of the scene"
            unknown.append(f"{word!r} {what}; {did_you_mean(word, (*known, DEFAULT, ALL))}")
    if unknown:
        raise FunctionsError("; ".join(unknown))
    return found.intersection(known)


def together(*lists: Iterable[str]) -> tuple[str, ...]:
    """The names, each once, in the order of their first occurrence."""
    return tuple(dict.fromkeys(name for several in lists for name in several))
