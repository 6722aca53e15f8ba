"""Writes a playback as a recording of Rerun (.rrd): bodies with their shapes, poses and signals
over the time t, and a layout that shows them.

Each run has its own bodies below `world`; a ghost is paler, and hidden where the page hides it."""

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import rerun as rr
from rerun import blueprint as layout

from coscrew_codegen.simulation.view.body_shapes import DrawnPart
from coscrew_codegen.simulation.view.mesh_normals import creased
from coscrew_codegen.simulation.view.page_runs import PageRun
from coscrew_codegen.simulation.view.playback import Playback, unique_labels, up_of

_SPACE, _SIGNALS = "world", "signals"
_PALE = 0.35  # opacity of ghosts
_SHARES = (2, 1)  # of the robot and the plots in the width


def write(shown: Playback, path: Path) -> None:
    """Write the recording."""
    name = shown.result.system.scene.name
    stream = rr.RecordingStream(name, recording_id=name, send_properties=False)
    stream.save(path, default_blueprint=_layout(shown))
    stream.log("origin", rr.TextDocument("\n".join(
        f"{what}: {value}" for what, value in shown.result.provenance)), static=True)
    stream.log(_SPACE, _axes(shown), static=True)
    labels = unique_labels(shown)
    for label, run in zip(labels, shown.runs, strict=True):
        _log_run(stream, shown, label, run)
    for group in shown.groups:
        for _, signal, number, values in group.signals:
            curve = f"{signal} ({labels[number]})" if number else signal
            stream.send_columns(_entity(_SIGNALS, group.heading, curve),
                                [_times(shown.runs[number])], rr.Scalars.columns(scalars=values))
    stream.flush()
    stream.disconnect()


def _log_run(stream: rr.RecordingStream, shown: Playback, label: str, run: PageRun) -> None:
    """Log the shapes of all bodies, and the bodies' poses."""
    names = [x.name for x in shown.result.system.scene.model.bodies]
    ghost = run is not shown.runs[0]
    for n, part in enumerate(shown.drawing.parts):
        if part.body >= 0 or not ghost:  # ghosts share the world's shapes
            entity = _entity(_SPACE, label, names[part.body] if part.body >= 0 else _SPACE,
                             f"shape {n}")
            stream.log(entity, *_shape(part, _PALE if ghost else 1.0), static=True)
    for n, name in enumerate(names):
        stream.send_columns(_entity(_SPACE, label, name), [_times(run)], rr.Transform3D.columns(
            translation=run.poses[:, n, :3], quaternion=run.poses[:, n, 3:]))


def _shape(part: DrawnPart, opacity: float) -> Iterator[rr.AsComponents]:
    """The part's place in its body, and its shape."""
    yield rr.Transform3D(translation=part.place[:3], quaternion=part.place[3:])
    colour = [round(255 * x) for x in (*part.colour[:3], opacity * [*part.colour, 1.0][3])]
    solid = {"colors": [colour], "fill_mode": "solid"}
    if part.piece:
        vertices, faces, normals = creased(part.piece.vertices, part.piece.faces)
        yield rr.Mesh3D(vertex_positions=vertices, triangle_indices=faces, vertex_normals=normals,
                        albedo_factor=colour)
    elif part.shape == "box":
        yield rr.Boxes3D(sizes=[part.size], **solid)
    elif part.shape == "cylinder":
        yield rr.Cylinders3D(radii=[part.size[0]], lengths=[part.size[1]], **solid)
    elif part.shape == "capsule":  # from 0 to its length along z
        yield rr.Capsules3D(radii=[part.size[0]], lengths=[part.size[1]],
                            translations=[[0, 0, -0.5 * part.size[1]]], **solid)
    else:
        yield rr.Ellipsoids3D(half_sizes=[np.broadcast_to(part.size, 3)], **solid)


def _axes(shown: Playback) -> rr.AsComponents:
    """The axis of the world that is nearest to the upward direction."""
    up = up_of(shown.result.system)
    axis = int(np.argmax(np.abs(up)))
    named: rr.AsComponents = getattr(
        rr.ViewCoordinates, f"RIGHT_HAND_{'XYZ'[axis]}_{'UP' if up[axis] > 0 else 'DOWN'}")
    return named


def _layout(shown: Playback) -> layout.Blueprint:
    """The robot, beside it a plot for each group of signals."""
    hidden = {_entity(_SPACE, label): layout.EntityBehavior(visible=False)
              for label, run in zip(unique_labels(shown), shown.runs, strict=True) if not run.shown}
    plots = [layout.TimeSeriesView(origin=_entity(_SIGNALS, x.heading), name=x.heading)
             for x in shown.groups]
    robot = layout.Spatial3DView(origin=_SPACE, overrides=hidden)
    return layout.Blueprint(layout.Horizontal(robot, layout.Vertical(*plots),
                                              column_shares=_SHARES))


def _times(run: PageRun) -> rr.TimeColumn:
    return rr.TimeColumn("t", duration=run.t)


def _entity(*names: str) -> str:
    return str(rr.new_entity_path([*names]))
