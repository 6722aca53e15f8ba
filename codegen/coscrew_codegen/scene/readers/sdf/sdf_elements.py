"""SDF's elements: which there are, and their texts, numbers and vectors, or the reason why not."""

from collections.abc import Iterator, Mapping
from fractions import Fraction
from pathlib import Path
from typing import NoReturn

from coscrew_codegen.scene.mechanism.notices import Notice
from coscrew_codegen.scene.names import did_you_mean
from coscrew_codegen.scene.readers.decimals import decimal
from coscrew_codegen.scene.readers.scene_error import SceneError, shown
from coscrew_codegen.scene.readers.urdf.xml import Element, Text, read_xml

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

_RESERVED = 7
"""The version from which the name `world` is the world's: before, links have it, too."""

TOLD = ("initial_position", "stiffness", "dissipation")
"""Numbers that nothing uses: told unless they are zero."""


class SdfElements:
    """The elements of one file; `notices` collects what is read and not used."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self.notices: list[Notice] = []
        self.root = read_xml(path, IGNORED, "an SDF")
        if self.root.tag != "sdf":
            self.refuse(self.root, f"the root is <{self.root.tag[:60]}>; wanted <sdf>")
        version = self.root.attributes.get("version", "")
        if version not in {f"1.{n}" for n in range(3, 13)}:
            self.refuse(self.root, f"version {shown(version)} of SDF; wanted 1.3 to 1.12")
        self.version = int(version[2:])
        self._check(self.root)

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
                self._check(child)
            elif "*" not in children:
                wanted = did_you_mean(child.tag, children) if children else "wanted a text"
                self.refuse(child, f"unknown element <{child.tag[:60]}> in <{owner.tag}>; {wanted}")

    def only(self, owner: Element, tag: str) -> Element | None:
        """The one child with this tag, if there is one."""
        elements = owner.all(tag)
        if len(elements) > 1:
            self.refuse(elements[1], f"<{tag}> occurs twice in <{owner.tag}>; wanted it once")
        return elements[0] if elements else None

    def text(self, owner: Element, tag: str, default: str | None = None) -> str:
        """The text in the child with this tag."""
        element = self.only(owner, tag)
        text = " ".join(x.text for x in element.texts) if element else ""
        if not text and default is None:
            self.refuse(owner, f"<{owner.tag}> lacks <{tag}>")
        return text or str(default)

    def name(self, owner: Element, attribute: str = "name") -> str:
        """A name that an attribute gives."""
        name = owner.attributes.get(attribute, "")
        reserved = name == "__model__" or name == "world" and (
            owner.tag != "link" or self.version >= _RESERVED)
        if not name.strip() or not name.isprintable() or reserved:
            self.refuse(owner, f"{attribute} {shown(name)} of <{owner.tag}>; wanted one line of "
                               "text, and no reserved word")
        return name

    def flag(self, owner: Element, tag: str, default: str = "false") -> bool:
        """Returns whether a text is true."""
        return self.as_flag(owner, tag, self.text(owner, tag, default))

    def as_flag(self, owner: Element, what: str, text: str) -> bool:
        """Returns whether a text is true, or 1."""
        if text not in ("true", "false", "1", "0"):
            self.refuse(owner, f"{what} {shown(text)} of <{owner.tag}>; wanted true or false")
        return text in ("true", "1")

    def numbers(self, owner: Element, tag: str, count: int, default: str | None = None
                ) -> tuple[Fraction, ...]:
        """The numbers in the child with this tag."""
        return self.as_numbers(owner, tag, self.text(owner, tag, default), count)

    def as_numbers(self, owner: Element, what: str, text: str, count: int
                   ) -> tuple[Fraction, ...]:
        """A text as so many numbers."""
        words = text.split()
        if len(words) != count:
            self.refuse(owner, f"<{what}> of <{owner.tag}> is {shown(text)}; wanted {count} "
                               f"number{'s' * (count > 1)}")
        try:
            return tuple(map(decimal, words))
        except ValueError as error:
            self.refuse(owner, f"<{what}> of <{owner.tag}>: {error}")

    def number(self, owner: Element, tag: str, default: str | None = None,
               nonnegative: bool = False) -> Fraction:
        """The number in the child with this tag."""
        number, = self.numbers(owner, tag, 1, default)
        if nonnegative and number < 0:
            self.refuse(owner, f"<{tag}> of <{owner.tag}> is {float(number):g}; wanted 0 or more")
        return number

    def unused(self, owner: Element, of: str) -> Iterator[Notice]:
        """Notices of the numbers below an element that nothing uses."""
        for child in owner.children:
            if child.tag != "physics":
                yield from self.unused(child, of)
            if child.tag in TOLD and self.number(owner, child.tag):
                yield Notice("other tools' numbers", of, f"{of}: <{child.tag}> in line "
                             f"{child.line} is used by no effect")

    def refuse_include(self, include: Element) -> NoReturn:
        """Refuse a reference to another file."""
        self.refuse(include, "<include>: the model is in another file; wanted it in this one, as "
                             "`gz sdf -p FILE` writes it")

    def refuse(self, at: Element | Text, problem: str) -> NoReturn:
        """Raise SceneError that names the file and the line."""
        name = f", {at.tag} {at.attributes['name']!r}" if isinstance(at, Element) and \
            at.attributes.get("name") else ""
        raise SceneError(self.path, f"line {at.line}{name}", problem)
