"""SDF's elements: which there are, and their texts, numbers and vectors, or the reason why not."""

from collections import Counter
from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import NoReturn

from coscrew_codegen.scene.mechanism.notices import Notice
from coscrew_codegen.scene.names import did_you_mean
from coscrew_codegen.scene.readers.decimals import numbers_in
from coscrew_codegen.scene.readers.scene_error import SceneError, shown
from coscrew_codegen.scene.readers.xml_files.xml import Element, Text, read_xml

IGNORED = frozenset("""sensor plugin light gripper projector audio_source
audio_sink audio battery particle_emitter scene gui atmosphere spherical_coordinates magnetic_field
state road population actor wind self_collide enable_wind allow_auto_disable must_be_base_link
auto_inertia_params contact""".split())
"""Elements that change no motion of rigid bodies without contact; they are not read."""

SCHEMA: Mapping[str, tuple[str, str]] = {
    "sdf": ("version", "world model"), "world": ("name", "gravity physics model include"),
    "physics": ("*", "gravity *"), "include": ("*", "*"), "model": (
        "name canonical_link", "pose static link joint frame model include"),
    "link": ("name", "pose inertial gravity kinematic velocity_decay visual collision"),
    "visual": ("*", "*"), "collision": ("*", "*"),
    "velocity_decay": ("", "linear angular"), "inertial": ("auto", "pose mass inertia"),
    "inertia": ("", "ixx ixy ixz iyy iyz izz"), "frame": ("name attached_to", "pose"),
    "pose": ("relative_to degrees rotation_format frame", ""), "joint": (
        "name type", "parent child pose axis axis2 physics gearbox_ratio thread_pitch "
        "screw_thread_pitch gearbox_reference_body reference_body"),
    "axis": ("", "xyz dynamics limit mimic use_parent_model_frame initial_position"),
    "axis2": ("", "xyz dynamics limit mimic use_parent_model_frame initial_position"),
    "xyz": ("expressed_in", ""), "limit": (
        "", "lower upper effort velocity stiffness dissipation"),
    "dynamics": ("", "damping friction spring_stiffness spring_reference"),
    "mimic": ("joint axis", "multiplier offset reference")}
"""Attributes and children by element; * for any others.  Elements without an entry hold a text."""

_SEVERAL = frozenset("world model include link joint frame visual collision physics".split())
"""Elements that may stand several times in one."""
_RESERVED = 7
"""The version from which the name `world` is the world's: before, links have it, too."""


class SdfElements:
    """The elements of one file, with the texts of their children among their attributes;
    `notices` collects what is read and not used."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self.notices: list[Notice] = []
        root = read_xml(path, IGNORED, "an SDF")
        if root.tag != "sdf":
            self.refuse(root, f"the root is <{root.tag[:60]}>; wanted <sdf>")
        version = root.attributes.get("version", "")
        if version not in {f"1.{n}" for n in range(3, 13)}:
            self.refuse(root, f"version {shown(version)} of SDF; wanted 1.3 to 1.12")
        self.version = int(version[2:])
        self._check(root)
        self.root = _folded(root)

    def _check(self, owner: Element) -> None:
        """Refuse what SDF does not have, here and below; note other tools' elements."""
        attributes, children = (x.split() for x in SCHEMA.get(owner.tag, ("", "")))
        for name in owner.attributes:
            if name not in attributes and "*" not in attributes and ":" not in name:
                wanted = did_you_mean(name, attributes) if attributes else "wanted none"
                self.refuse(owner, f"unknown attribute {shown(name)} of <{owner.tag}>; {wanted}")
        if owner.texts and children and "*" not in children:
            self.refuse(owner.texts[0], f"<{owner.tag}> holds the text "
                                        f"{shown(owner.texts[0].text)}; wanted elements")
        for child in owner.children:
            if ":" in child.tag:
                joint = child.tag.endswith("joint")
                self.notices.append(Notice(
                    "other tools' joints" if joint else "other tools' numbers", owner.tag,
                    f"line {child.line}: <{child.tag[:60]}> is another tool's and is not used"))
            elif child.tag in children:
                if child.tag not in _SEVERAL and child is not owner.all(child.tag)[0]:
                    self.refuse(child, f"<{child.tag}> occurs twice in <{owner.tag}>; wanted it "
                                       "once")
                self._check(child)
            elif "*" not in children:
                wanted = did_you_mean(child.tag, children) if children else "wanted a text"
                self.refuse(child, f"unknown element <{child.tag[:60]}> in <{owner.tag}>; {wanted}")

    def only(self, owner: Element, tag: str) -> Element | None:
        """The one child with this tag, if there is one."""
        return next(iter(owner.all(tag)), None)

    def text(self, owner: Element, key: str, default: str | None = None) -> str:
        """The text of this name."""
        text = owner.attributes.get(key, "")
        if not text and default is None:
            self.refuse(owner, f"<{owner.tag}> lacks <{key}>")
        return text or str(default)

    def name(self, owner: Element) -> str:
        """The name of an element."""
        name = owner.attributes.get("name", "")
        reserved = name == "__model__" or name == "world" and (
            owner.tag != "link" or self.version >= _RESERVED)
        if not name.strip() or not name.isprintable() or reserved:
            self.refuse(owner, f"name {shown(name)} of <{owner.tag}>; wanted one line of text, and "
                               "no reserved word")
        return name

    def flag(self, owner: Element, key: str, default: str = "false") -> bool:
        """Returns whether a text is true, or 1."""
        text = self.text(owner, key, default)
        if text not in ("true", "false", "1", "0"):
            self.refuse(owner, f"{key} {shown(text)} of <{owner.tag}>; wanted true or false")
        return text in ("true", "1")

    def numbers(self, owner: Element, key: str, count: int, default: str | None = None
                ) -> tuple[Fraction, ...]:
        """The numbers of this name."""
        text = self.text(owner, key, default)
        try:
            return numbers_in(text, count)
        except ValueError as error:
            self.refuse(owner, f"<{key}> of <{owner.tag}>: {error}")

    def number(self, owner: Element, key: str, default: str | None = None,
               nonnegative: bool = False) -> Fraction:
        """The number of this name."""
        number, = self.numbers(owner, key, 1, default)
        if nonnegative and number < 0:
            self.refuse(owner, f"<{key}> of <{owner.tag}> is {float(number):g}; wanted 0 or more")
        return number

    def refuse(self, at: Element | Text, problem: str) -> NoReturn:
        """Raise SceneError that names the file and the line."""
        name = f", {at.tag} {at.attributes['name']!r}" if isinstance(at, Element) and \
            at.attributes.get("name") else ""
        raise SceneError(self.path, f"line {at.line}{name}", problem)


def _folded(element: Element) -> Element:
    """The element with the texts of its children among its attributes, as <mass>1</mass> as
    mass="1"; those of children that occur twice are none of its."""
    times = Counter(x.tag for x in element.children)
    texts = {x.tag: " ".join(y.text for y in x.texts) for x in element.children
             if x.texts and times[x.tag] == 1}
    return replace(element, attributes={**texts, **element.attributes},
                   children=[*map(_folded, element.children)])
