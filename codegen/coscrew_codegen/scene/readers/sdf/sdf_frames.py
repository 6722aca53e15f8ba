"""Frames of an SDF model: poses relative to one another, and the links to which they are fixed."""

from fractions import Fraction
from pathlib import Path

from coscrew_codegen.scene.constants import constant
from coscrew_codegen.scene.mechanism import rotations
from coscrew_codegen.scene.mechanism.model import HERE, WORLD, Placement
from coscrew_codegen.scene.mechanism.notices import Notice
from coscrew_codegen.scene.mechanism.tree import composed, inverse, without_residue
from coscrew_codegen.scene.names import did_you_mean
from coscrew_codegen.scene.readers.scene_error import shown
from coscrew_codegen.scene.readers.sdf.sdf_elements import SdfElements
from coscrew_codegen.scene.readers.xml_files.xml import Element

MODEL = "__model__"
_WORLD_LINK = f"{WORLD}_"


class SdfFrames(SdfElements):
    """The frames of one file by full name, arm::hand::palm: links, frames, joints and models."""

    def __init__(self, path: Path) -> None:
        super().__init__(path)
        self.frames: dict[str, tuple[Element, str]] = {}  # element, scope: "arm::hand::"
        self._above: dict[str, tuple[str, ...]] = {}  # (): it is being looked up

    def collect(self, model: Element, scope: str) -> None:
        """Add the frames of a model and of the models in it."""
        self.refuse_includes(model)
        self.frames[f"{scope}{MODEL}"] = model, scope
        for element in (*model.all("link"), *model.all("frame"), *model.all("joint")):
            full = f"{scope}{_own(self.name(element))}"
            if full in self.frames:
                other = self.frames[full][0]
                self.refuse(element, f"the <{other.tag}> in line {other.line} has this name, too; "
                                     "wanted another one")
            self.frames[full] = element, scope
            if full == f"{scope}{_WORLD_LINK}":
                self.notices.append(Notice("other tools' joints", f"body {full}", f"body {full}: "
                                           "is the link 'world', to which joints refer here"))
        for inner in model.all("model"):
            self.collect(inner, f"{scope}{self.name(inner)}::")

    def every(self, tag: str) -> list[tuple[str, Element, str]]:
        """The elements with this tag: full name, element, scope."""
        return [(full, x, scope) for full, (x, scope) in self.frames.items() if x.tag == tag]

    def refuse_includes(self, owner: Element) -> None:
        """Refuse references to other files."""
        for include in owner.all("include"):
            self.refuse(include, "<include>: the model is in another file; wanted it in this one, "
                                 "as `gz sdf -p FILE` writes it")

    def resolved(self, at: Element, scope: str, name: str) -> str:
        """The full name of a frame that an element in this scope names."""
        own = f"{scope}{_own(name)}"
        names = [x for x in (own, f"{own}::{MODEL}") if x in self.frames]
        if not names:
            known = [x.removeprefix(scope) for x in self.frames if x.startswith(scope)]
            self.refuse(at, f"no frame {shown(name)}; {did_you_mean(name, known)}")
        return names[0]

    def is_world(self, scope: str, name: str) -> bool:
        """Returns whether a name is that of the world, and not of a link, in this scope."""
        return name == WORLD and f"{scope}{_WORLD_LINK}" not in self.frames

    def link_of(self, full: str, seen: tuple[str, ...] = ()) -> str:
        """The link to which a frame is fixed."""
        element, scope = self.frames[full]
        if full in seen:
            self.refuse(element, f"{', '.join(seen)} are attached to one another; wanted a link")
        if element.tag == "link":
            return full
        name = self._fixed_to(element)
        if element.tag == "model":
            links = [x.attributes.get("name", "") for x in (*element.all("link"),
                                                            *element.all("model"))]
            if not links:
                self.refuse(element, "has no link")
            name = element.attributes.get("canonical_link", "") or links[0]
        return self.link_of(self.resolved(element, scope, name), (*seen, full))

    def _fixed_to(self, element: Element) -> str:
        """The frame to which a frame, or a joint, is fixed, as the element names it."""
        if element.tag == "joint":
            return self.text(element, "child")
        return element.attributes.get("attached_to", "") or MODEL

    def within(self, outer: str, inner: str) -> Placement:
        """The frame `inner` in the frame `outer`, or in WORLD: exact where both are relative to a
        third."""
        common = next(x for x in self._chain(inner) if x in self._chain(outer))
        return without_residue(composed(inverse(self._down(common, outer)),
                                        self._down(common, inner)))

    def _down(self, common: str, full: str) -> Placement:
        """The frame in one above it."""
        pose = HERE
        for name in self._chain(full):
            if name == common:
                break
            pose = composed(self.pose(self.frames[name][0]), pose)
        return pose

    def _chain(self, full: str) -> tuple[str, ...]:
        """The frame, the frame in which its pose is given, and so on to WORLD."""
        if full == WORLD:
            return (WORLD,)
        if full not in self._above:
            self._above[full] = ()
            self._above[full] = (full, *self._chain(self._base(*self.frames[full])))
        if not (chain := self._above[full]):
            circle = ", ".join(x for x, y in self._above.items() if not y)
            self.refuse(self.frames[full][0], f"the poses of {circle} are relative to one another; "
                                              "wanted one that is not")
        return chain

    def _base(self, element: Element, scope: str) -> str:
        """The full name of the frame in which a frame's pose is given, or WORLD."""
        pose = self.only(element, "pose")
        name = pose.attributes.get("relative_to", "") if pose else ""
        if element.tag != "model":
            return self.resolved(element, scope, name or self._fixed_to(element))
        if scope:
            head, colons, _ = scope[:-2].rpartition("::")
            return self.resolved(element, f"{head}{colons}", name or MODEL)
        if name not in ("", WORLD):
            self.refuse(element, f"the model's pose is relative to {shown(name)}; wanted the world")
        return WORLD

    def pose(self, owner: Element) -> Placement:
        """The numbers of an element's <pose>: x y z and roll pitch yaw, or a quaternion."""
        pose = self.only(owner, "pose")
        if pose is not None and pose.attributes.get("frame"):  # of 1.5 and 1.6, where it is empty
            self.refuse(pose, f"frame {shown(pose.attributes['frame'])} of <pose>; wanted "
                              "relative_to")
        if pose is None or not pose.texts:
            return HERE
        form = pose.attributes.get("rotation_format", "euler_rpy")
        if form not in ("euler_rpy", "quat_xyzw"):
            self.refuse(pose, f"rotation_format {shown(form)}; wanted euler_rpy or quat_xyzw")
        in_degrees = self.flag(pose, "degrees")
        if form == "euler_rpy":
            x, y, z, *angles = self.numbers(owner, "pose", 6)
            unit = constant("pi/180") if in_degrees else Fraction(1)
            return Placement(rotations.from_rpy(*(unit * angle for angle in angles)), (x, y, z))
        x, y, z, *quaternion = self.numbers(owner, "pose", 7)
        if in_degrees or not any(quaternion):
            self.refuse(pose, "holds a quaternion that is zero, or in degrees; wanted x, y, z, w "
                              "of a unit quaternion")
        return Placement(rotations.from_quaternion(quaternion), (x, y, z))


def _own(name: str) -> str:
    """The name of a link, frame or joint here: a link may be called `world` in old files."""
    return _WORLD_LINK if name == WORLD else name
