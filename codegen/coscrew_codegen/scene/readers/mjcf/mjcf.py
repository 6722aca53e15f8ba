"""MJCF files as models, by MuJoCo's own compiler: defaults, includes, inertias of shapes are its.

A body with n joints is moved by a chain of n links, n - 1 of them without mass.  Where a joint's
anchor is off the body's origin, a link without mass turns there, and the body is fixed to it.
`ref` is in the joint's place, and a free body's place is only where it starts: q is MuJoCo's qpos,
except for quaternions, whose scalar is last here.
"""

from collections.abc import Iterator, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING

from coscrew_codegen.scene.joints.fixed import JOINT as FIXED
from coscrew_codegen.scene.joints.free import JOINT as FREE
from coscrew_codegen.scene.joints.prismatic import JOINT as PRISMATIC
from coscrew_codegen.scene.joints.revolute import JOINT as REVOLUTE
from coscrew_codegen.scene.joints.spherical import JOINT as SPHERICAL
from coscrew_codegen.scene.mechanism import rotations
from coscrew_codegen.scene.mechanism.model import (
    HERE,
    Body,
    Inertia,
    Joint,
    Placement,
)
from coscrew_codegen.scene.mechanism.notices import Notice
from coscrew_codegen.scene.mechanism.tree import composed
from coscrew_codegen.scene.readers.foreign import of_root, root_of
from coscrew_codegen.scene.readers.mjcf.mjcf_actuators import actuators
from coscrew_codegen.scene.readers.mjcf.mjcf_collisions import collisions
from coscrew_codegen.scene.readers.mjcf.mjcf_effects import effects, followers
from coscrew_codegen.scene.readers.mjcf.mjcf_flags import obey_flags
from coscrew_codegen.scene.readers.mjcf.mjcf_laws import laws
from coscrew_codegen.scene.readers.mjcf.mjcf_leftovers import GROUPS, ignored, refused
from coscrew_codegen.scene.readers.mjcf.mjcf_loops import loops
from coscrew_codegen.scene.readers.mjcf.mjcf_names import MjcfNames, exact
from coscrew_codegen.scene.readers.mjcf.mjcf_tendons import tendons
from coscrew_codegen.scene.readers.mjcf.mjcf_visuals import MjcfVisuals
from coscrew_codegen.scene.readers.model_reader import ModelReader, ModelSource, Parts
from coscrew_codegen.scene.readers.placed_loops import PlacedLoops
from coscrew_codegen.scene.readers.scene_error import SceneError

if TYPE_CHECKING:
    import mujoco

_KINDS = (FREE, SPHERICAL, PRISMATIC, REVOLUTE)  # by MuJoCo's numbers
_NOWHERE = (Fraction(0),) * 3


def _parts(source: ModelSource) -> Parts:
    model, warnings = _warned(source)
    names = MjcfNames(model)
    left_out, drives = tuple(refused(source, model, names)), actuators(model, names)
    seen = MjcfVisuals(model)
    closed = PlacedLoops() if "loops" in source.leave_out else loops(model, names)
    parts = [*(x for number in range(1, model.nbody) for x in _moved(model, names, seen, number)),
             *closed.frames]
    joints = tuple(x for x in parts if isinstance(x, Joint))
    led = () if "loops" in source.leave_out else laws(model, names, joints)
    return Parts(
        source.path.stem, tuple(x for x in parts if isinstance(x, Body)), joints,
        effects=effects(model, names, drives.tables), inputs=drives.inputs,
        offered=tendons(model, names).offered,
        start=_start(model, names),
        notices=(*left_out, *ignored(model, names), *(
            Notice("other tools' numbers", "model", f"MuJoCo warns: {x}") for x in warnings)),
        loops=(*closed.loops, *led), collisions=tuple(collisions(model, names, seen)))


def _warned(source: ModelSource) -> "tuple[mujoco.MjModel, list[str]]":
    """MuJoCo's model, and its warnings, which it would print and write into the current folder."""
    import mujoco

    before, texts = mujoco.get_mju_user_warning(), list[str]()
    mujoco.set_mju_user_warning(texts.append)
    try:
        return _compiled(source), [*dict.fromkeys(texts)]
    finally:
        mujoco.set_mju_user_warning(before)


def _compiled(source: ModelSource) -> "mujoco.MjModel":
    """MuJoCo's model of the file.  Raises SceneError with its message."""
    import mujoco

    root = root_of(source.path)
    if root == "robot":
        raise SceneError(source.path, "", "is a URDF with another suffix; rename it to "
                         f"{source.path.stem}.urdf")
    if root != "mujoco":
        raise SceneError(source.path, "", of_root(root) or f"the root is <{root[:60]}>; wanted "
                         "<mujoco>, or another suffix")
    try:
        model = mujoco.MjModel.from_xml_path(str(source.path))
    except ValueError as error:
        raise SceneError(source.path, "", f"MuJoCo says: {' '.join(str(error).split())[:300]}"
                         ) from None
    obey_flags(model)
    return model


