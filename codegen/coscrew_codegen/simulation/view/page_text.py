"""Writes the page that plays runs back in 3D: self-contained HTML, without network access.

    playback: runs, drawing, signals ──▶ data (JSON and a block of numbers) ──▶ page with its player

`web/` holds the sources of the player; what the templates hold of it is built from them."""

from collections.abc import Iterator, Sequence, Set
from pathlib import Path

import numpy as np

from coscrew_codegen.backends.render import TEMPLATES, render
from coscrew_codegen.program.values.json_values import Json
from coscrew_codegen.scene.mechanism.model import WORLD
from coscrew_codegen.simulation.recordings.result import Result
from coscrew_codegen.simulation.system import System
from coscrew_codegen.simulation.view import page_signals
from coscrew_codegen.simulation.view.body_shapes import DrawnPart, RobotDrawing
from coscrew_codegen.simulation.view.ground_shape import ground_of
from coscrew_codegen.simulation.view.mesh_files import Piece
from coscrew_codegen.simulation.view.page_block import NumberBlock, compressed, embedded
from coscrew_codegen.simulation.view.page_runs import PageRun
from coscrew_codegen.simulation.view.part_places import numbers_of
from coscrew_codegen.simulation.view.playback import Playback, playback, up_of

_LEAST_SHOWN = 3.0  # s: least duration of a playback at the initial speed
_SPEEDS = ((0.1, "0.1×"), (0.25, "0.25×"), (0.5, "0.5×"), (1, "1×"), (2, "2×"), (5, "5×"))
_WIDE = 2**16 - 1  # largest number of a vertex's coordinate in the box of its mesh
_PLAYER = TEMPLATES / "view/player.min.js"
_LICENSES = TEMPLATES / "view/LICENSES.txt"


def page(results: Sequence[Result], besides: Sequence[PageRun] = ()) -> str:
    """The text of the page of the first result, with the others and runs `besides` as ghosts."""
    return text_of(playback(results, besides))


def write(shown: Playback, path: Path) -> None:
    """Write the page."""
    path.write_text(text_of(shown), encoding="utf-8", newline="\n")


def text_of(shown: Playback) -> str:
    """The text of the page."""
    first, drawing, block = shown.result, shown.drawing, NumberBlock()
    runs, bodies = shown.runs, {x.body for x in drawing.parts}
    data = {"runs": [_packed(x, block) for x in runs], **_model(first.system, bodies),
            **_parts(drawing, block), "groups": page_signals.packed(shown.groups, block),
            "arrows": [*page_signals.arrows(first.system, runs[0].columns)],
            "contacts": _contacts(runs[0].contacts, block),
            "ties": [*page_signals.ties(first.system)],
            "ground": ground_of(first.system, runs[0].poses, block)}
    end = runs[0].t[-1]
    rest = "" if end == first.trajectory.t[-1] else (
        f"The playback ends at t = {end:.6g} s: the rest is too large to be shown.")
    speed = max((x for x, _ in _SPEEDS if x <= 1 and x * _LEAST_SHOWN <= end),
                default=_SPEEDS[0][0])
    return render(
        "view/page.html", data=embedded(data), name=first.system.scene.name,
        sentence=_sentence(first),
        bodies=[x.name for x in first.system.scene.model.bodies], rest=rest,
        stopped=first.trajectory.stopped, speed=speed, speeds=_SPEEDS,
        notes=[*([shown.lacks] if shown.lacks else []), *drawing.notes], source=first.provenance,
        block=block.text, player=compressed(_PLAYER.read_bytes()),
        licenses=_LICENSES.read_text(encoding="utf-8"))


def _sentence(result: Result) -> str:
    """The run in one line: "7 joints, 17.5 kg, 4 s, leapfrog, double precision"."""
    model, end = result.system.scene.model, result.trajectory.t[-1]
    moving = sum(joint.kind.moves for joint in model.joints)
    mass = sum(float(numbers_of(result.system, (x.inertia.mass,))[0])
               for x in model.bodies if x.inertia)
    return (f"{moving} joint{'s' * (moving != 1)}, {mass:.4g} kg, {end:g} s, "
            f"{result.plan.integrator}, {result.system.precision.name} precision")


def _packed(run: PageRun, block: NumberBlock) -> Json:
    return {"label": run.label, "shown": run.shown, "t": block.put(run.t, "f8"),
            "poses": block.put(run.poses.transpose(1, 2, 0), "f4")}


