"""Meshes of visuals: read by trimesh, welded, and simplified to a number of triangles in all.

Simplified meshes are cached by the contents of their files.  Without the packages of the extra
`view` only meshes that a reader has read are there, and nothing is simplified."""

import io
import json
import logging
from collections.abc import Sequence
from dataclasses import dataclass
from importlib.metadata import version
from importlib.util import find_spec
from pathlib import Path

import numpy as np

from coscrew_codegen.runtime import cache, sources
from coscrew_codegen.scene.mechanism.visual import Triangles, Visual

PACKAGES = ("trimesh", "fast_simplification", "collada")
"""Modules of the extra `view`, which read and simplify meshes."""
TRIANGLES = 40_000
"""The most triangles in a page, except that no mesh gets fewer than _FEW."""
TOUCHING = 10_000
"""The most in further meshes of collision shapes."""
_FEW = 200
_WELD = 1e-5  # of a mesh's size: vertices closer than this are one
_COLOURED = (".dae", ".obj", ".glb", ".gltf", ".ply")  # files whose own colours count
_SUFFIX = ".meshes.npz"


@dataclass(frozen=True, eq=False)
class Piece:
    """Triangles of one colour; () if they have none of their own."""

    vertices: np.ndarray  # (n, 3), m
    faces: np.ndarray  # (m, 3)
    colour: tuple[float, ...] = ()


Pieces = tuple[Piece, ...]


def installed() -> bool:
    """Returns whether the packages that read and simplify meshes are there."""
    return all(find_spec(x) is not None for x in PACKAGES)


def meshes(visuals: Sequence[Visual], most: int = TRIANGLES) -> list[Pieces | str]:
    """The pieces of each visual's mesh, or why there are none; equal meshes are the same object."""
    distinct = {identity(x): x for x in visuals}
    tools = [version(x) for x in ("trimesh", "fast-simplification")] if installed() else []
    key = cache.key_of(sources.digest_of(__name__), str(most), *distinct, *tools)

    def made() -> bytes:
        return _stored(_simplified([_read(x) for x in distinct.values()], most))

    result = dict(zip(distinct, cache.cached(key, _SUFFIX, made, _restored), strict=True))
    return [result[identity(x)] for x in visuals]


def identity(visual: Visual) -> str:
    """The hash of a mesh's content, and its scale."""
    if isinstance(visual.mesh, Path):
        content = cache.hashed(visual.mesh.read_bytes(), 32) + visual.mesh.suffix
    else:
        assert visual.mesh is not None
        content = cache.hashed(visual.mesh.vertices.tobytes() + visual.mesh.faces.tobytes(), 32)
    return f"{content} {visual.scale}"


def _read(visual: Visual) -> Pieces | str:
    """The mesh in the file, in m, a piece for each of its colours."""
    if isinstance(visual.mesh, Triangles):
        return (_welded(visual.mesh.vertices, visual.mesh.faces, ()),)
    assert visual.mesh is not None
    if not installed():
        return "trimesh is not installed"
    by_colour: dict[tuple[float, ...], list[tuple[np.ndarray, np.ndarray]]] = {}
    try:
        for vertices, faces, colour in _geometries(visual.mesh):
            inside_out = np.prod(visual.scale) < 0
            by_colour.setdefault(colour, []).append((
                vertices * visual.scale, faces[:, ::-1] if inside_out else faces))
    except Exception as error:  # of trimesh, of the parsers that it calls
        return f"trimesh says: {' '.join(str(error).split())[:200] or type(error).__name__}"
    pieces = (_welded(*_joined(parts), colour) for colour, parts in by_colour.items())
    return tuple(x for x in pieces if len(x.faces)) or "has no triangles"


def _geometries(path: Path) -> list[tuple[np.ndarray, np.ndarray, tuple[float, ...]]]:
    """Vertices, faces and colour of each geometry in a file, at its place in the file's graph.

    Lengths in the unit that a Collada file declares; its upward axis does not count, as in the
    programs that these files were drawn for."""
    import trimesh

    logging.getLogger("trimesh").setLevel(logging.CRITICAL)
    scene, results = trimesh.load_scene(path), []
    for node in scene.graph.nodes_geometry:
        transform, name = scene.graph[node]
        mesh = scene.geometry[name]
        if isinstance(mesh, trimesh.Trimesh) and len(mesh.faces):
            at = np.asarray(mesh.vertices, float) @ transform[:3, :3].T + transform[:3, 3]
            faces = np.asarray(mesh.faces, np.int64)
            unit, of_metres, _ = str(mesh.metadata.get("units", "")).partition(" * meters")
            metres = float(unit) if of_metres else 1.0
            mirrored = np.linalg.det(transform[:3, :3]) < 0
            results.append((metres * at, faces[:, ::-1] if mirrored else faces,
                            _colour(mesh) if path.suffix.lower() in _COLOURED else ()))
    return results


