"""Reads the texts and numbers of URDF's elements, or refuses them by file, line and element."""

from collections.abc import Callable, Iterator
from fractions import Fraction
from pathlib import Path
from typing import NoReturn, TypeVar

from coscrew_codegen.scene.mechanism import rotations
from coscrew_codegen.scene.mechanism.model import HERE, Placement
from coscrew_codegen.scene.mechanism.notices import Notice
from coscrew_codegen.scene.names import toml_key
from coscrew_codegen.scene.readers.decimals import decimal, numbers_in
from coscrew_codegen.scene.readers.foreign import of_root, srdf, xacro
from coscrew_codegen.scene.readers.scene_error import SceneError, shown
from coscrew_codegen.scene.readers.urdf.urdf_schema import (
    CHILDREN,
    IGNORED,
    OTHER_ELEMENTS,
    OTHER_JOINTS,
    OTHERS,
    QUATERNION,
    VERSIONS,
    has_number,
    is_zero,
    misspelt_attribute,
    misspelt_elements,
    numeric,
    of_other_tools,
    wanted_instead,
)
from coscrew_codegen.scene.readers.xml_files.xml import Element, Text, read_xml

_T = TypeVar("_T")


class Elements:
    """The elements of one file.  Collects in `notices` the content that is read and not used."""

    def __init__(self, path: Path, contents: bytes | None = None) -> None:
        self.path = path
        self.notices: list[Notice] = []
        self.root = read_xml(path, IGNORED, contents=contents)
        if self.root.tag != "robot":
            known = of_root(self.root.tag)
            self._refuse(self.root, "", known or f"the root is <{self.root.tag[:60]}>; wanted "
                                                 "<robot>")
        if problem := srdf({child.tag for child in self.root.children}):
            self._refuse(self.root, "", problem)
        self.version = self._version()
        self._check(self.root, "")

    def _version(self) -> str:
        version = self.root.attributes.get("version", VERSIONS[0])
        if version not in VERSIONS:
            self._refuse(self.root, "", f"version {shown(version)} of URDF is unknown; wanted one "
                                        f"of {', '.join(VERSIONS)}")
        return version

    def _check(self, owner: Element, element: str) -> None:
        """Refuse attributes that URDF does not have, here and in the elements below, text, and
        likely misspellings of its elements; note other tools' numbers."""
        if problem := misspelt_attribute(owner):
            self._refuse(owner, element, problem)
        self._refuse_xacro(owner, element)
        for text in owner.texts:
            if owner.tag not in CHILDREN or has_number(text.text):
                self._refuse(text, element, f"<{owner.tag}> holds the text {shown(text.text)}; "
                                            f"{wanted_instead(owner.tag)}")
            self.notices.append(Notice(
                "other tools' numbers", plain(element), f"{plain(element)}: the text "
                f"{shown(text.text)} in line {text.line} is not used"))
        for child, problem in misspelt_elements(owner):
            self._refuse(child, element, problem)
        self.notices += _of_other_tools(owner, element)
        for child in owner.children if owner is not self.root else ():
            if child.tag in CHILDREN.get(owner.tag, ()):
                self._check(child, element)

    def _refuse_xacro(self, owner: Element, element: str) -> None:
        """Refuse elements and expressions of xacro, also where nothing would use the number."""
        remedy = f"run `{xacro(self.path)}` and read that"
        for child in owner.children:
            if child.tag.startswith("xacro:"):
                self._refuse(child, element, f"<{child.tag[:60]}>: this is a file of xacro; "
                                             f"{remedy}")
        for name, text in owner.attributes.items():
            if "${" in text or "$(" in text:
                self._refuse(owner, element, f"{name!r} of <{owner.tag}>, {shown(text)}, is for "
                                             f"xacro; {remedy}")

    def _placement(self, owner: Element, element: str) -> Placement:
        origin = self._only(owner, "origin", element)
        if origin is None:
            return HERE
        zero = (Fraction(0),) * 3
        xyz = self._vector(origin, "xyz", element, zero)
        if QUATERNION in origin.attributes:
            return Placement(self._turned(origin, element), xyz)
        return Placement(rotations.from_rpy(*self._vector(origin, "rpy", element, zero)), xyz)

    def _turned(self, origin: Element, element: str) -> tuple[Fraction, ...]:
        """The rotation of a quaternion of any length but zero, which version 1.1 brought."""
        if self.version == VERSIONS[0]:
            self._refuse(origin, element, f"{QUATERNION!r} of <origin> is of URDF {VERSIONS[1]}; "
                                          f'wanted <robot version="{VERSIONS[1]}">, or rpy')
        if "rpy" in origin.attributes:
            self._refuse(origin, element, f"'rpy' and {QUATERNION!r} of <origin>; wanted one of "
                                          "both")
        quaternion = self._read(origin, QUATERNION, element, lambda text: numbers_in(text, 4))
        if not any(quaternion):
            self._refuse(origin, element, f"{QUATERNION!r} of <origin> is zero; wanted x, y, z, w "
                                          "of a unit quaternion")
        return rotations.from_quaternion(quaternion)

    def _name(self, owner: Element) -> str:
        if "name" not in owner.attributes and (problem := misspelt_attribute(owner)):
            self._refuse(owner, f"<{owner.tag}>", problem)
        name = self._text(owner, "name", f"<{owner.tag}>")
        if not name.isprintable():
            self._refuse(owner, f"<{owner.tag}>", f"name {shown(name)}; wanted one line")
        return name

    def _text(self, owner: Element, attribute: str, element: str) -> str:
        text = owner.attributes.get(attribute, "")
        if not text.strip():
            self._refuse(owner, element, f"<{owner.tag}> lacks its {attribute!r}")
        return text

    def _number(self, owner: Element, attribute: str, element: str,
                default: Fraction | None = None) -> Fraction:
        if attribute not in owner.attributes and default is not None:
            return default
        return self._read(owner, attribute, element, lambda text: decimal(text.strip()))

    def _vector(self, owner: Element, attribute: str, element: str,
                default: tuple[Fraction, ...] | None = None) -> tuple[Fraction, ...]:
        if attribute not in owner.attributes and default is not None:
            return default
        return self._read(owner, attribute, element, lambda text: numbers_in(text, 3))

    def _read(self, owner: Element, attribute: str, element: str,
              reader: Callable[[str], _T]) -> _T:
        text = self._text(owner, attribute, element)
        try:
            return reader(text)
        except ValueError as error:
            self._refuse(owner, element, f"{attribute!r} of <{owner.tag}>: {error}")

    def _only(self, owner: Element, tag: str, element: str) -> Element | None:
        """The one child with this tag, if there is one; it may stand there twice with the same
        content."""
        elements = owner.all(tag)
        if different := self.different(elements):
            self._refuse(different, element, f"<{tag}> occurs twice; wanted it once")
        self.note_repetitions(elements, element)
        return elements[0] if elements else None

    def different(self, elements: tuple[Element, ...]) -> Element | None:
        """The first element that says something else than the first of all."""
        return next((other for other in elements[1:] if not _alike(other, elements[0])), None)

    def note_repetitions(self, elements: tuple[Element, ...], element: str) -> None:
        """Note elements that say the same as the first."""
        of = plain(element)
        self.notices += [Notice("repeated element", of, f"{of}: <{other.tag}> in line "
                                f"{other.line} says the same once more and is not used")
                         for other in elements[1:]]

    def _required(self, owner: Element, tag: str, element: str) -> Element:
        only = self._only(owner, tag, element)
        if only is None:
            self._refuse(owner, element, f"<{owner.tag}> lacks <{tag}>")
        return only

    def _refuse(self, at: Element | Text, element: str, problem: str) -> NoReturn:
        where = f"line {at.line}, {element}" if element else f"line {at.line}"
        raise SceneError(self.path, where, problem)


