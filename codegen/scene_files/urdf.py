"""URDF files as models: links, joints, inertias, limits, dynamics, mimics.

Elements without influence on the dynamics (visual, collision, transmission, those of simulators)
are not read.  Lengths in m, masses in kg, angles in rad.
"""

from collections.abc import Callable
from dataclasses import replace
from difflib import get_close_matches
from fractions import Fraction
from pathlib import Path
from typing import NoReturn, TypeVar

from coscrew_codegen.scene import rotations
from coscrew_codegen.scene.assembly import ModelError, assembled
from coscrew_codegen.scene.mimics import without_chains
from coscrew_codegen.scene.model import (
    HERE,
    Body,
    Inertia,
    Joint,
    Kind,
    Limits,
    Mimic,
    Model,
    Placement,
)
from coscrew_codegen.scene.names import or_mean
from coscrew_codegen.scene.possible import ERROR, WARN, judged
from coscrew_codegen.scene.residues import without_residues
from coscrew_codegen.scene_files.decimals import decimal
from coscrew_codegen.scene_files.errors import SceneError, shown
from coscrew_codegen.scene_files.xml import Element, read_xml

TYPES = {"revolute": Kind.REVOLUTE, "continuous": Kind.REVOLUTE, "prismatic": Kind.PRISMATIC,
         "fixed": Kind.FIXED, "floating": Kind.FREE, "spherical": Kind.SPHERICAL}

_IGNORED = frozenset({"visual", "collision", "gazebo", "transmission", "material"})
_PARTS = {"link": ("inertial",), "inertial": ("origin", "mass", "inertia"),
          "joint": ("origin", "parent", "child", "axis", "limit", "dynamics", "mimic",
                    "calibration", "safety_controller")}
_MOMENTS = ("ixx", "iyy", "izz", "ixy", "ixz", "iyz")

_T = TypeVar("_T")


def read_urdf(path: Path | str, base: Kind = Kind.FIXED, implausible: str = ERROR) -> Model:
    """The model in a URDF file, its root joined to the world by a joint of the kind `base`.

    With `implausible` "warn", inertias that are impossible, massless or incomplete are accepted and
    listed in the model's `implausible`.  Raises SceneError, naming file, line and element, for
    files that are not URDF, numbers that are not finite, impossible inertias, unknown names and
    joints that do not form a tree."""
    return _Urdf(Path(path), implausible).model(base)


_NO_LIMITS: Limits = (None,) * 4