def _colour(mesh: "object") -> tuple[float, ...]:
    """The colour of a geometry's material, or the median of its faces'; () if it has none."""
    visual = getattr(mesh, "visual", None)
    material = getattr(visual, "material", None)
    colour = getattr(material, "main_color", None)
    if colour is None and getattr(visual, "kind", None) in ("face", "vertex"):
        colour = np.median(np.asarray(getattr(visual, "face_colors")), 0)  # noqa: B009
    return () if colour is None else tuple(round(float(x) / 255, 4) for x in colour[:4])


def _joined(parts: list[tuple[np.ndarray, np.ndarray]]) -> tuple[np.ndarray, np.ndarray]:
    """Several meshes as one."""
    before = np.cumsum([0, *(len(vertices) for vertices, _ in parts)])
    return (np.concatenate([x for x, _ in parts]),
            np.concatenate([faces + n for (_, faces), n in zip(parts, before, strict=False)]))


def _welded(vertices: np.ndarray, faces: np.ndarray, colour: tuple[float, ...]) -> Piece:
    """The mesh with one vertex in each place, and without faces of no area."""
    low, size = vertices.min(0), float(np.ptp(vertices, 0).max()) or 1.0
    cells = np.round((vertices - low) / (_WELD * size)).astype(np.int64)
    _, first, inverse = np.unique(cells, axis=0, return_index=True, return_inverse=True)
    merged = inverse.reshape(-1)[faces]
    apart = ((merged[:, 0] != merged[:, 1]) & (merged[:, 1] != merged[:, 2])
             & (merged[:, 2] != merged[:, 0]))
    return Piece(vertices[first].astype(np.float32), merged[apart].astype(np.int32), colour)


def _simplified(all_pieces: list[Pieces | str], most: int) -> list[Pieces | str]:
    """The pieces with a share of the triangles, none fewer than _FEW."""
    total = sum(len(x.faces) for pieces in all_pieces if not isinstance(pieces, str)
                for x in pieces)
    if total <= most or not installed():
        return all_pieces
    return [pieces if isinstance(pieces, str) else
            tuple(_fewer(x, int(len(x.faces) * most / total)) for x in pieces)
            for pieces in all_pieces]


def _fewer(piece: Piece, share: int) -> Piece:
    """The piece with about so many triangles; borders stay, or small separate parts would vanish.
    """
    import fast_simplification

    wanted = max(share, _FEW)
    if len(piece.faces) <= wanted:
        return piece
    vertices, faces = fast_simplification.simplify(
        piece.vertices, piece.faces.astype(np.uint32), target_count=wanted, agg=3,
        preserve_border=True)
    return _welded(vertices.astype(float), faces.astype(np.int64), piece.colour) \
        if len(faces) else piece


def _stored(all_pieces: list[Pieces | str]) -> bytes:
    arrays: dict[str, np.ndarray] = {}
    about: list[object] = []
    for i, pieces in enumerate(all_pieces):
        about.append(pieces if isinstance(pieces, str) else [list(x.colour) for x in pieces])
        for k, x in enumerate(() if isinstance(pieces, str) else pieces):
            arrays |= {f"v{i}_{k}": x.vertices, f"f{i}_{k}": x.faces}
    file = io.BytesIO()
    np.savez(file, allow_pickle=False, about=np.array(json.dumps(about)), **arrays)
    return file.getvalue()


def _restored(path: Path) -> list[Pieces | str]:
    with np.load(path, allow_pickle=False) as file:
        return [entry if isinstance(entry, str) else
                tuple(Piece(file[f"v{i}_{k}"], file[f"f{i}_{k}"], tuple(colour))
                      for k, colour in enumerate(entry))
                for i, entry in enumerate(json.loads(str(file["about"])))]
