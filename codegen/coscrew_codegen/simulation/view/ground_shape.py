"""The ground of a picture: the plane or the heights on which a scene's contacts stand."""

from functools import partial

import numpy as np

from coscrew_codegen.program.values.formats import DOUBLE
from coscrew_codegen.program.values.json_values import Json
from coscrew_codegen.program.values.table_arrays import gathered, indices
from coscrew_codegen.scene.formulas import Formula
from coscrew_codegen.simulation.system import System
from coscrew_codegen.simulation.view.contact_shapes import contacts
from coscrew_codegen.simulation.view.page_block import NumberBlock
from coscrew_codegen.simulation.view.part_places import numbers_of, value_of

_POINTS = 96  # of heights, along each edge
_MARGIN = 0.75  # beyond where bodies are, in the extent of their positions
_ARRAYS = {"sin": np.sin, "cos": np.cos, "exp": np.exp, "tanh": np.tanh, "sqrt": np.sqrt,
           "abs": np.abs, "min": np.minimum, "max": np.maximum, "pi": np.pi, "number": float,
           "index": indices, "gather": partial(gathered, DOUBLE)}


def ground_of(system: System, poses: np.ndarray, block: NumberBlock) -> Json:
    """The plane n·x = offset, or heights at points of a square around the bodies; None of a scene
    that has no ground and needs none."""
    given = next((x for x in system.scene.effects if x.effect.name == "ground"), None)
    if given is None and not contacts(system):
        return None
    height = given.values["height"] if given else None
    if isinstance(height, Formula):
        return _heights(height, poses, block)
    normal = numbers_of(system, given.vector("normal")) if given else np.empty(0)
    normal = normal / np.linalg.norm(normal) if normal.size else np.array([0.0, 0, 1])
    return {"normal": normal.tolist(),
            "offset": value_of(system, given, "offset") if given else 0.0}


def _heights(height: Formula, poses: np.ndarray, block: NumberBlock) -> Json:
    """Heights row by row, along y and then x, in single precision."""
    places = poses[..., :3].reshape(-1, 3).astype(float)
    low, high = places.min(0), places.max(0)
    middle, half = (low + high) / 2, (0.5 + _MARGIN) * float((high - low).max()) or 1.0
    x, y = (np.linspace(c - half, c + half, _POINTS) for c in middle[:2])
    with np.errstate(all="ignore"):
        H = height.value(0.0, {**_ARRAYS, "x": lambda: x, "y": lambda: y[:, None]})
    H = np.nan_to_num(np.broadcast_to(np.asarray(H, float), (_POINTS, _POINTS)))
    return {"middle": middle[:2].tolist(), "half": half, "points": _POINTS,
            "heights": block.put(H, "f4")}
