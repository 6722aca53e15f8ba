"""Joints of SDF files.  A universal joint whose file gives one of its axes a number, as a damping,
and a revolute2 joint are two revolute ones in series, NAME and NAME/2.

A link keeps the frame that its file gives it.  Where the joint's frame stands elsewhere, a link
without mass, NAME/link, turns there, and the file's link is fixed to it.
"""

from collections.abc import Iterator, Mapping
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

from coscrew_codegen.scene.joints.fixed import JOINT as FIXED
from coscrew_codegen.scene.joints.prismatic import JOINT as PRISMATIC
from coscrew_codegen.scene.joints.revolute import JOINT as REVOLUTE
from coscrew_codegen.scene.joints.spherical import JOINT as SPHERICAL
from coscrew_codegen.scene.joints.universal import JOINT as UNIVERSAL
from coscrew_codegen.scene.mechanism import rotations
from coscrew_codegen.scene.mechanism.joint_kind import JointKind
from coscrew_codegen.scene.mechanism.loop import FRAME, HINGE, POINT, LoopKind
from coscrew_codegen.scene.mechanism.model import (
    HERE,
    WORLD,
    Body,
    Joint,
    Limits,
    Mimic,
    Placement,
)
from coscrew_codegen.scene.mechanism.notices import Notice
from coscrew_codegen.scene.mechanism.tree import composed, inverse
from coscrew_codegen.scene.names import or_mean
from coscrew_codegen.scene.readers.scene_error import shown
from coscrew_codegen.scene.readers.sdf.sdf_frames import MODEL, SdfFrames
from coscrew_codegen.scene.readers.toml.toml_tables import Decimals
from coscrew_codegen.scene.readers.xml_files.xml import Element

TYPES: Mapping[str, tuple[JointKind, int, LoopKind | None]] = {
    "revolute": (REVOLUTE, 1, HINGE), "continuous": (REVOLUTE, 1, HINGE),
    "prismatic": (PRISMATIC, 1, None), "universal": (REVOLUTE, 2, None),
    "revolute2": (REVOLUTE, 2, None), "ball": (SPHERICAL, 0, POINT), "fixed": (FIXED, 0, FRAME)}
"""The kind and the number of axes of each type, and the closure of a loop that is like it."""
GEARBOX = "gearbox"  # connects no links: a joint follows another

_RIGHT = Fraction(1, 10**30)  # cosine of two axes below which they are perpendicular
_UNLIMITED = Fraction(10)**16  # numbers from here on stand for none
AXES = ("axis", "axis2")
_OWN = 5
"""The version from which axes are given in the joint's frame: before, in the model's."""
_UNUSED = ("initial_position", "stiffness", "dissipation")


