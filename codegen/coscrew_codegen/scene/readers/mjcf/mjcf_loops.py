"""Closed loops of an MJCF: its equalities `connect` and `weld`, which are exact here and soft in
MuJoCo."""

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from coscrew_codegen.scene.mechanism import rotations
from coscrew_codegen.scene.mechanism.loop import FRAME, POINT, ClosedLoop, LoopEnd
from coscrew_codegen.scene.readers.mjcf.mjcf_names import MjcfNames, exact

if TYPE_CHECKING:
    import mujoco


def closes(model: "mujoco.MjModel", e: int) -> bool:
    """Returns whether an active equality closes a loop of bodies."""
    import mujoco

    kinds = (int(mujoco.mjtEq.mjEQ_CONNECT), int(mujoco.mjtEq.mjEQ_WELD))
    return int(model.eq_type[e]) in kinds and bool(model.eq_active0[e])


def loops(model: "mujoco.MjModel", names: MjcfNames) -> Iterator[ClosedLoop]:
    """The loops, by the names of their equalities, or equality3."""
    import mujoco

    for e in (e for e in range(model.neq) if closes(model, e)):
        welds = int(model.eq_type[e]) == int(mujoco.mjtEq.mjEQ_WELD)
        of_sites = int(model.eq_objtype[e]) == int(mujoco.mjtObj.mjOBJ_SITE)
        ends = _of_sites(model, names, e) if of_sites else _of_bodies(model, names, e, welds)
        yield ClosedLoop(model.equality(e).name or f"equality{e}", FRAME if welds else POINT, *ends)


def _of_sites(model: "mujoco.MjModel", names: MjcfNames, e: int) -> tuple[LoopEnd, LoopEnd]:
    """The ends at two sites."""
    sites = int(model.eq_obj1id[e]), int(model.eq_obj2id[e])
    first, second = (LoopEnd(names.body(int(model.site_bodyid[s])), exact(model.site_pos[s]),
                             _rotation(model.site_quat[s])) for s in sites)
    return first, second


def _of_bodies(model: "mujoco.MjModel", names: MjcfNames, e: int, welds: bool
               ) -> tuple[LoopEnd, LoopEnd]:
    """The ends at two bodies.  A weld's data are the point in the second body, that in the first,
    and the rotation of the second in the first."""
    data, bodies = model.eq_data[e], [names.body(int(x[e])) for x in (
        model.eq_obj1id, model.eq_obj2id)]
    points = exact(data[:3]), exact(data[3:6])
    if not welds:
        return LoopEnd(bodies[0], points[0]), LoopEnd(bodies[1], points[1])
    return LoopEnd(bodies[0], points[1], _rotation(data[6:10])), LoopEnd(bodies[1], points[0])


def _rotation(wxyz: Sequence[float]) -> rotations.Entries:
    w, x, y, z = exact(wxyz)
    return rotations.from_quaternion((x, y, z, w))
