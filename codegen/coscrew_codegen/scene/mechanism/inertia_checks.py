"""Checks whether a model is physically possible: inertias of bodies, and inertia at every joint.

With `implausible = "warn"` impossible bodies are accepted and reported.

Everything is computed in exact fractions, with the default values of parameters.
"""

import json
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import lru_cache
from typing import Any

from coscrew_codegen.scene.mechanism.assembly import ModelError, followers
from coscrew_codegen.scene.mechanism.model import Joint, Model, value
from coscrew_codegen.scene.mechanism.tree import PlacedBody, Six, lumped_inertia, tree_of
from coscrew_codegen.scene.mechanism.unresisted import Common, alone, common
from coscrew_codegen.scene.names import toml_key
from coscrew_codegen.scene.scene import Applied, Scene

SLACK = Fraction(1, 10**6)
"""Tolerance of the inequalities, relative to xx + yy + zz: files round moments to six digits, and
thin plates, for which xx + yy = zz, then violate them half of the time."""

FINEST = Fraction(1, 10**6)
"""Radius of gyration in m below which moments are residues of arithmetic, such as -5.4e-20 kg m²
for a point mass in a file written by a program."""

ERROR, WARN = "error", "warn"
"""The values of a scene's `implausible`."""


def judged(model: Model, implausible: str) -> Model:
    """The model; if `implausible` is WARN, with a line on each body that cannot exist.

    Raises ModelError that names all such bodies if it is ERROR, and always for a negative mass.

    Bodies connected by fixed joints are judged together, since only their sum moves: files give
    frames and sensors moments that are not even definite, and which vanish in the sum.  Point
    masses, rods and plates are allowed: moments that are zero, or two that add up to the third."""
    for body in model.bodies:
        if body.inertia and value(body.inertia.mass) < 0:
            raise ModelError(f"body {body.name!r}",
                             f"mass {_shown(value(body.inertia.mass))} kg; wanted a positive mass")
    faults = tuple(_faults(model))
    if faults and implausible == ERROR:
        first, *others = faults
        more = f"; impossible, too: {', '.join(x.element for x in others)}" if others else ""
        accepted = f'implausible = "{WARN}" accepts {"them" if others else "it"}'
        raise ModelError(first.element, f"{first.problem}{more}; {accepted}")
    return replace(model, implausible=(*model.implausible, *map(str, faults)))


def _faults(model: Model) -> Iterator[ModelError]:
    """An error for each body that cannot exist, including bodies fixed to the world."""
    tree = tree_of(model, False)
    for bodies in (tree.ground, *(link.bodies for link in tree.links)):
        heavy = [placed.body.name for placed in bodies if placed.body.inertia]
        if not heavy:
            continue
        both = lumped_inertia(bodies)
        problem = ("its mass is zero, its moments are not" if not both.mass
                   else _wrong(both.mass, both.about_com))
        if problem and (both.mass or any(both.moments)):
            joined = f" (with what is fixed to it: {', '.join(heavy)})" if len(heavy) > 1 else ""
            yield ModelError(f"body {_wrong_alone(bodies, heavy[0])!r}", f"{problem}{joined}")


def _wrong_alone(bodies: Sequence[PlacedBody], default: str) -> str:
    """The name of the first body that cannot exist by itself; the default if each can."""
    of = {x.body.name: lumped_inertia((x,)) for x in bodies if x.body.inertia}
    return next((name for name, x in of.items() if x.mass and _wrong(x.mass, x.about_com)),
                default)


def _wrong(mass: Fraction, moments: Six) -> str | None:
    """Says why no rigid body has these moments about its centre of mass; None if one can."""
    xx, yy, zz, xy, xz, yz = moments
    slack = SLACK * abs(xx + yy + zz) + mass * FINEST**2
    if not _positive((xx + slack, yy + slack, zz + slack, xy, xz, yz)):
        return f"{_in_words(moments)}: not positive definite"
    half = (xx + yy + zz) / 2 + slack
    if not _positive((half - xx, half - yy, half - zz, -xy, -xz, -yz)):
        return (f"{_in_words(moments)}: the largest principal moment is above the sum of the other "
                "two, as for no distribution of mass")
    return None


@dataclass(frozen=True)
class Unmoved:
    """A joint without inertia against its motion; `massive` if the bodies that it moves have a
    mass."""

    joint: Joint
    massive: bool


def unmoved(scene: Scene) -> tuple[Unmoved, ...]:
    """The joints without inertia against their motion: the mass matrix is singular.

    An effect (an armature) gives a joint an inertia of its own; joints that follow others move as
    one with their leader, and one of them with inertia is enough."""
    follow = followers(scene)
    without = alone(scene.model, tuple(follow.items()))
    joints = [x for x in scene.model.joints if x.kind.moves
              and (x.name not in follow or follow[x.name].multiplier)]
    leader = {x.name: follow[x.name].joint if x.name in follow else x.name for x in joints}
    resisting = {leader[x.name] for x in joints if x.name not in without}
    resisting |= {leader[name] for name in _held(scene) if name in leader}
    massive = _massive(scene.model)
    return tuple(Unmoved(x, x.name in massive) for x in joints if leader[x.name] not in resisting)


