"""Joints of URDF files.  Numbers that no joint needs to move, such as limits, are not refused
here: a wrong one is noted as a fault of the joint, and refused where an effect takes it."""

from collections.abc import Iterator
from fractions import Fraction

from coscrew_codegen.scene.joints import KINDS
from coscrew_codegen.scene.mechanism import rotations
from coscrew_codegen.scene.mechanism.joint_kind import JointKind
from coscrew_codegen.scene.mechanism.model import Fault, Joint, Limits, Mimic
from coscrew_codegen.scene.mechanism.notices import Notice
from coscrew_codegen.scene.names import or_mean
from coscrew_codegen.scene.readers.decimals import decimal
from coscrew_codegen.scene.readers.scene_error import shown
from coscrew_codegen.scene.readers.urdf.urdf_elements import Elements, plain
from coscrew_codegen.scene.readers.urdf.urdf_schema import (
    ATTRIBUTES,
    LATER_LIMITS,
    VERSIONS,
    is_zero,
)
from coscrew_codegen.scene.readers.xml_files.xml import Element

TYPES = {word: kind for kind in KINDS if kind.urdf for word in (kind.urdf, *kind.unlimited)}
_NOT_SUPPORTED = {kind.name: kind.without_urdf for kind in KINDS if not kind.urdf}


class Joints(Elements):
    """Reads the joints of one file."""

    def _joint(self, joint: Element) -> Joint:
        name = self._name(joint)
        element = f"joint {name!r}"
        self._check(joint, element)
        kind = self._kind(joint, element)
        faults: list[Fault] = []
        numbers = _Numbers(self, joint, element, faults, kind) \
            if kind.moves else None
        limits = numbers.limits() if numbers and kind.one_coordinate else (None,) * 4
        damping, friction = numbers.dynamics() if numbers else (None, None)
        self.notices += _unused(joint, element, kind)
        return Joint(
            name, kind,
            self._text(self._required(joint, "parent", element), "link", element),
            self._text(self._required(joint, "child", element), "link", element),
            self._placement(joint, element),
            self._axis(joint, element) if kind.axes else Joint.axis, *limits,
            damping=damping, friction=friction,
            mimic=numbers.mimic() if numbers and kind.one_coordinate else None,
            faults=tuple(faults))

    def _kind(self, joint: Element, element: str) -> JointKind:
        word = self._text(joint, "type", element)
        if word not in TYPES:
            wanted = ", ".join(TYPES)
            hint = f"; {_NOT_SUPPORTED[word]}" if word in _NOT_SUPPORTED else or_mean(word, TYPES)
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


class _Numbers:
    """The numbers of a joint with one coordinate, as far as they can be used; `faults` receives
    the others."""

    def __init__(self, file: Elements, joint: Element, element: str, faults: list[Fault],
                 kind: JointKind) -> None:
        self.kind = kind
        self.file, self.joint, self.element, self.faults = file, joint, element, faults

    def limits(self) -> Limits:
        """The given ones of lower, upper, effort, velocity.  Continuous joints have no lower and
        upper.  If only one of these is given, the other is 0; version 1.2 requires both."""
        limit = self._one("limit", ("lower", "upper", "effort", "velocity"))
        if limit is None:
            return (None,) * 4
        most = self._nonnegative(limit, "effort"), self._nonnegative(limit, "velocity")
        given = {"lower", "upper"} & set(limit.attributes)
        if self.joint.attributes["type"] in self.kind.unlimited or not given:
            return None, None, *most
        lower, upper = (self._end(limit, name) for name in ("lower", "upper"))
        if lower is not None and upper is not None and lower > upper:
            for name in ("lower", "upper"):
                self._fault(limit, name, f"lower limit {float(lower):g} is above the upper one, "
                                         f"{float(upper):g}")
            return None, None, *most
        return lower, upper, *most

    def dynamics(self) -> tuple[Fraction | None, Fraction | None]:
        """The given ones of damping and friction."""
        dynamics = self._one("dynamics", ("damping", "friction"))
        if dynamics is None:
            return None, None
        return self._nonnegative(dynamics, "damping"), self._nonnegative(dynamics, "friction")

    def mimic(self) -> Mimic | None:
        """The joint that it follows, if it follows one."""
        mimic = self._one("mimic", ("mimic",))
        if mimic is None:
            return None
        numbers = [self._number(mimic, name, "mimic") if name in mimic.attributes else default
                   for name, default in (("multiplier", Fraction(1)), ("offset", Fraction(0)))]
        leader = mimic.attributes.get("joint", "")
        if not leader.strip():
            self._fault(mimic, "mimic", "<mimic> lacks its 'joint'")
        multiplier, offset = numbers
        if multiplier is None or offset is None or not leader.strip():
            return None
        return Mimic(leader, multiplier, offset)

    def _one(self, tag: str, fields: tuple[str, ...]) -> Element | None:
        """The child with this tag; if two differ, faults of these fields, and None."""
        elements = self.joint.all(tag)
        if different := self.file.different(elements):
            for name in fields:
                self._fault(different, name, f"<{tag}> occurs twice, with different numbers; "
                                             "wanted it once")
            return None
        self.file.note_repetitions(elements, self.element)
        return elements[0] if elements else None

    def _end(self, limit: Element, name: str) -> Fraction | None:
        if name in limit.attributes:
            return self._number(limit, name, name)
        if self.file.version not in VERSIONS[:2]:
            self._fault(limit, name, f"<limit> lacks its {name!r}, which URDF "
                                     f"{self.file.version} requires beside the other end")
            return None
        return Fraction(0)

    def _nonnegative(self, owner: Element, name: str) -> Fraction | None:
        if name not in owner.attributes:
            return None
        number = self._number(owner, name, name)
        if number is not None and number < 0:
            self._fault(owner, name, f"{name} {float(number):g}; wanted 0 or more")
            return None
        return number

    def _number(self, owner: Element, attribute: str, name: str) -> Fraction | None:
        try:
            return decimal(owner.attributes[attribute].strip())
        except ValueError as error:
            self._fault(owner, name, f"{attribute!r} of <{owner.tag}>: {error}")
            return None

    def _fault(self, at: Element, name: str, problem: str) -> None:
        self.faults.append(Fault(name, problem, f"{self.file.path.name}, line {at.line}"))


def _unused(joint: Element, element: str, kind: JointKind) -> Iterator[Notice]:
    """Notices of numbers that no effect can take."""
    if not kind.moves:
        return
    for name in LATER_LIMITS:
        yield from _given(joint, element, "limit", (name,), name)
    yield from _given(joint, element, "safety_controller", ATTRIBUTES["safety_controller"],
                      "safety controller")
    if not kind.one_coordinate:
        yield from _given(joint, element, "limit", ("lower", "upper"), "limits")
        for name in ("effort", "velocity"):
            yield from _given(joint, element, "limit", (name,), name)
        yield from _given(joint, element, "mimic", ("joint",), "mimic")
    elif joint.attributes["type"] in kind.unlimited:
        yield from _given(joint, element, "limit", ("lower", "upper"), "limits")


def _given(joint: Element, element: str, tag: str, names: tuple[str, ...], subject: str
           ) -> Iterator[Notice]:
    """Notices of these attributes, if they are given and not zero."""
    of, type_ = plain(element), joint.attributes["type"]
    for child in joint.all(tag)[:1]:
        for name in names:
            text = child.attributes.get(name, "")
            if not is_zero(text):
                yield Notice(subject, of, f"{of}: {name} {shown(text)[1:-1]} of <{tag}> is used by "
                                          f"no effect of a {type_} joint")
