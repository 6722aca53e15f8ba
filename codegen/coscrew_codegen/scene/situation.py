"""Properties of scenes on which functions depend, and preconditions of functions."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol

from coscrew_codegen.scene.effect_quantities import states_of
from coscrew_codegen.scene.mechanism.model import WORLD
from coscrew_codegen.scene.scene import Scene


class LinearNames(Protocol):
    """Parameters on which the torques of a scene depend linearly."""

    @property
    def names(self) -> tuple[str, ...]:
        """Their names: forearm.m, viscous.elbow.d."""

    @property
    def units(self) -> tuple[str, ...]:
        """The unit of each."""

    @property
    def base_names(self) -> tuple[str, ...]:
        """Combinations of them that determine the torques: wrist.mx + 0.11 hand.m."""

    @property
    def base_units(self) -> tuple[str, ...]:
        """The unit of each combination."""


class Situation(Protocol):
    """Properties of a scene on which functions depend."""

    scene: Scene

    @property
    def floating(self) -> tuple[str, ...]:
        """The first bodies of trees on which gravity is the only external force."""

    @property
    def kinds(self) -> tuple[str, ...]:
        """The kinds of the joints with coordinates of their own."""

    @property
    def linear(self) -> LinearNames:
        """The parameters on which its torques depend linearly."""

    @property
    def closes(self) -> bool:
        """True if it has a limit that can be hit."""


@dataclass(frozen=True)
class Precondition:
    """Property without which a scene cannot have a function."""

    missing: str  # words for a scene without it
    met: Callable[[Situation], bool]


def carries(scene: Scene) -> bool:
    """Returns whether the velocities of free bases stay the same in the world while they drift."""
    return has_contacts(scene) and any(
        x.kind.floats and x.parent == WORLD for x in scene.model.joints)


def has_switches(scene: Scene) -> bool:
    """Returns whether an effect of the scene has switches."""
    return any(x.effect.switches for x in scene.effects)


def has_contacts(scene: Scene) -> bool:
    """Returns whether bodies of the scene touch the ground or each other."""
    return any(x.effect.parts or x.effect.bodies_force for x in scene.effects)


LOOPS = Precondition("no loop is closed", lambda its: bool(its.scene.model.loops))
LIMITS = Precondition("no limit closes", lambda its: its.closes)
FLOATING = Precondition("no base is floating", lambda its: bool(its.floating))
QUATERNIONS = Precondition("no joint has a quaternion", lambda its: any(
    x.kind.manifold for x in its.scene.model.joints))
CONTACTS = Precondition("nothing touches anything", lambda its: has_contacts(its.scene))
TOUCHING_BASE = Precondition("no free base touches anything", lambda its: carries(its.scene))
STATES = Precondition("no effect has states", lambda its: bool(states_of(its.scene)))
SWITCHES = Precondition("no effect has switches", lambda its: has_switches(its.scene))