def _held(scene: Scene) -> frozenset[str]:
    """The joints with an inertia of their own that is not zero; one on a sum of coordinates counts
    for one joint of them, if possible for one without."""
    acting = [x for x in scene.effects if _inertia(x)]
    held = {x.on for x in acting if not x.terms}
    without = alone(scene.model, tuple(followers(scene).items()))
    for x in acting:
        joints = [term.joint for term in x.terms if term.joint not in held]
        held |= {*sorted(joints, key=lambda name: name not in without)[:1]}
    return frozenset(held)


def _inertia(applied: Applied) -> bool:
    """Returns whether the effect gives its joint an inertia; parameters and formulas do."""
    if not applied.effect.joint_inertia:
        return False
    numbers: Any = {name: x for name, x in applied.values.items() if x is not None}
    return (not all(isinstance(x, Fraction) for x in numbers.values())
            or bool(applied.effect.joint_inertia(numbers)))


@lru_cache(maxsize=8)
def _massive(model: Model) -> frozenset[str]:
    """The joints that move anything with an inertia."""
    links = tree_of(model, False).links
    massive: set[int] = set()
    for number, link in reversed(tuple(enumerate(links))):
        if number in massive or any(placed.body.inertia for placed in link.bodies):
            massive |= {number, link.parent}
    return frozenset(link.joint.name for number, link in enumerate(links) if number in massive)


def why_singular(scene: Scene) -> str:
    """Names all joints that make the mass matrix singular, and one remedy; "" if there are none."""
    unmoved_motions = unmoved(scene)
    held = _held(scene) | {x.joint.name for x in unmoved_motions}
    several = common(scene.model, tuple(followers(scene).items()), held)
    if not unmoved_motions and not several.joints:
        return ""
    without, massive = ([x.joint.name for x in unmoved_motions if x.massive == kind]
                        for kind in (False, True))
    causes = [f"{_joints(without)} {_verb(without, 'move')} nothing that has a mass"] \
        if without else []
    if massive:
        causes.append(f"what {_joints(massive)} {_verb(massive, 'move')} has no inertia against "
                      "that motion")
    if several.joints:
        causes.append(f"{_joints(several.joints)} can move together without inertia against that "
                      "motion")
    return f"{' and '.join(causes)}, so that the mass matrix is singular; wanted " \
           f"{_remedy(scene, unmoved_motions, several)}"


def _remedy(scene: Scene, unmoved_motions: Sequence[Unmoved], several: Common) -> str:
    """Armatures that make the mass matrix regular; masses, if joints with several coordinates need
    them."""
    if any(x.joint.kind.nv > 1 for x in unmoved_motions) or several.joints and not several.cure:
        return "masses and moments in what they move"
    names = {*several.cure, *(x.joint.name for x in unmoved_motions)}
    given = {x.on for x in scene.effects if x.effect.joint_inertia and not x.terms}
    zeros, others = ([x.name for x in scene.model.joints if x.name in names
                      and (x.name in given) == zero] for zero in (True, False))
    parts = [f"a positive inertia of {', '.join(map(repr, zeros))} in [effects.armature]"] \
        if zeros else []
    return " and ".join([*parts, *([_armatures(others, scene)] if others else [])])


def _armatures(joints: Sequence[str], scene: Scene) -> str:
    """Armatures of these joints in TOML, in tables of their own if there are others."""
    quoted = [json.dumps(name, ensure_ascii=False) for name in joints]
    if not any(x.effect.name == "armature" for x in scene.effects):
        return f"[effects.armature] with joints = [{', '.join(quoted)}] and inertia = 1e-3"
    tables = ", ".join(f"[effects.armature.{toml_key(name)}]" for name in joints)
    return f"{tables} with inertia = 1e-3, beside the armatures that there are"


def _joints(names: Sequence[str]) -> str:
    """joint 'a'; joints 'a', 'b'."""
    return f"joint{'s' if len(names) > 1 else ''} {', '.join(map(repr, names))}"


def _verb(names: Sequence[str], word: str) -> str:
    return word if len(names) > 1 else f"{word}s"


def _minors(moments: Six) -> tuple[Fraction, ...]:
    """All principal minors of a symmetric matrix."""
    xx, yy, zz, xy, xz, yz = moments
    yz_minor = yy * zz - yz * yz
    return (xx, yy, zz, xx * yy - xy * xy, xx * zz - xz * xz, yz_minor,
            xx * yz_minor - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz))


def _positive(moments: Six) -> bool:
    """Returns whether a symmetric matrix is positive semidefinite: no principal minor is negative.
    """
    return min(_minors(moments)) >= 0


def _in_words(moments: Six) -> str:
    names = ("xx", "yy", "zz", "xy", "xz", "yz")
    return "moments " + ", ".join(f"{name} {_shown(x)}" for name, x in zip(names, moments,
                                                                          strict=True)) + " kg m²"


def _shown(x: Fraction) -> str:
    return f"{float(x):.6g}"
