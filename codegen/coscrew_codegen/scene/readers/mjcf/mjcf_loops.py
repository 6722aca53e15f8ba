"""Closed loops of an MJCF: bodies that an equality connects at a point, or welds."""

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from coscrew_codegen.scene.mechanism.loop import FRAME, POINT, LoopKind
from coscrew_codegen.scene.mechanism.model import HERE, Placement
from coscrew_codegen.scene.mechanism.rotations import from_quaternion
from coscrew_codegen.scene.readers.mjcf.mjcf_names import MjcfNames, exact
from coscrew_codegen.scene.readers.placed_loops import PlacedLoops

if TYPE_CHECKING:
    import mujoco


def closings(model: "mujoco.MjModel") -> Iterator[int]:
    """The equalities that close loops: active ones of two bodies, or sites, that can move against
    each other."""
    for e in range(model.neq):
        if model.eq_active0[e] and _kind(model, e) and len({
                int(model.body_weldid[x]) for x in _bodies(model, e)}) > 1:
            yield e


def idle(model: "mujoco.MjModel", e: int) -> bool:
    """Returns whether an equality holds bodies that cannot move against each other."""
    return _kind(model, e) is not None and e not in closings(model) and bool(model.eq_active0[e])


def loops(model: "mujoco.MjModel", names: MjcfNames) -> PlacedLoops:
    """Returns the loops of a model."""
    result = PlacedLoops()
    for e in closings(model):
        kind, bodies = _kind(model, e), map(names.body, _bodies(model, e))
        assert kind
        result.close(names.equality(e), kind, zip(bodies, _places(model, e), strict=True),
                     new_body=names.new_body, new_joint=names.new_joint)
    return result


def _kind(model: "mujoco.MjModel", e: int) -> LoopKind | None:
    """The kind of closure; None of other equalities.  A weld without torque holds a point."""
    import mujoco

    kind, kinds = int(model.eq_type[e]), mujoco.mjtEq
    if kind == int(kinds.mjEQ_WELD):
        return FRAME if model.eq_data[e][10] else POINT
    return POINT if kind == int(kinds.mjEQ_CONNECT) else None


def _of_sites(model: "mujoco.MjModel", e: int) -> bool:
    import mujoco

    return int(model.eq_objtype[e]) == int(mujoco.mjtObj.mjOBJ_SITE)


def _bodies(model: "mujoco.MjModel", e: int) -> tuple[int, int]:
    """The numbers of both bodies."""
    first, second = int(model.eq_obj1id[e]), int(model.eq_obj2id[e])
    if _of_sites(model, e):
        return int(model.site_bodyid[first]), int(model.site_bodyid[second])
    return first, second


def _places(model: "mujoco.MjModel", e: int) -> tuple[Placement, Placement]:
    """The frames that coincide, each in its body: of a weld the second body has the rotation
    data[6:10] in the first."""
    import mujoco

    data = model.eq_data[e]
    if _of_sites(model, e):
        first, second = (_placement(model.site_pos[x], model.site_quat[x])
                         for x in (model.eq_obj1id[e], model.eq_obj2id[e]))
        return first, second
    if int(model.eq_type[e]) == int(mujoco.mjtEq.mjEQ_WELD):
        return _placement(data[3:6], data[6:10]), Placement(HERE.R, exact(data[:3]))
    return Placement(HERE.R, exact(data[:3])), Placement(HERE.R, exact(data[3:6]))


def _placement(xyz: Sequence[float], wxyz: Sequence[float]) -> Placement:
    w, x, y, z = exact(wxyz)
    return Placement(from_quaternion((x, y, z, w)), exact(xyz))
