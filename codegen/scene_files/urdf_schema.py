"""URDF's elements and attributes, in all its versions, and what is wrong with others.

Elements of other tools are free; so are attributes of other tools that do not change a motion.
Misspelt and misplaced names of URDF are found by their likeness, also where the case differs.
"""

from collections.abc import Iterator, Mapping
from difflib import get_close_matches

from coscrew_codegen.scene.names import did_you_mean
from coscrew_codegen.scene_files.decimals import decimal
from coscrew_codegen.scene_files.errors import shown
from coscrew_codegen.scene_files.xml import Element

VERSIONS = ("1.0", "1.1", "1.2")
QUATERNION = "quat_xyzw"

IGNORED = frozenset({"visual", "collision", "gazebo", "transmission", "material"})
"""Elements without influence on the dynamics, which are not read."""

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

_FREE = {"link": ("type", "concave"), "joint": ("dont_collapse",)}
"""Attributes of other tools that do not change a motion."""

_MUST_BE_ZERO = {"axis": ("rpy",)}
"""Attributes that some programs write although URDF has no such rotation."""

OTHERS: Mapping[str, Mapping[str, str]] = {
    "dynamics": {"spring_stiffness": "spring", "spring_reference": "spring", "stiffness": "spring",
                 "armature": "armature", "rotor_inertia": "armature", "D": "", "K": "",
                 "mu_coulomb": "", "mu_viscous": ""},
    "limit": {"command_effort": "", "current": "", "gear_velocity": "", "twist": ""}}
"""Physical numbers of other tools, in files of well-known robots, by element: the effect that acts
alike.  They are told unless they are zero."""

OTHER_ELEMENTS = {"joint": ("joint_properties",), "inertial": ("density",)}
"""Elements of other tools with physical numbers: a notice unless those are zero."""

OTHER_JOINTS = ("loop_joint",)
"""Elements of other tools that constrain a motion; also those with a prefix, as drake:joint."""

_MEANT = {"quat": QUATERNION, "quaternion": QUATERNION, "wxyz": QUATERNION, "xyzw": QUATERNION,
          "orientation": QUATERNION, "euler": "rpy", "ypr": "rpy", "rotation": "rpy", "pos": "xyz",
          "position": "xyz", "translation": "xyz"}
"""Other words for the attributes of an origin."""

_CLOSE = 0.75  # ratio of difflib from which an element's tag is a misspelling


def of_other_tools(name: str) -> bool:
    """Whether an attribute has another tool's prefix, as "drake:acceleration"."""
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
    owners = [f"<{owner}>" for owner, names in ATTRIBUTES.items() if name.lower() in names]
    if name.lower() not in known and owners:
        return f"it belongs to {' or '.join(owners)}"
    meant = _MEANT.get(name.lower(), "") if tag == "origin" else ""
    if meant:
        return f"did you mean {meant!r}?"
    return did_you_mean(name, known) if known else "wanted none"


def misspelt_elements(owner: Element) -> Iterator[tuple[Element, str]]:
    """Children that are no other tool's elements but URDF's, misspelt or misplaced, and what is
    wrong with each."""
    known = CHILDREN.get(owner.tag, ())
    for child in owner.children:
        if child.tag in known or child.tag in OTHER_ELEMENTS.get(owner.tag, ()):
            continue
        tag = child.tag[:60]
        places = [f"<{place}>" for place, tags in CHILDREN.items() if child.tag in tags]
        near = get_close_matches(tag.lower(), known, n=1, cutoff=_CLOSE)
        if places and not _all_zero(child):
            yield child, f"<{tag}> stands in <{owner.tag}>; wanted it in {' or '.join(places)}"
        elif near and not places:
            yield child, f"unknown element <{tag}>; did you mean <{near[0]}>?"
        elif owner.tag != "robot" and owner.tag != "link" and not places:
            owners = [f"<{place}>" for place, names in ATTRIBUTES.items() if child.tag in names]
            if owners:
                yield child, (f"unknown element <{tag}>; {tag} is an attribute of "
                              f"{' or '.join(owners)}")


def is_zero(text: str) -> bool:
    """Whether a text holds nothing but numbers that are zero."""
    try:
        return not any(decimal(word) for word in text.split())
    except ValueError:
        return False


def _all_zero(element: Element) -> bool:
    return bool(element.attributes) and all(map(is_zero, element.attributes.values()))