class SdfJoints(SdfFrames):
    """Reads the joints of one file; `springs` collects those that they declare."""

    def __init__(self, path: Path) -> None:
        super().__init__(path)
        self.springs: dict[str, dict[str, object]] = {}
        self.leaders = {x.attributes.get("joint", "").rpartition("::")[2]
                        for x in self.root.every("mimic")}

    def joint(self, joint: Element, full: str, scope: str) -> Iterator[Joint | Body]:
        """The joint, or the chain of joints, and the links without mass in it."""
        word = joint.attributes.get("type", "")
        if word not in TYPES:
            self.refuse(joint, f"type {shown(word)}; wanted one of "
                               f"{', '.join((*TYPES, GEARBOX))}{or_mean(word, TYPES)}")
        kind, count, _ = TYPES[word]
        parent, child = self.ends(joint, scope)
        for tag in AXES[count:] if kind is not FIXED else ():
            if axis := self.only(joint, tag):
                self._beyond(axis, full, kind)
        self.notices += self._unused(joint, f"joint {full}")
        if kind is FIXED:
            yield Joint(full, kind, parent, child, self.within(parent, child))
            return
        at = self.within(parent, full)
        last = Joint(full, kind, parent, child, at)
        if count == 2:
            first = self._moving(joint, AXES[0], replace(last, child=f"{full}/between"), scope)
            second = Joint(f"{full}/2", kind, first.child, child)
            last = self._moving(joint, AXES[1], second, scope)
            if word == UNIVERSAL.name and self._without_numbers(first, last):
                last = Joint(full, UNIVERSAL, parent, child, at, first.axis, axis2=last.axis)
            else:
                yield from (Body(first.child), first)
        elif count == 1:
            last = self._moving(joint, AXES[0], last, scope)
        yield from self._with_child(last, full, child)

    def _with_child(self, joint: Joint, full: str, child: str) -> Iterator[Joint | Body]:
        """The joint that moves the file's link, or a link at the joint's frame that carries it."""
        back = self.within(full, child)
        if _same_motion(joint, back):
            own = [rotations.turned(inverse(back).R, axis) for axis in joint.axes] or [joint.axis]
            yield replace(joint, placement=composed(joint.placement, back), axis=own[0],
                          axis2=own[1] if len(own) > 1 else None)
            return
        link = f"{joint.name}/link"
        yield from (Body(link), replace(joint, child=link),
                    Joint(f"{full}/body", FIXED, link, child, back))

    def _without_numbers(self, first: Joint, second: Joint) -> bool:
        """Returns whether two revolute joints in series are a universal joint: at right angles,
        without numbers of one of them, and no joint follows one."""
        bare = all(replace(x, axis=Joint.axis) == Joint(x.name, x.kind, x.parent, x.child,
                                                        x.placement) for x in (first, second))
        led = first.name.rpartition("::")[2] in self.leaders
        cosine = sum((x * y for x, y in zip(first.axis, second.axis, strict=True)), Fraction(0))
        return bare and not led and abs(cosine) < _RIGHT and not (
            {first.name, second.name} & {*self.springs})

    def _beyond(self, axis: Element, full: str, kind: JointKind) -> None:
        """Refuse an axis that joints of this kind do not have; note that of a ball joint, which old
        files have and no program uses."""
        if kind is not SPHERICAL:
            self.refuse(axis, f"<{axis.tag}> of a {kind.name} joint; wanted none")
        of = f"joint {full}"
        self.notices.append(Notice("other tools' numbers", of, f"{of}: <{axis.tag}> in line "
                                   f"{axis.line}, of a ball joint, is not used"))

    def _unused(self, joint: Element, of: str) -> Iterator[Notice]:
        """Notices of the numbers of a joint's axes that nothing uses."""
        for axis in (y for tag in AXES for y in joint.all(tag)):
            for x in (z for y in (axis, *axis.all("limit")) for z in y.children
                      if z.tag in _UNUSED and self.number(y, z.tag)):
                yield Notice("other tools' numbers", of, f"{of}: <{x.tag}> in line {x.line} is "
                             "used by no effect")

    def ends(self, joint: Element, scope: str) -> tuple[str, str]:
        """The links that the joint connects."""
        near, far = self.text(joint, "parent"), self.text(joint, "child")
        parent = WORLD if self.is_world(scope, near) else \
            self.link_of(self.resolved(joint, scope, near))
        return parent, self.link_of(self.resolved(joint, scope, far))

    def _moving(self, owner: Element, tag: str, joint: Joint, scope: str) -> Joint:
        """The joint with the numbers of its axis."""
        axis = self._axis(owner, tag)
        lower, upper, effort, velocity = self._limits(axis, owner.attributes["type"])
        dynamics = self.only(axis, "dynamics")
        damping, friction = (self.number(dynamics, x, "0", True) if dynamics else None
                             for x in ("damping", "friction"))
        if dynamics and self.number(dynamics, "spring_stiffness", "0", True):
            self.springs[joint.name] = {
                "k": Decimals(self.text(dynamics, "spring_stiffness")),
                "q0": Decimals(self.text(dynamics, "spring_reference", "0"))}
            self.number(dynamics, "spring_reference", "0")
        return replace(joint, axis=self.direction(owner, tag, scope), lower=lower, upper=upper,
                       effort=effort, velocity=velocity, damping=damping, friction=friction,
                       mimic=self._mimic(axis, scope))

    def direction(self, joint: Element, tag: str, scope: str) -> tuple[Fraction, ...]:
        """The axis of this tag in the joint's frame, of norm 1."""
        axis = self._axis(joint, tag)
        given = self.numbers(axis, "xyz", 3, "0 0 1")
        if not any(given):
            self.refuse(axis, "the axis is zero; wanted a direction")
        xyz = self.only(axis, "xyz")
        of = xyz.attributes.get("expressed_in", "") if xyz else ""
        if not of and self.flag(axis, "use_parent_model_frame", str(self.version < _OWN).lower()):
            of = MODEL
        if of:
            own = self.resolved(joint, scope, self.name(joint))
            given = rotations.turned(self.within(own, self.resolved(axis, scope, of)).R, given)
        return rotations.unit(given)

    def _axis(self, joint: Element, tag: str) -> Element:
        return self.only(joint, tag) or self.refuse(joint, f"lacks <{tag}>")

    def _limits(self, axis: Element, word: str) -> Limits:
        limit = self.only(axis, "limit")
        if limit is None:
            return (None,) * 4
        lower, upper, effort, velocity = (self._end(limit, tag) for tag in (
            "lower", "upper", "effort", "velocity"))
        if lower is not None and upper is not None and lower > upper:
            self.refuse(limit, f"lower, {float(lower):g}, is above upper, {float(upper):g}")
        if word == "continuous":
            lower = upper = None
        effort, velocity = (None if x is None or x < 0 else x for x in (effort, velocity))
        return lower, upper, effort, velocity

    def _end(self, limit: Element, tag: str) -> Fraction | None:
        """A limit; None if it is not given, or infinite."""
        text = self.text(limit, tag, "inf")
        if text.lstrip("+-").lower() in ("inf", "infinity"):
            return None
        number = self.number(limit, tag)
        return None if abs(number) >= _UNLIMITED else number

    def _mimic(self, axis: Element, scope: str) -> Mimic | None:
        """q = multiplier (q of the leader - reference) + offset."""
        mimic = self.only(axis, "mimic")
        if mimic is None:
            return None
        leader = self.resolved(mimic, scope, mimic.attributes.get("joint", ""))
        of = mimic.attributes.get("axis", AXES[0])
        if of not in AXES:
            self.refuse(mimic, f"axis {shown(of)}; wanted one of {', '.join(AXES)}")
        multiplier, offset, reference = (self.number(mimic, x, "0") for x in (
            "multiplier", "offset", "reference"))
        return Mimic(leader if of == AXES[0] else f"{leader}/2", multiplier,
                     offset - multiplier * reference)


def _same_motion(joint: Joint, child: Placement) -> bool:
    """Returns whether the joint moves a frame at `child` as it moves its own: what slides, what
    turns about an axis through that frame's origin, and what turns about the same point and axes.
    """
    if joint.kind is SPHERICAL:
        return child == HERE
    if joint.kind is UNIVERSAL:
        return not any(child.t)
    x, y, z = child.t
    a, b, c = joint.axis
    return joint.kind is PRISMATIC or not any((y * c - z * b, z * a - x * c, x * b - y * a))
