"""Normals of meshes, for viewers that light a surface by those of its vertices."""

import numpy as np

_CREASE = np.cos(np.radians(32))  # as in the page: faces that turn more meet at an edge


def creased(vertices: np.ndarray, faces: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Returns vertices, faces and unit normals of the same surface, whose vertices are repeated
    where faces meet at an edge.  A normal is the mean of the faces about its vertex that turn by at
    most 32° from one of them, weighted by area.  (n, 3), (m, 3) -> (k, 3), (m, 3), (k, 3)."""
    first, second, third = np.asarray(vertices, float)[faces.T]
    normals = np.cross(second - first, third - first)  # twice the area long
    units = _normalized(normals)
    corners = faces.ravel()
    order = np.argsort(corners, kind="stable")  # all corners at a vertex stand together
    of_face = order // 3
    counts = np.bincount(corners, minlength=len(vertices))
    starts = np.cumsum(counts) - counts
    beside = counts[corners[order]]  # of each corner: as many as meet at its vertex
    one = np.repeat(np.arange(len(order)), beside)
    other = (np.arange(len(one)) - np.repeat(np.cumsum(beside) - beside, beside)
             + np.repeat(starts[corners[order]], beside))
    near = np.einsum("ij,ij->i", units[of_face[one]], units[of_face[other]]) >= _CREASE
    sums = np.array([np.bincount(one[near], normals[of_face[other[near]], axis], len(order))
                     for axis in range(3)]).T
    smooth = np.empty((len(order), 3), np.float32)
    smooth[order] = _normalized(sums)
    _, kept, numbers = np.unique(np.column_stack([corners, np.round(smooth, 3)]), axis=0,
                                 return_index=True, return_inverse=True)
    return np.asarray(vertices)[corners[kept]], numbers.reshape(-1, 3), smooth[kept]


def _normalized(vectors: np.ndarray) -> np.ndarray:
    """Vectors of length 1; zeros stay."""
    lengths = np.linalg.norm(vectors, axis=-1, keepdims=True)
    return np.asarray(vectors / np.where(lengths > 0, lengths, 1.0))
