"""URDF's elements and attributes, in all its versions, and the faults of others.

Elements of other tools are free; so are attributes of other tools that do not change a motion.
Misspelt and misplaced names of URDF are recognized by their likeness, also where the case differs.
"""

from collections.abc import Collection, Iterator, Mapping
from difflib import get_close_matches

from coscrew_codegen.scene.names import did_you_mean
from coscrew_codegen.scene.readers.decimals import decimal
from coscrew_codegen.scene.readers.scene_error import shown
from coscrew_codegen.scene.readers.xml_files.xml import Element

VERSIONS = ("1.0", "1.1", "1.2")
QUATERNION = "quat_xyzw"

IGNORED = frozenset({"transmission"})
"""Elements without influence on the dynamics, which are not read."""
SEEN = frozenset({"visual", "material", "collision", "gazebo"})
"""Shapes of links and their colours, and Gazebo's own elements; they are checked where they are
read."""

CHILDREN: Mapping[str, tuple[str, ...]] = {
    "robot": ("link", "joint"), "link": ("inertial",), "inertial": ("origin", "mass", "inertia"),
    "joint": ("origin", "parent", "child", "axis", "limit", "dynamics", "mimic", "calibration",
              "safety_controller")}

MOMENTS = ("ixx", "iyy", "izz", "ixy", "ixz", "iyz")
MIRRORED = {"iyx": "ixy", "izx": "ixz", "izy": "iyz"}
"""Products of inertia once more, as some files write them."""

LATER_LIMITS = ("acceleration", "deceleration", "jerk")
"""Limits of version 1.2, which nothing uses."""

ATTRIBUTES: Mapping[str, tuple[str, ...]] = {
    "robot": ("name", "version"), "link": ("name",), "joint": ("name", "type"), "inertial": (),
    "origin": ("xyz", "rpy", QUATERNION), "mass": ("value",),
    "inertia": (*MOMENTS, *MIRRORED), "parent": ("link",), "child": ("link",), "axis": ("xyz",),
    "limit": ("lower", "upper", "effort", "velocity", *LATER_LIMITS),
    "dynamics": ("damping", "friction"), "mimic": ("joint", "multiplier", "offset"),
    "calibration": ("reference_position", "rising", "falling"),
    "safety_controller": ("soft_lower_limit", "soft_upper_limit", "k_position", "k_velocity")}

_NAMES = frozenset({"name", "version", "type", "link", "joint"})
"""Attributes that are no numbers."""

_FREE = {"link": ("type", "concave"), "joint": ("dont_collapse",)}
"""Attributes of other tools that do not change a motion."""

_MUST_BE_ZERO = {"axis": ("rpy",)}
"""Attributes that some programs write although URDF has no such rotation."""

OTHERS: Mapping[str, Mapping[str, str]] = {
    "dynamics": {"spring_stiffness": "spring.k", "spring_reference": "spring.q0",
                 "stiffness": "spring.k", "armature": "armature.inertia",
                 "rotor_inertia": "armature.rotor", "D": "", "K": "",
                 "mu_coulomb": "", "mu_viscous": ""},
    "limit": {"command_effort": "", "current": "", "gear_velocity": "", "stiffness": "",
              "damping": "", "twist": ""},
    "safety_controller": {"soft_lower": "", "soft_upper": ""}}
"""Physical numbers of other tools, in files of well-known robots, by element: the parameter of an
effect that acts alike.  They are reported unless they are zero."""

OTHER_ELEMENTS = {"joint": ("joint_properties",), "inertial": ("density",)}
"""Elements of other tools with physical numbers: a notice unless those are zero."""

OTHER_JOINTS = ("loop_joint",)
"""Elements of other tools that constrain a motion; also those with a prefix, as drake:joint."""

_MEANT = {"quat": QUATERNION, "quaternion": QUATERNION, "wxyz": QUATERNION, "xyzw": QUATERNION,
          "orientation": QUATERNION, "euler": "rpy", "ypr": "rpy", "rotation": "rpy", "pos": "xyz",
          "position": "xyz", "translation": "xyz"}
"""Other words for the attributes of an origin."""

_FRAMES = frozenset({*_MEANT, "pose", "transform", "transformation", "offset", "com",
                     "center_of_mass", "centre_of_mass"})
"""Other words for an origin, as elements."""

_CLOSE = 0.75  # ratio of difflib from which an element's tag is a misspelling
_CLOSER = 0.85  # and from which it is one of an element that stands elsewhere


def of_other_tools(name: str) -> bool:
    """Returns whether an attribute has another tool's prefix, as "drake:acceleration"."""
    return ":" in name and not _is_free("", name)