class _Urdf:
    """Reads one file."""

    def __init__(self, path: Path, implausible: str) -> None:
        self.path, self.implausible = path, implausible
        self.lacking: list[str] = []  # incomplete inertias that were accepted
        self.root = read_xml(path, _IGNORED)

    def model(self, base: Kind) -> Model:
        if self.root.tag != "robot":
            self._refuse(self.root, "", f"the root is <{self.root.tag[:60]}>; wanted <robot>")
        for child in self.root.children:
            if child.tag.startswith("xacro:"):
                self._refuse(child, "", f"<{child.tag[:60]}>: expand the file with xacro first")
        links, joints = self.root.all("link"), self.root.all("joint")
        lines = {f"body {e.attributes.get('name')!r}": e for e in reversed(links)}
        lines |= {f"joint {e.attributes.get('name')!r}": e for e in reversed(joints)}
        try:
            model = without_residues(without_chains(assembled(
                self.root.attributes.get("name", self.path.stem), tuple(map(self._body, links)),
                tuple(map(self._joint, joints)), base)))
            return judged(replace(model, implausible=tuple(self.lacking)), self.implausible)
        except ModelError as error:
            self._refuse(lines.get(error.element, self.root), error.element, error.problem)

    def _body(self, link: Element) -> Body:
        name = self._name(link)
        element = f"body {name!r}"
        self._refuse_misspelt(link, element)
        inertial = self._only(link, "inertial", element)
        return Body(name, self._inertia(inertial, element) if inertial else None)

    def _inertia(self, inertial: Element, body: str) -> Inertia | None:
        """The inertia; None if mass and moments are zero, as in links that are only frames."""
        self._refuse_misspelt(inertial, body)
        placement = self._placement(inertial, body)
        mass = self._mass(inertial, body)
        moments = self._moments(inertial, body)
        if not mass and not any(moments):
            return None
        return Inertia(mass, placement.t, rotations.rotated(placement.R, moments))

    def _moments(self, inertial: Element, body: str) -> tuple[Fraction, ...]:
        element = self._of_inertial(inertial, "inertia", body, "its moments are taken for zero")
        if element is None:
            return (Fraction(0),) * 6
        return tuple(self._number(element, name, body) for name in _MOMENTS)

    def _mass(self, inertial: Element, body: str) -> Fraction:
        element = self._of_inertial(inertial, "mass", body, "it is taken for zero")
        return Fraction(0) if element is None else self._number(element, "value", body)

    def _of_inertial(self, inertial: Element, tag: str, body: str, taken: str) -> Element | None:
        """The element with this tag; None if it is missing and that is accepted."""
        found = self._only(inertial, tag, body)
        if found is None and self.implausible == ERROR:
            self._refuse(inertial, body,
                         f'<inertial> lacks <{tag}>; implausible = "{WARN}" accepts it')
        if found is None:
            self.lacking.append(f"{body}: <inertial> lacks <{tag}>; {taken}")
        return found

    def _joint(self, joint: Element) -> Joint:
        name = self._name(joint)
        element = f"joint {name!r}"
        self._refuse_misspelt(joint, element)
        kind = self._kind(joint, element)
        continuous = joint.attributes["type"] == "continuous"
        turns_or_slides = kind in (Kind.REVOLUTE, Kind.PRISMATIC)
        limits = self._limits(joint, element, continuous) if turns_or_slides else _NO_LIMITS
        dynamics = self._only(joint, "dynamics", element) if turns_or_slides else None
        mimic = self._only(joint, "mimic", element) if turns_or_slides else None
        return Joint(
            name, kind,
            self._text(self._required(joint, "parent", element), "link", element),
            self._text(self._required(joint, "child", element), "link", element),
            self._placement(joint, element),
            self._axis(joint, element) if turns_or_slides else Joint.axis, *limits,
            damping=self._nonnegative(dynamics, "damping", element) if dynamics else None,
            friction=self._nonnegative(dynamics, "friction", element) if dynamics else None,
            mimic=self._mimic(mimic, element) if mimic else None)

    def _kind(self, joint: Element, element: str) -> Kind:
        word = self._text(joint, "type", element)
        if word not in TYPES:
            wanted = ", ".join(TYPES)
            hint = "" if word == "planar" else or_mean(word, TYPES)
            self._refuse(joint, element, f"type {shown(word)} is not supported; wanted one of "
                                         f"{wanted}{hint}")
        return TYPES[word]

    def _axis(self, joint: Element, element: str) -> tuple[Fraction, ...]:
        axis = self._only(joint, "axis", element)
        if axis is None:
            return Fraction(1), Fraction(0), Fraction(0)  # URDF's default
        vector = self._vector(axis, "xyz", element)
        if not any(vector):
            self._refuse(axis, element, "the axis is zero; wanted a direction")
        return rotations.unit(vector)

    def _limits(self, joint: Element, element: str, continuous: bool) -> Limits:
        """The given ones of lower, upper, effort, velocity.  Continuous joints have no lower and
        upper; if only one of these is given, the other is 0."""
        limit = self._only(joint, "limit", element)
        if limit is None:
            return _NO_LIMITS
        most = (self._nonnegative(limit, "effort", element),
                self._nonnegative(limit, "velocity", element))
        if continuous or not {"lower", "upper"} & set(limit.attributes):
            return None, None, *most
        lower, upper = (self._number(limit, name, element, Fraction(0))
                        for name in ("lower", "upper"))
        if lower > upper:
            self._refuse(limit, element, f"lower limit {float(lower):g} is above the upper one, "
                                         f"{float(upper):g}")
        return lower, upper, *most

    def _mimic(self, mimic: Element, element: str) -> Mimic:
        return Mimic(self._text(mimic, "joint", element),
                     self._number(mimic, "multiplier", element, Fraction(1)),
                     self._number(mimic, "offset", element, Fraction(0)))

    def _placement(self, owner: Element, element: str) -> Placement:
        origin = self._only(owner, "origin", element)
        if origin is None:
            return HERE
        xyz, rpy = (self._vector(origin, name, element, (Fraction(0),) * 3)
                    for name in ("xyz", "rpy"))
        return Placement(rotations.from_rpy(*rpy), xyz)

    def _name(self, owner: Element) -> str:
        name = self._text(owner, "name", f"<{owner.tag}>")
        if not name.isprintable():
            self._refuse(owner, f"<{owner.tag}>", f"name {shown(name)}; wanted one line")
        return name

    def _text(self, owner: Element, attribute: str, element: str) -> str:
        if not owner.attributes.get(attribute, "").strip():
            self._refuse(owner, element, f"<{owner.tag}> lacks its {attribute!r}")
        return owner.attributes[attribute]

    def _number(self, owner: Element, attribute: str, element: str,
                default: Fraction | None = None) -> Fraction:
        if attribute not in owner.attributes and default is not None:
            return default
        return self._read(owner, attribute, element, lambda text: decimal(text.strip()))

    def _nonnegative(self, owner: Element, attribute: str, element: str) -> Fraction | None:
        if attribute not in owner.attributes:
            return None
        number = self._number(owner, attribute, element)
        if number < 0:
            self._refuse(owner, element, f"{attribute} {float(number):g}; wanted 0 or more")
        return number

    def _vector(self, owner: Element, attribute: str, element: str,
                default: tuple[Fraction, ...] | None = None) -> tuple[Fraction, ...]:
        if attribute not in owner.attributes and default is not None:
            return default

        def three(text: str) -> tuple[Fraction, ...]:
            words = text.split()
            if len(words) != 3:
                raise ValueError(f"{shown(text)}; wanted three numbers")
            return tuple(decimal(word) for word in words)

        return self._read(owner, attribute, element, three)

    def _read(self, owner: Element, attribute: str, element: str,
              reader: Callable[[str], _T]) -> _T:
        text = self._text(owner, attribute, element)
        try:
            return reader(text)
        except ValueError as error:
            self._refuse(owner, element, f"{attribute!r} of <{owner.tag}>: {error}")

    def _only(self, owner: Element, tag: str, element: str) -> Element | None:
        """The one child with this tag, if there is one."""
        found = owner.all(tag)
        if len(found) > 1:
            self._refuse(found[1], element, f"<{tag}> occurs twice; wanted it once")
        return found[0] if found else None

    def _required(self, owner: Element, tag: str, element: str) -> Element:
        found = self._only(owner, tag, element)
        if found is None:
            self._refuse(owner, element, f"<{owner.tag}> lacks <{tag}>")
        return found

    def _refuse_misspelt(self, owner: Element, element: str) -> None:
        """Ignore elements of simulators, but refuse likely misspellings."""
        for child in owner.children:
            if child.tag not in _PARTS[owner.tag]:
                tag = child.tag[:60]
                near = get_close_matches(tag.lower(), _PARTS[owner.tag], n=1, cutoff=0.75)
                if near:
                    self._refuse(child, element,
                                 f"unknown element <{tag}>; did you mean <{near[0]}>?")

    def _refuse(self, at: Element, element: str, problem: str) -> NoReturn:
        where = f"line {at.line}, {element}" if element else f"line {at.line}"
        raise SceneError(self.path, where, problem)
