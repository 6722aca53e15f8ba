"""Checks whether a model is physically possible: inertias of bodies, and inertia at every joint.

With `implausible = "warn"` impossible bodies are accepted and reported.

Everything is computed in exact fractions, with the default values of parameters.
"""

from collections.abc import Collection, Iterator
from dataclasses import replace
from fractions import Fraction

from coscrew_codegen.scene.assembly import ModelError
from coscrew_codegen.scene.lumped import LumpedInertia, Six, lumped_inertia
from coscrew_codegen.scene.model import Joint, Kind, Model, value
from coscrew_codegen.scene.tree import tree_of

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

    Raises ModelError for the first such body if it is ERROR, and always for a negative mass.

    Bodies connected by fixed joints are judged together, since only their sum moves: files give
    frames and sensors moments that are not even definite, and which vanish in the sum.  Point
    masses, rods and plates are allowed: moments that are zero, or two that add up to the third."""
    for body in model.bodies:
        if body.inertia and value(body.inertia.mass) < 0:
            raise ModelError(f"body {body.name!r}",
                             f"mass {_shown(value(body.inertia.mass))} kg; wanted a positive mass")
    faults = tuple(_faults(model))
    if faults and implausible == ERROR:
        raise ModelError(faults[0].element,
                         f'{faults[0].problem}; implausible = "{WARN}" accepts it')
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
            yield ModelError(f"body {heavy[0]!r}", f"{problem}{joined}")


def _wrong(mass: Fraction, moments: Six) -> str | None:
    """Why no rigid body has these moments about its centre of mass; None if one can."""
    xx, yy, zz, xy, xz, yz = moments
    slack = SLACK * abs(xx + yy + zz) + mass * FINEST**2
    if not _positive((xx + slack, yy + slack, zz + slack, xy, xz, yz)):
        return f"{_in_words(moments)}: not positive definite"
    half = (xx + yy + zz) / 2 + slack
    if not _positive((half - xx, half - yy, half - zz, -xy, -xz, -yz)):
        return (f"{_in_words(moments)}: the largest principal moment is above the sum of the other "
                "two, as for no distribution of mass")
    return None


def unmoved_mass(model: Model, exempt: Collection[str]) -> tuple[Joint, str] | None:
    """The first joint without inertia against its motion, with the reason; None if there is none.

    Its forward dynamics would divide by zero.  `exempt` names joints that are not checked, since
    they have an inertia of their own (an armature), follow others or are followed."""
    links = tree_of(model, False).links
    inner = {link.parent for link in links}
    massive = set()
    for number, link in reversed(tuple(enumerate(links))):
        if number in massive or any(placed.body.inertia for placed in link.bodies):
            massive |= {number, link.parent}
    for number, link in enumerate(links):
        if link.joint.name in exempt:
            continue
        if number not in massive:
            return link.joint, "neither what it moves nor what moves on that has a mass"
        if number not in inner and not _resists(link.joint, lumped_inertia(link.bodies)):
            return link.joint, "what it moves has no inertia against its motion"
    return None


def _resists(joint: Joint, moved: LumpedInertia) -> bool:
    """Whether the bodies that the joint moves have inertia against its motion."""
    xx, yy, zz, xy, xz, yz = moved.moments
    if joint.kind is Kind.REVOLUTE:
        a, b, c = joint.axis
        about = xx*a*a + yy*b*b + zz*c*c + 2 * (xy*a*b + xz*a*c + yz*b*c)
        return about > 0
    if joint.kind is Kind.SPHERICAL:
        return _definite(moved.moments)
    if joint.kind is Kind.PRISMATIC or not moved.mass:
        return moved.mass > 0
    return _definite(moved.about_com)


def _definite(moments: Six) -> bool:
    return min(_minors(moments)) > 0


def _minors(moments: Six) -> tuple[Fraction, ...]:
    """All principal minors of a symmetric matrix."""
    xx, yy, zz, xy, xz, yz = moments
    yz_minor = yy * zz - yz * yz
    return (xx, yy, zz, xx * yy - xy * xy, xx * zz - xz * xz, yz_minor,
            xx * yz_minor - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz))


def _positive(moments: Six) -> bool:
    """Whether a symmetric matrix is positive semidefinite: no principal minor is negative."""
    return min(_minors(moments)) >= 0


def _in_words(moments: Six) -> str:
    names = ("xx", "yy", "zz", "xy", "xz", "yz")
    return "moments " + ", ".join(f"{name} {_shown(x)}" for name, x in zip(names, moments,
                                                                          strict=True)) + " kg m²"


def _shown(x: Fraction) -> str:
    return f"{float(x):.6g}"
