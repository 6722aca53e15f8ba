"""Joints of SDF files that close loops: a link may be the child of several.

One of them moves the link in the tree, and the others close loops: those of types that no closure
is like stay in the tree, then those with numbers, as springs, then the first ones."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path

from coscrew_codegen.scene.joints.fixed import JOINT as FIXED
from coscrew_codegen.scene.mechanism.loop import (
    FRAME,
    HINGE,
    POINT,
    ClosedLoop,
    LoopEnd,
    LoopKind,
)
from coscrew_codegen.scene.mechanism.model import HERE, WORLD, Body, Joint
from coscrew_codegen.scene.mechanism.notices import Notice
from coscrew_codegen.scene.readers.sdf.sdf_frames import turned
from coscrew_codegen.scene.readers.sdf.sdf_joints import SdfJoints
from coscrew_codegen.scene.readers.urdf.xml import Element

CLOSURES: Mapping[str, LoopKind] = {
    "revolute": HINGE, "continuous": HINGE, "ball": POINT, "fixed": FRAME}
"""The closure that is like a joint, by the joint's type."""

_NUMBERS = ("dynamics", "limit", "mimic")


@dataclass
class Closings:
    """The joints that close loops, by full name, and what stands for them."""

    names: set[str] = field(default_factory=set)
    loops: list[ClosedLoop] = field(default_factory=list)
    frames: list[Body | Joint] = field(default_factory=list)


class SdfLoops(SdfJoints):
    """Reads the joints of one file that close loops."""

    def __init__(self, path: Path) -> None:
        super().__init__(path)
        self.closings = Closings()

    def close(self, opened: bool) -> None:
        """Find the joints that close loops; `opened`: leave them out.  Raises SceneError for those
        that no closure is like."""
        joints = [(full, x, scope) for full, (x, scope) in self.frames.items() if x.tag == "joint"]
        held, root = dict[str, str](), dict[str, str]()  # joint by child; a link of its group
        for full, joint, scope in sorted(joints, key=lambda x: self._order(x[1])):
            parent, child = self.ends(joint, scope)
            if parent == child:
                self.refuse(joint, f"parent and child are the same body, {child!r}")
            groups = _root(root, parent), _root(root, child)
            if child not in held and groups[0] != groups[1]:
                held[child], root[groups[1]] = full, groups[0]
            elif opened:
                self.closings.names.add(full)
                self.notices.append(Notice("other tools' joints", f"joint {full}", f"joint {full}: "
                                           "left out (loops)"))
            else:
                self._close(joint, full, scope, held.get(child, ""))
        rigid = dict[str, str]()
        for child, full in held.items():
            joint, scope = self.frames[full]
            if joint.attributes.get("type") == "fixed":
                rigid[child], _ = self.ends(joint, scope)
        self._drop_idle(rigid)

    def _order(self, joint: Element) -> tuple[bool, bool]:
        """The order of joints: first those that stay in the tree, others as in the file."""
        closes = joint.attributes.get("type", "") in CLOSURES
        return closes, closes and not self._given(joint)

    def _given(self, joint: Element) -> list[str]:
        """The tags below its axis that hold numbers other than zero."""
        return [x.tag for axis in joint.all("axis") for x in axis.children
                if x.tag in _NUMBERS and any(_numbers(x))]

    def _close(self, joint: Element, full: str, scope: str, other: str) -> None:
        word = joint.attributes.get("type", "")
        parent, child = self.ends(joint, scope)
        if word not in CLOSURES:
            of = f"{child!r} is the child of {other!r}, too" if other else f"closes a loop, {word}"
            self.refuse(joint, f"{of}, and a {word} joint closes no loop; wanted one of "
                               f"{', '.join(CLOSURES)}, or leave_out = [\"loops\"]")
        if lost := self._given(joint):
            self.notices.append(Notice(
                "other tools' numbers", f"joint {full}", f"joint {full}: closes a loop; its "
                f"<{'>, <'.join(lost)}> {'are' if len(lost) > 1 else 'is'} not used"))
        kind, at = CLOSURES[word], full if word != "fixed" else child
        first, second = (self._closed_end(body, at, full, key, kind) for body, key in (
            (parent, "first"), (child, "second")))
        if kind is HINGE:
            axis = self.direction(joint, scope)
            first, second = (LoopEnd(x.body, x.point, axis=turned(self.within(x.body, at), axis))
                             for x in (first, second))
        self.closings.names.add(full)
        self.closings.loops.append(ClosedLoop(full, kind, first, second))

    def _closed_end(self, body: str, at: str, full: str, key: str, kind: LoopKind) -> LoopEnd:
        """The end of a closure at a frame; a frame turned in its body becomes a body on it."""
        place = self.within(body, at)
        if kind is not FRAME or place.R == HERE.R:
            return LoopEnd(body, place.t)
        name = f"{full}/{key}"
        self.closings.frames += (Body(name), Joint(f"{name}/frame", FIXED, body, name, place))
        return LoopEnd(name)

    def _drop_idle(self, rigid: Mapping[str, str]) -> None:
        """Take out the closures of bodies that cannot move against each other."""
        parts = {x.child: x.parent for x in self.closings.frames if isinstance(x, Joint)}
        links = {**rigid, **parts}
        for loop in tuple(self.closings.loops):
            first, second = (_root(links, x) for x in loop.bodies)
            if first == second:
                self.closings.loops.remove(loop)
                self.notices.append(Notice(
                    "other tools' joints", f"joint {loop.name}", f"joint {loop.name}: holds bodies "
                    "that cannot move against each other, and is not used"))


def _root(above: Mapping[str, str], name: str) -> str:
    """The last of those above a name."""
    while name in above and name != WORLD:
        name = above[name]
    return name


def _numbers(element: Element) -> Iterator[bool]:
    """Returns whether each text or attribute in an element says more than zero."""
    if element.attributes:
        yield True
    for x in element.children:
        yield any(y.text.strip("0. ") for y in x.texts)
