"""Writes a playback as MCAP (.mcap) for Foxglove: a scene of shapes, frames of the bodies, and a
topic for each quantity.

The first run's frames have the names of bodies, those of ghosts LABEL/BODY; all are in `world`."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import foxglove
import numpy as np
from foxglove import messages
from foxglove.channels import FrameTransformsChannel, SceneUpdateChannel

from coscrew_codegen.program.values.json_values import Json
from coscrew_codegen.simulation.view.body_shapes import DrawnPart
from coscrew_codegen.simulation.view.page_runs import PageRun
from coscrew_codegen.simulation.view.playback import Playback, unique_labels

_SPACE = "world"
_PALE = 0.35  # opacity of ghosts
_SECOND = 10**9  # ns


@dataclass(frozen=True, eq=False)
class TopicField:
    """A signal of a run, as a field of messages of its topic."""

    name: str
    unit: str
    values: np.ndarray


@dataclass(frozen=True, eq=False)
class RunTopics:
    """A run, the prefix of its frames and topics, and the fields of each topic."""

    run: PageRun
    prefix: str
    fields: dict[str, list[TopicField]]


def write(shown: Playback, path: Path) -> None:
    """Write the file; messages stand in the order of time."""
    own = foxglove.Context()
    all_topics = [*_topics(shown)]
    with foxglove.open_mcap(path, allow_overwrite=True, context=own):
        frames = FrameTransformsChannel("/frames", context=own)
        channels = {x: foxglove.Channel(f"/{x}", schema=_schema(fields), context=own)
                    for its in all_topics for x, fields in its.fields.items()}
        times = sorted((_nanoseconds(t), n, k) for n, its in enumerate(all_topics)
                       for k, t in enumerate(its.run.t))
        SceneUpdateChannel("/scene", context=own).log(messages.SceneUpdate(
            entities=[*_entities(shown, all_topics)]), log_time=times[0][0])
        for time, n, k in times:
            its = all_topics[n]
            frames.log(_transforms(shown, its, k, time), log_time=time)
            for topic, fields in its.fields.items():
                channels[topic].log({x.name: float(x.values[k]) for x in fields
                                     if math.isfinite(x.values[k])}, log_time=time)


def _topics(shown: Playback) -> Iterator[RunTopics]:
    """The topics of each run: q.elbow is `elbow` of the topic `q`, pose.hand.3 is `3` of
    `pose/hand`."""
    for number, (run, label) in enumerate(zip(shown.runs, unique_labels(shown), strict=True)):
        prefix, fields = f"{label}/" if number else "", dict[str, list[TopicField]]()
        for group in shown.groups:
            for name, _, of_run, values in group.signals:
                if of_run == number:
                    *topic, last = name.split(".")
                    fields.setdefault(prefix + "/".join(topic), []).append(
                        TopicField(last, group.unit, values))
        yield RunTopics(run, prefix, fields)


def _schema(fields: list[TopicField]) -> dict[str, Json]:
    return {"type": "object", "properties": {
        x.name: {"type": "number", "description": x.unit} for x in fields}}


def _entities(shown: Playback, all_topics: list[RunTopics]) -> Iterator[messages.SceneEntity]:
    """The shapes of each body in each run; those of the world once."""
    names = {-1: _SPACE, **dict(enumerate(x.name for x in shown.result.system.scene.model.bodies))}
    by_body: dict[int, list[DrawnPart]] = {}
    for part in shown.drawing.parts:
        by_body.setdefault(part.body, []).append(part)
    for number, its in enumerate(all_topics):
        for body, parts in by_body.items():
            if body >= 0 or not number:
                frame = its.prefix + names[body] if body >= 0 else _SPACE
                yield _entity(frame, parts, _PALE if number else 1.0)


def _entity(frame: str, parts: list[DrawnPart], opacity: float) -> messages.SceneEntity:
    """The shapes of a body, which move with its frame."""
    cubes, spheres, cylinders, triangles = [], [], [], []
    for x in parts:
        pose = _pose(x.place)
        red, green, blue, alpha = [*x.colour, 1.0][:4]
        colour = messages.Color(r=red, g=green, b=blue, a=alpha * opacity)
        if x.piece:
            triangles.append(messages.TriangleListPrimitive(
                pose=pose, color=colour, indices=x.piece.faces.ravel().tolist(),
                points=[messages.Point3(x=a, y=b, z=c) for a, b, c in x.piece.vertices.tolist()]))
        elif x.shape == "box":
            cubes.append(messages.CubePrimitive(pose=pose, color=colour, size=_vector(x.size)))
        elif x.shape in ("cylinder", "capsule"):
            radius, length = x.size
            size = _vector((2 * radius, 2 * radius, length))
            cylinders.append(messages.CylinderPrimitive(
                pose=pose, color=colour, bottom_scale=1.0, top_scale=1.0, size=size))
            if x.shape == "capsule":
                spheres += [messages.SpherePrimitive(
                    pose=_pose(end), color=colour, size=_vector((2 * radius,) * 3))
                    for end in _ends(x.place, length)]
        else:
            spheres.append(messages.SpherePrimitive(pose=pose, color=colour, size=_vector(
                2 * np.broadcast_to(x.size, 3))))
    return messages.SceneEntity(id=frame, frame_id=frame, frame_locked=True, cubes=cubes,
                                spheres=spheres, cylinders=cylinders, triangles=triangles)


def _ends(place: tuple[float, ...], length: float) -> Iterator[tuple[float, ...]]:
    """The places of the half balls of a capsule."""
    x, y, z, w = place[3:]
    axis = np.array([2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)])
    for side in (-0.5, 0.5):
        yield (*(np.array(place[:3]) + side * length * axis).tolist(), *place[3:])


def _transforms(shown: Playback, its: RunTopics, k: int, time: int) -> messages.FrameTransforms:
    """The poses of all bodies of a run at its sample k."""
    stamp = messages.Timestamp(*divmod(time, _SECOND))
    bodies, poses = shown.result.system.scene.model.bodies, its.run.poses[k].tolist()
    return messages.FrameTransforms(transforms=[messages.FrameTransform(
        timestamp=stamp, parent_frame_id=_SPACE, child_frame_id=its.prefix + body.name,
        translation=_vector(place[:3]), rotation=_quaternion(place[3:]))
        for body, place in zip(bodies, poses, strict=True)])


def _pose(place: tuple[float, ...]) -> messages.Pose:
    return messages.Pose(position=_vector(place[:3]), orientation=_quaternion(place[3:]))


def _vector(numbers: "Sequence[float] | np.ndarray") -> messages.Vector3:
    x, y, z = map(float, numbers)
    return messages.Vector3(x=x, y=y, z=z)


def _quaternion(numbers: Sequence[float]) -> messages.Quaternion:
    x, y, z, w = numbers
    return messages.Quaternion(x=x, y=y, z=z, w=w)


def _nanoseconds(t: float) -> int:
    return round(float(t) * _SECOND)
