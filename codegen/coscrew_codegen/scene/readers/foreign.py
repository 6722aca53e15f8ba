"""Files of other kinds: one sentence for each with its kind and a remedy."""

import re
from collections.abc import Set
from pathlib import Path

from coscrew_codegen.scene.readers.contents import read_bytes
from coscrew_codegen.scene.readers.scene_error import shown

_FORMATS = {"mujoco": "MJCF, the format of MuJoCo", "sdf": "SDF, the format of Gazebo",
            "collada": "Collada, a format of meshes", "html": "a web page, not the file it shows",
            "launch": "a launch file of ROS"}
"""By the root element of a file, in lower case."""
_SRDF = "is an SRDF, which belongs to a URDF and has no masses"
_OF_SRDF = frozenset({"group", "group_state", "virtual_joint", "passive_joint", "end_effector",
                      "disable_collisions", "enable_collisions", "disable_default_collisions",
                      "joint_property", "link_sphere_approximation"})
"""Elements that stand directly in the root of an SRDF."""
_AS_TABLES = "a URDF of the robot, or its bodies and joints in tables of a scene"
_SUFFIXES = {".dae": "collada", ".html": "html",
             ".launch": "launch"}
_ROOT = re.compile(rb"<([A-Za-z_][\w:.-]*)")
_BEGINNING = 2**16  # bytes that are searched for a root element


def of_root(tag: str) -> str:
    """Names the kind of a file with this root element, and a remedy; "" if that is unknown."""
    word = tag.lower()
    if word not in _FORMATS:
        return ""
    wanted = {"html": "the raw file", "launch": "the URDF that it loads",
              "sdf": "a name that ends in .sdf", "mujoco": "a name that ends in .xml"}
    return f"is {_FORMATS[word]}; wanted {wanted.get(word, _AS_TABLES)}"


def srdf(tags: Set[str]) -> str:
    """Says that a file with these elements in <robot> is an SRDF, with a remedy; "" if it is none.
    """
    is_one = tags.isdisjoint(("link", "joint")) and not tags.isdisjoint(_OF_SRDF)
    return f"{_SRDF}; wanted that URDF" if is_one else ""


def of_suffix(path: Path) -> str:
    """Names the kind of a file whose suffix no reader has: "is SDF, …"."""
    suffix = path.suffix.lower()
    if suffix == ".srdf":
        return _SRDF
    root = _SUFFIXES.get(suffix, "")
    if root in _FORMATS:
        return f"is {_FORMATS[root]}, which coscrew does not read"
    return f"has the suffix {shown(path.suffix)}" if suffix else "has no suffix"


def xacro(path: Path) -> str:
    """The command that makes a URDF of a xacro file."""
    stem = path.name.removesuffix(".xacro")
    if stem == path.name:  # a file that is called .urdf, with xacro's elements in it
        stem = f"{path.stem}_expanded.urdf"
    return f"xacro {path.name} > {stem if stem.endswith('.urdf') else f'{stem}.urdf'}"


def root_of(path: Path) -> str:
    """The tag of the root element in a file's beginning; "" if there is none.

    Raises SceneError for a file that cannot be read."""
    beginning = read_bytes(path, 2**26)[:_BEGINNING]
    while (start := beginning.find(b"<!--")) >= 0:
        end = beginning.find(b"-->", start)
        beginning = beginning[:start] + (beginning[end + 3:] if end >= 0 else b"")
    match = _ROOT.search(beginning)
    return match[1].decode("ascii", "replace") if match else ""
