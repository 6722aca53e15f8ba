"""Visuals of MuJoCo's bodies: their geoms that touch nothing, or all where every one does."""

from fractions import Fraction
from functools import cache
from typing import TYPE_CHECKING

from coscrew_codegen.scene.mechanism.collision import PLANE
from coscrew_codegen.scene.mechanism.visual import MESH, Triangles, Visual, sized, unseen
from coscrew_codegen.scene.readers.mjcf.mjcf_names import exact

if TYPE_CHECKING:
    import mujoco

_GROUPS = 3  # geoms of later groups are hidden at first in MuJoCo's viewer
_FAINT = 0.05  # opacity below which a geom is not meant to be seen
_DEFAULT = (0.5, 0.5, 0.5, 1.0)  # colour of a geom that gives none, whose material then counts


def shape_of(model: "mujoco.MjModel", geom: int) -> tuple[str, tuple[Fraction, ...]]:
    """The shape of a geom with its sizes.  Raises ValueError for what is none, as heights."""
    import mujoco

    kinds = mujoco.mjtGeom
    a, b, c = exact(model.geom_size[geom])
    shapes = {kinds.mjGEOM_SPHERE: ("sphere", (a,)),
              kinds.mjGEOM_CAPSULE: ("capsule", (a, 2 * b)),
              kinds.mjGEOM_CYLINDER: ("cylinder", (a, 2 * b)),
              kinds.mjGEOM_BOX: ("box", (2 * a, 2 * b, 2 * c)),
              kinds.mjGEOM_ELLIPSOID: ("ellipsoid", (a, b, c)),
              kinds.mjGEOM_PLANE: (PLANE, ()), kinds.mjGEOM_MESH: (MESH, ())}
    kind = kinds(int(model.geom_type[geom]))
    if kind not in shapes:
        raise ValueError(f"a geom of the type {kind.name.removeprefix('mjGEOM_').lower()} is no "
                         "shape that is kept")
    return shapes[kind]


class MjcfVisuals:
    """The visuals of one compiled model."""

    def __init__(self, model: "mujoco.MjModel") -> None:
        self._model = model
        self.mesh = cache(self._triangles)  # which several geoms may show

    def of(self, body: int) -> tuple[Visual, ...]:
        """The visuals of a body, by its number."""
        model, first = self._model, int(self._model.body_geomadr[body])
        geoms = [g for g in range(first, first + int(model.body_geomnum[body]))
                 if model.geom_group[g] < _GROUPS and self._colour(g)[3] > _FAINT]
        quiet = [g for g in geoms if not model.geom_contype[g] and not model.geom_conaffinity[g]]
        return tuple(map(self._visual, quiet or geoms))

    def _visual(self, geom: int) -> Visual:
        model, colour = self._model, self._colour(geom)
        w, x, y, z = (float(q) for q in model.geom_quat[geom])
        place = (*(float(p) for p in model.geom_pos[geom]), x, y, z, w)
        try:
            shape, size = shape_of(model, geom)
        except ValueError as error:
            return unseen(str(error))
        if shape == PLANE:
            return unseen("a plane is not drawn")
        if shape == MESH:
            return Visual(MESH, (), place, colour, self.mesh(int(model.geom_dataid[geom])))
        return sized(shape, [*map(float, size)], place, colour)

    def _colour(self, geom: int) -> tuple[float, ...]:
        model, own = self._model, tuple(float(x) for x in self._model.geom_rgba[geom])
        material = int(model.geom_matid[geom])
        return own if material < 0 or own != _DEFAULT else tuple(
            float(x) for x in model.mat_rgba[material])

    def _triangles(self, mesh: int) -> Triangles:
        model = self._model
        vertex, face = int(model.mesh_vertadr[mesh]), int(model.mesh_faceadr[mesh])
        return Triangles(
            model.mesh_vert[vertex:vertex + int(model.mesh_vertnum[mesh])].astype(float),
            model.mesh_face[face:face + int(model.mesh_facenum[mesh])].astype("int64"))
