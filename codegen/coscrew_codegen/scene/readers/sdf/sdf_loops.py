"""Joints of SDF files that close loops: a link may be the child of several.

One of them moves the link in the tree, and the others close loops: those of types that no closure
is like stay in the tree, then those with numbers, as springs, then the first ones."""

from collections.abc import Mapping
from pathlib import Path

from coscrew_codegen.scene.mechanism.loop import HINGE
from coscrew_codegen.scene.mechanism.model import Joint
from coscrew_codegen.scene.mechanism.notices import Notice
from coscrew_codegen.scene.readers.placed_loops import PlacedLoops
from coscrew_codegen.scene.readers.sdf.sdf_joints import AXES, GEARBOX, TYPES, SdfJoints
from coscrew_codegen.scene.readers.xml_files.xml import Element

CLOSURES = {word: closure for word, (_, _, closure) in TYPES.items() if closure}


class SdfLoops(SdfJoints):
    """Reads the joints of one file that close loops."""

    def __init__(self, path: Path) -> None:
        super().__init__(path)
        self.closures = PlacedLoops()
        self.closing: set[str] = set()  # joints that are none of the tree

    def close(self, opened: bool) -> None:
        """Find the joints that close loops; `opened`: leave them out.  Raises SceneError for those
        that no closure is like."""
        held = dict[str, tuple[str, str]]()  # parent and joint in the tree, by child
        for full, joint, scope in sorted(self.every("joint"), key=lambda x: _order(x[1])):
            if joint.attributes.get("type") == GEARBOX:
                self.closing.add(full)
                continue
            parent, child = self.ends(joint, scope)
            if parent == child:
                self.refuse(joint, f"parent and child are the same body, {child!r}")
            if child not in held and _root(held, parent) != child:
                held[child] = parent, full
                continue
            self.closing.add(full)
            if opened:
                self.notices.append(Notice("other tools' joints", f"joint {full}", f"joint {full}: "
                                           "left out (loops)"))
            else:
                self._close(joint, full, scope, held.get(child, ("", ""))[1])

    def _close(self, joint: Element, full: str, scope: str, other: str) -> None:
        word = joint.attributes.get("type", "")
        ends = self.ends(joint, scope)
        if word not in CLOSURES:
            of = f"{ends[1]!r} is the child of {other!r}, too" if other else \
                f"closes a loop, {word}"
            self.refuse(joint, f"{of}, and a {word} joint closes no loop; wanted one of "
                               f"{', '.join(CLOSURES)}, or leave_out = [\"loops\"]")
        if lost := _given(joint):
            self.notices.append(Notice(
                "other tools' numbers", f"joint {full}", f"joint {full}: closes a loop; its "
                f"<{'>, <'.join(lost)}> {'are' if len(lost) > 1 else 'is'} not used"))
        at = ends[1] if word == "fixed" else full
        axis = self.direction(joint, AXES[0], scope) if CLOSURES[word] is HINGE else Joint.axis
        self.closures.close(full, CLOSURES[word], ((x, self.within(x, at)) for x in ends), axis)


def _order(joint: Element) -> tuple[bool, bool]:
    """The order of joints: first those that stay in the tree, others as in the file."""
    closes = joint.attributes.get("type", "") in CLOSURES
    return closes, closes and not _given(joint)


def _given(joint: Element) -> list[str]:
    """The tags below its axis that hold numbers other than zero."""
    return [x.tag for axis in joint.all(AXES[0]) for x in axis.children
            if x.tag in ("dynamics", "limit", "mimic")
            and any(y.strip("0. ") for y in x.attributes.values())]


def _root(held: Mapping[str, tuple[str, str]], link: str) -> str:
    """The first link of a link's tree, or WORLD."""
    while link in held:
        link = held[link][0]
    return link
