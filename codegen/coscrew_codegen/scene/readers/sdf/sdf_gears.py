"""Gearboxes of SDF files: joints that make one revolute joint follow another."""

from fractions import Fraction

from coscrew_codegen.scene.mechanism.loop import HINGE
from coscrew_codegen.scene.mechanism.model import WORLD, Mimic
from coscrew_codegen.scene.mechanism.notices import Notice
from coscrew_codegen.scene.mechanism.rotations import turned
from coscrew_codegen.scene.readers.sdf.sdf_joints import AXES, GEARBOX
from coscrew_codegen.scene.readers.sdf.sdf_loops import CLOSURES, SdfLoops
from coscrew_codegen.scene.readers.xml_files.xml import Element

GROUP = "gearboxes"
_PARALLEL = Fraction(1, 10**10)
"""One less the cosine of axes that are parallel."""


def gears(file: SdfLoops, left_out: bool) -> dict[str, Mimic]:
    """The joints that gearboxes make follow others, by name; none if they are left out.  Raises
    SceneError for a gearbox between others than two revolute joints."""
    mimics = dict[str, Mimic]()
    for full, joint, scope in file.every("joint"):
        if joint.attributes.get("type") != GEARBOX:
            continue
        if left_out:
            file.notices.append(Notice("other tools' joints", f"joint {full}", f"joint {full}: "
                                       f"left out ({GROUP})"))
            continue
        follower, mimic = _gear(file, joint, full, scope)
        if follower in mimics or any(file.frames[follower][0].every("mimic")):
            file.refuse(joint, f"joint {follower!r} follows another already; {_wanted('one gear')}")
        mimics[follower] = mimic
    return mimics


def _gear(file: SdfLoops, joint: Element, full: str, scope: str) -> tuple[str, Mimic]:
    """theta_2 = -ratio theta_1, the angles of the joint's parent and child against the reference
    body in the directions of <axis> and <axis2> (SDF's specification of <joint>)."""
    name = file.text(joint, "gearbox_reference_body")
    body = WORLD if file.is_world(scope, name) else file.link_of(
        file.resolved(joint, scope, name))
    ratio = file.number(joint, "gearbox_ratio", "1")
    (leader, one), (follower, other) = (
        _turning(file, joint, full, scope, (body, link, tag))
        for link, tag in zip(file.ends(joint, scope), AXES, strict=True))
    if leader == follower:
        file.refuse(joint, f"joint {leader!r} would follow itself; {_wanted('two joints')}")
    return follower, Mimic(leader, -ratio * one * other, Fraction(0))


def _turning(file: SdfLoops, joint: Element, full: str, scope: str, of: tuple[str, str, str]
             ) -> tuple[str, int]:
    """The revolute joint between two bodies, and the sign of the second one's angle against the
    first in the direction of an axis of the gearbox."""
    body, link, tag = of
    n = turned(file.within(WORLD, full).R, file.direction(joint, tag, scope))
    for name, x, inner in file.every("joint"):
        if CLOSURES.get(x.attributes.get("type", "")) is not HINGE or name in file.closing:
            continue  # revolute joints of the tree, in the world where all coordinates are zero
        ends = file.ends(x, inner)
        axis = turned(file.within(WORLD, name).R, file.direction(x, AXES[0], inner))
        cosine = sum((x * y for x, y in zip(axis, n, strict=True)), Fraction(0))
        if {*ends} == {body, link} and 1 - abs(cosine) < _PARALLEL:
            return name, (1 if cosine > 0 else -1) * (1 if ends[0] == body else -1)
    return file.refuse(joint, f"no revolute joint of the tree about its <{tag}> connects {link!r} "
                              f"with {body!r}; {_wanted('one')}")


def _wanted(what: str) -> str:
    return f'wanted {what}, or leave_out = ["{GROUP}"]'