def _moved(model: "mujoco.MjModel", names: MjcfNames, seen: MjcfVisuals, number: int
           ) -> Iterator[Body | Joint]:
    """The body of this number, the joints that move it, and the links between them."""
    name, parent = names.body(number), names.body(int(model.body_parentid[number]))
    yield Body(name, _inertia(model, number), seen.of(number))
    at = _placement(model.body_pos[number], model.body_quat[number])
    first, count = int(model.body_jntadr[number]), int(model.body_jntnum[number])
    for j in range(first, first + count):
        at, anchor = _at_anchor(model, j, at)
        last = j == first + count - 1 and not any(anchor)
        child = name if last else names.new_body(f"{name}/{names.joint(j)}")
        if not last:
            yield Body(child)
        yield _joint(model, names, j, parent, child, at)
        parent, at = child, Placement(HERE.R, tuple(-x for x in anchor))
    if parent != name:
        yield Joint(names.new_joint(f"{name}/fixed"), FIXED, parent, name, at)


def _at_anchor(model: "mujoco.MjModel", j: int, at: Placement
               ) -> tuple[Placement, tuple[Fraction, ...]]:
    """The place of a joint whose q is 0, in its parent, and its anchor in the body."""
    kind, axis = _KINDS[model.jnt_type[j]], exact(model.jnt_axis[j])
    ref, = exact([model.qpos0[model.jnt_qposadr[j]]])
    if kind is FREE:
        return HERE, _NOWHERE
    if kind is PRISMATIC:
        return composed(at, Placement(HERE.R, tuple(-ref * x for x in axis))), _NOWHERE
    anchor = exact(model.jnt_pos[j])
    turn = rotations.from_axis_angle(axis, -ref) if kind is REVOLUTE and ref else HERE.R
    return composed(at, Placement(turn, anchor)), anchor


def _joint(model: "mujoco.MjModel", names: MjcfNames, j: int, parent: str, child: str, at: Placement
           ) -> Joint:
    kind, name, dof = _KINDS[model.jnt_type[j]], names.joint(j), int(model.jnt_dofadr[j])
    damping, friction = exact([model.dof_damping[dof], model.dof_frictionloss[dof]])
    lower, upper = exact(model.jnt_range[j]) if model.jnt_limited[j] else (None, None)
    if kind in (FREE, SPHERICAL):
        return Joint(name, kind, parent, child, at, upper=upper, damping=damping or None,
                     friction=friction or None)
    least, most = exact(model.jnt_actfrcrange[j]) if model.jnt_actfrclimited[j] else (None, None)
    return Joint(name, kind, parent, child, at, rotations.unit(exact(model.jnt_axis[j])),
                 lower, upper, most if most and least == -most else None,
                 damping=damping or None, friction=friction or None,
                 mimic=followers(model, names).get(name))


def _inertia(model: "mujoco.MjModel", number: int) -> Inertia | None:
    """The inertia; None of a body with neither mass nor moments."""
    mass, = exact([model.body_mass[number]])
    if not mass and not model.body_inertia[number].any():
        return None
    turn = _placement(model.body_ipos[number], model.body_iquat[number])
    moments = (*exact(model.body_inertia[number]), *_NOWHERE)
    return Inertia(mass, turn.t, rotations.rotated(turn.R, moments))


def _placement(xyz: Sequence[float], wxyz: Sequence[float]) -> Placement:
    w, x, y, z = exact(wxyz)
    return Placement(rotations.from_quaternion((x, y, z, w)), exact(xyz))


def _start(model: "mujoco.MjModel", names: MjcfNames) -> dict[str, tuple[float, ...]]:
    """qpos0, as coordinates by joint: of those that are not zero and follow no other."""
    start, led = {}, followers(model, names)
    for j in (j for j in range(model.njnt) if names.joint(j) not in led):
        kind, at = _KINDS[model.jnt_type[j]], int(model.jnt_qposadr[j])
        q = tuple(float(x) for x in model.qpos0[at:at + kind.nq])
        if kind is FREE:
            start[names.joint(j)] = (*q[:3], *q[4:], q[3])
        elif kind is not SPHERICAL and any(q):
            start[names.joint(j)] = q
    return start


READER = ModelReader(
    "MJCF", (".xml", ".mjcf"), "a model of MuJoCo, by its compiler: bodies, joints with damping, "
    "armature, springs, friction and limits, fixed tendons, actuators, joints that follow others, "
    "closed loops, gravity and its compensation, shapes for [effects.contact]", _parts,
    modules=("mujoco",), extra="mjcf", leaves_out=tuple(GROUPS))