def _is_free(tag: str, name: str) -> bool:
    return name in _FREE.get(tag, ()) or name.partition(":")[0] in ("xmlns", "xml")


def misspelt_attribute(element: Element) -> str:
    """The problem of an attribute that URDF does not have; "" if there is none."""
    tag = element.tag
    for name, text in element.attributes.items():
        if name in ATTRIBUTES[tag] or name in OTHERS.get(tag, {}) or ":" in name or \
                _is_free(tag, name):
            continue
        if name in _MUST_BE_ZERO.get(tag, ()) and is_zero(text):
            continue
        return f"unknown attribute {shown(name)} of <{tag}>; {_meant(tag, name)}"
    return ""


def _meant(tag: str, name: str) -> str:
    known = ATTRIBUTES[tag]
    if name.lower() not in known and (owners := _owners(name.lower())):
        return f"it belongs to {owners}"
    meant = _MEANT.get(name.lower(), "") if tag == "origin" else ""
    if meant:
        return f"did you mean {meant!r}?"
    return did_you_mean(name, known) if known else "wanted none"


def numeric(tag: str) -> Collection[str]:
    """The attributes of an element that are numbers."""
    return {*ATTRIBUTES.get(tag, ()), *OTHERS.get(tag, ())} - _NAMES


def wanted_instead(tag: str) -> str:
    """Says where the content of an element stands, instead of a text in it."""
    if names := ATTRIBUTES[tag] if tag not in CHILDREN else ():
        return f"wanted it in {'one of its attributes' if len(names) > 1 else 'its attribute'}, " \
               f"{', '.join(names)}"
    return f"wanted elements: {', '.join(f'<{child}>' for child in CHILDREN[tag])}"


def misspelt_elements(owner: Element) -> Iterator[tuple[Element, str]]:
    """Children that are URDF's elements, misspelt or misplaced, with the fault of each; other
    tools' elements are not among them."""
    known = (*CHILDREN.get(owner.tag, ()), *OTHER_ELEMENTS.get(owner.tag, ()), *SEEN)
    for child in owner.children:
        if child.tag not in known and (problem := _wrong_element(owner.tag, child)):
            yield child, problem


def _wrong_element(owner: str, child: Element) -> str:
    """The problem of an element that does not belong here; "" if it is another tool's."""
    tag = child.tag[:60]
    word = tag.lower()
    if word == "robot":
        return f"<{tag}> stands in <{owner}>; wanted one <robot>, around all"
    if _places(tag):
        return "" if _all_zero(child) else \
            f"<{tag}> stands in <{owner}>; wanted it in {' or '.join(_places(tag))}"
    here = CHILDREN.get(owner, ())
    everywhere = dict.fromkeys(name for names in CHILDREN.values() for name in names)
    for meant in (get_close_matches(word, everywhere, n=1, cutoff=_CLOSER)
                  or get_close_matches(word, here, n=1, cutoff=_CLOSE)):
        elsewhere = "" if meant in here else f", in {' or '.join(_places(meant))}"
        return f"unknown element <{tag}>; did you mean <{meant}>{elsewhere}?"
    return _of_frame(tag, child) if owner in ("joint", "inertial") else ""


def _of_frame(tag: str, child: Element) -> str:
    """The problem of an element of a joint or an inertial with the content of an attribute of URDF.
    """
    if tag.lower() in _FRAMES:
        return (f"unknown element <{tag}>; did you mean <origin>, with "
                f"{', '.join(ATTRIBUTES['origin'])}?")
    if owners := _owners(tag.lower()):
        return f"unknown element <{tag}>; {tag.lower()} is an attribute of {owners}"
    for name in () if ":" in tag else ATTRIBUTES["origin"]:
        if name in child.attributes:
            return f"unknown element <{tag}> with {name!r}; it belongs to {_owners(name)}"
    return ""


def _owners(attribute: str) -> str:
    """The elements with this attribute: "<origin> or <axis>"."""
    return " or ".join(f"<{tag}>" for tag, names in ATTRIBUTES.items() if attribute in names)


def _places(tag: str) -> list[str]:
    """The elements in which URDF has this one."""
    return [f"<{place}>" for place, tags in CHILDREN.items() if tag in tags]


def is_zero(text: str) -> bool:
    """Returns whether a text holds nothing but numbers that are zero."""
    try:
        return not any(decimal(word) for word in text.split())
    except ValueError:
        return False


def has_number(text: str) -> bool:
    """Returns whether one of a text's words is a number."""
    for word in text.split():
        try:
            decimal(word.strip(",;"))
        except ValueError:
            continue
        return True
    return False


def _all_zero(element: Element) -> bool:
    return bool(element.attributes) and all(map(is_zero, element.attributes.values()))