def plain(element: str) -> str:
    """joint elbow, for joint 'elbow'."""
    what, _, name = element.partition(" ")
    return f"{what} {name[1:-1]}" if name else what


def _alike(a: Element, b: Element) -> bool:
    """Returns whether two elements say the same: numbers of URDF are compared by value, names and
    other tools' attributes as texts."""
    return (a.tag == b.tag and a.attributes.keys() == b.attributes.keys()
            and all(_value(a.tag, name, text) == _value(b.tag, name, b.attributes[name])
                    for name, text in a.attributes.items())
            and len(a.children) == len(b.children)
            and all(map(_alike, a.children, b.children)))


def _value(tag: str, name: str, text: str) -> object:
    if name not in numeric(tag):
        return text
    try:
        return tuple(decimal(word) for word in text.split())
    except ValueError:
        return text


def _of_other_tools(owner: Element, element: str) -> Iterator[Notice]:
    """Notices of other tools' joints, and of their numbers that are not zero."""
    of = plain(element) or "robot"
    for child in owner.children if owner.tag == "robot" else ():
        if child.tag in OTHER_JOINTS or child.tag.endswith(":joint"):
            yield Notice("other tools' joints", of, f"joint {child.attributes.get('name', '')[:60]}"
                         f": <{child.tag[:60]}> is another tool's and is not used")
    for name in owner.attributes:
        if name in OTHERS.get(owner.tag, {}) or of_other_tools(name):
            yield from _number(of, name, owner)
    for child in owner.children:
        for name in child.attributes if child.tag in OTHER_ELEMENTS.get(owner.tag, ()) else ():
            yield from _number(of, name, child)


def _number(of: str, name: str, owner: Element) -> Iterator[Notice]:
    text = owner.attributes[name]
    if is_zero(text):
        return
    effect = OTHERS.get(owner.tag, {}).get(name, "").partition(".")[0]
    remedy = _taking(of.partition(" ")[2], effect, owner) if effect else ""
    yield Notice(effect or "other tools' numbers", of,
                 f"{of}: {name} {shown(text)[1:-1]} of <{owner.tag}> is another tool's and is not "
                 f"used{': ' * bool(remedy)}{remedy}", remedy, (effect, of.partition(" ")[2]))


def _taking(joint: str, effect: str, owner: Element) -> str:
    """The effect with the numbers that this element gives it: "add [effects.spring.elbow] with k =
    30.0"; "" if one is no number."""
    given: dict[str, float] = {}
    for name, text in owner.attributes.items():
        of, _, parameter = OTHERS[owner.tag].get(name, "").partition(".")
        if of == effect:
            try:
                given[parameter] = float(decimal(text.strip()))
            except ValueError:
                return ""
    keys = [f"{name} = {number!r}" for name, number in given.items()]
    if effect == "spring" and "k" not in given:
        keys.append("a stiffness k")
    return f"add [effects.{effect}.{toml_key(joint)}] with {' and '.join(keys)}"