def _contacts(points_and_forces: np.ndarray, block: NumberBlock) -> Json:
    """Places of the arrays of each contact that ever touches: x, y, z, and the force's
    components."""
    touching = points_and_forces[..., 3:].any((0, 2))
    return [[block.put(x, "f4") for x in one.T]
            for one in points_and_forces[:, touching].transpose(1, 0, 2)]


def _model(system: System, shown: Set[int]) -> dict[str, Json]:
    """Bodies, joints, labels of the bodies that are shown, and the upward direction."""
    model = system.scene.model
    numbers = {WORLD: -1, **{body.name: n for n, body in enumerate(model.bodies)}}
    bodies: list[Json] = []
    for body in model.bodies:
        inertia = body.inertia
        bodies.append({
            "name": body.name, "mass": float(numbers_of(system, (inertia.mass,))[0])
            if inertia else 0.0,
            "com": numbers_of(system, inertia.com).tolist() if inertia else [0.0] * 3})
    joints: list[Json] = [
        {"name": x.name, "kind": x.kind.name, "moves": x.kind.moves,
         "slides": any(not part.turns for part in x.kind.parts), "parent": numbers[x.parent],
         "child": numbers[x.child],
         "axis": [*map(float, x.axis)] if len(x.axes) == 1 else None}
        for x in model.joints]
    labels = [{"name": x.name, "body": n, "at": numbers_of(system, x.inertia.com).tolist()}
              for n, x in enumerate(model.bodies) if x.inertia and n in shown]
    return {"bodies": bodies, "joints": joints, "labels": labels, "up": up_of(system),
            "tracked": _tracked(system, numbers)}


def _tracked(system: System, numbers: dict[str, int]) -> int:
    """The body that leaves a trail: the last whose position is recorded, or else the one with the
    most joints between it and the world."""
    for text in reversed(system.scene.record):
        quantity, _, rest = text.partition(".")
        if quantity == "position" and rest in numbers:
            return numbers[rest]
    depth = {WORLD: 0}
    for joint in system.scene.model.joints:
        depth[joint.child] = depth[joint.parent] + joint.kind.moves
    return numbers[max(depth, key=lambda name: (depth[name], numbers[name]))]


def _parts(drawing: RobotDrawing, block: NumberBlock) -> dict[str, Json]:
    """The parts, those of collisions and of inertia, and the meshes that they name by number."""
    pieces: list[Piece] = []
    for part in (*drawing.parts, *drawing.touching):
        if part.piece and not any(x is part.piece for x in pieces):
            pieces.append(part.piece)
    numbers = {id(x): n for n, x in enumerate(pieces)}
    return {"meshes": [_mesh(x, block) for x in pieces],
            "parts": [*_entries(drawing.parts, numbers)],
            "collisions": [*_entries(drawing.touching, numbers)],
            "inertias": [*_entries(drawing.inertias, numbers)]}


def _entries(parts: Sequence[DrawnPart], numbers: dict[int, int]) -> Iterator[Json]:
    for x in parts:
        mesh = {"mesh": numbers[id(x.piece)]} if x.piece else {}
        yield {"body": x.body, "kind": x.shape, "size": list(x.size),
               "place": [round(y, 7) for y in x.place],
               "colour": [*x.colour, 1.0][:4], **mesh}


def _mesh(piece: Piece, block: NumberBlock) -> Json:
    """Vertices as 16-bit numbers in the mesh's box, in the order of their first use; both they and
    the faces' indices as differences, which are small."""
    low, high = piece.vertices.min(0).astype(float), piece.vertices.max(0).astype(float)
    step = np.where(high > low, (high - low) / _WIDE, 1.0)
    flat = piece.faces.ravel()
    used, first = np.unique(flat, return_index=True)
    order = used[np.argsort(first)]
    rank = np.zeros(len(piece.vertices), np.int64)
    rank[order] = np.arange(len(order))
    whole = np.round((piece.vertices[order] - low) / step).astype(np.int64)
    steps = np.diff(rank[flat], prepend=0)
    kind = "i2" if len(order) <= 2**15 else "i4"
    return {"low": low.tolist(), "step": step.tolist(),
            "vertices": block.put(np.diff(whole, axis=0, prepend=0).T % 2**16, "u2"),
            "faces": block.put(steps, kind)}
