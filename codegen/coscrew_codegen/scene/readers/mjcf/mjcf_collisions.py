"""Collision shapes of MuJoCo's bodies, and of its world: the geoms that may touch others."""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from coscrew_codegen.scene.mechanism.collision import Collision, Friction, checked, unusable
from coscrew_codegen.scene.mechanism.rotations import from_quaternion
from coscrew_codegen.scene.mechanism.visual import MESH
from coscrew_codegen.scene.readers.mjcf.mjcf_names import MjcfNames, exact
from coscrew_codegen.scene.readers.mjcf.mjcf_visuals import MjcfVisuals, shape_of

if TYPE_CHECKING:
    import mujoco

_BITS = 2**32 - 1


def collisions(model: "mujoco.MjModel", names: MjcfNames, seen: MjcfVisuals) -> Iterator[Collision]:
    """The shapes, in the order of the geoms."""
    for g in touching(model):
        yield _collision(model, names, seen, g)


def touching(model: "mujoco.MjModel") -> list[int]:
    """The geoms that may touch others: by their bits, or in a <pair>."""
    paired = {*map(int, model.pair_geom1), *map(int, model.pair_geom2)}
    return [g for g in range(model.ngeom)
            if model.geom_contype[g] or model.geom_conaffinity[g] or g in paired]


def _collision(model: "mujoco.MjModel", names: MjcfNames, seen: MjcfVisuals, geom: int
               ) -> Collision:
    name, body = model.geom(geom).name, names.body(int(model.geom_bodyid[geom]))
    try:
        shape, size = shape_of(model, geom)
    except ValueError as error:
        return unusable(name, body, str(error))
    w, x, y, z = exact(model.geom_quat[geom])
    sliding, torsional, rolling = exact(model.geom_friction[geom])
    return checked(Collision(
        name, body, shape, size, exact(model.geom_pos[geom]), from_quaternion((x, y, z, w)),
        Friction(sliding, sliding, torsional, rolling),
        seen.mesh(int(model.geom_dataid[geom])) if shape == MESH else None,
        groups=_groups(model, geom)))


def _groups(model: "mujoco.MjModel", geom: int) -> tuple[int, int]:
    """contype and conaffinity, as bits; each <pair> has a further bit of its own."""
    own, others = (int(x[geom]) & _BITS for x in (model.geom_contype, model.geom_conaffinity))
    for i in range(model.npair):
        own |= (model.pair_geom1[i] == geom) * (_BITS + 1) << i
        others |= (model.pair_geom2[i] == geom) * (_BITS + 1) << i
    return own, others
