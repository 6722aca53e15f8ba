"""Writes a page that plays a run back in 3D: self-contained HTML, without network access.

Bodies are boxes of the same mass and inertia; lines go from a body's origin to the joints on it
and, thinner, to its centre of mass."""

import base64
from collections.abc import Iterator
from dataclasses import asdict, dataclass, field
from pathlib import Path

import numpy as np

import coscrew
from coscrew_codegen.backends.html import pages
from coscrew_codegen.program.values.parameter import Parameter, Scalar
from coscrew_codegen.scene.mechanism.model import WORLD, Inertia, Joint
from coscrew_codegen.simulation.plan import Trajectory
from coscrew_codegen.simulation.recordings.playback_charts import charts
from coscrew_codegen.simulation.recordings.recording import Provenance
from coscrew_codegen.simulation.recordings.recording_plot import CHART
from coscrew_codegen.simulation.recordings.recording_writer import delivered
from coscrew_codegen.simulation.system import System

_FRAMES_A_SECOND = 60
_MOST_NUMBERS = 2_000_000  # numbers in all poses: 8 MB, enough for a minute of thirty bodies
_THIN = 0.06  # least side of a box, relative to its longest or, for a point mass, the model's size
_LEAST_SHOWN = 3.0  # s: least duration of a playback at the initial speed
_SPEEDS = ((0.1, "0.1×"), (0.25, "0.25×"), (0.5, "0.5×"), (1, "1×"), (2, "2×"), (5, "5×"))


Entries = list[dict[str, object]]


@dataclass(frozen=True)
class Drawn:
    """Drawn elements, each with the number of the body that it is fixed to (-1: the world), in its
    frame."""

    shapes: Entries = field(default_factory=list)  # body, shape: half sides, place as a pose
    lines: Entries = field(default_factory=list)  # body, points, rod: to a centre of mass?
    slides: Entries = field(default_factory=list)  # body, point, child: from point to its origin
    joints: Entries = field(default_factory=list)  # body, point
    extent: Entries = field(default_factory=list)  # body, points: in the camera's view


def view(system: System, trajectory: Trajectory, provenance: Provenance, path: Path) -> None:
    """Write the page.  Raises SimulateError."""
    with delivered(path) as temporary:
        temporary.write_text(page(system, trajectory, provenance), encoding="utf-8", newline="\n")


def page(system: System, trajectory: Trajectory, provenance: Provenance) -> str:
    """The text of the page."""
    scene, names = system.scene, [body.name for body in system.scene.model.bodies]
    frames, poses = _shown(system, trajectory)
    t, drawing = trajectory.t[frames], drawn(system)
    shown = tuple(charts(system, trajectory, frames))
    data = {"t": _packed(t, "<f8"), "poses": _packed(poses, "<f4"), "chart": CHART,
            "values": [{"values": _packed(values, "<f8"), "unit": x.unit}
                       for x in shown for values in x.columns.values()],
            "bodies": names, "up": _up(system), **asdict(drawing), "labels": _labels(system)}
    count = len(names)
    sentence = (f"{count} {'body' if count == 1 else 'bodies'}, {trajectory.t[-1]:g} s, "
                f"{dict(provenance)['integrator']}, {system.precision.name} precision.")
    rest = "" if t[-1] == trajectory.t[-1] else (
        f"The playback ends at t = {t[-1]:.6g} s: the rest is too large to be shown.")
    speed = max((x for x, _ in _SPEEDS if x <= 1 and x * _LEAST_SHOWN <= t[-1]),
                default=_SPEEDS[0][0])
    return pages.page("view/page.html", data, speed=speed, name=scene.name, sentence=sentence,
                      bodies=names, stopped=trajectory.stopped, rest=rest, speeds=_SPEEDS,
                      charts=shown, source=provenance)


def _shown(system: System, trajectory: Trajectory) -> tuple[np.ndarray, np.ndarray]:
    """Indices and poses of the frames, up to the first whose poses overflow."""
    frames = _frames(trajectory.t, len(system.scene.model.bodies))
    poses = _poses(system, trajectory.t[frames], trajectory.q[frames])
    count = max(1, int(np.argmin([*np.isfinite(poses).all((1, 2)), False])))
    return frames[:count], poses[:count]


def _frames(t: np.ndarray, bodies: int) -> np.ndarray:
    """Indices of the samples shown: at most 60 per second and _MOST_NUMBERS in all, with the last.
    """
    most = max(2, min(int(_FRAMES_A_SECOND * t[-1]) + 2, _MOST_NUMBERS // (7 * max(bodies, 1))))
    return np.unique(np.linspace(0, len(t) - 1, min(most, len(t))).round().astype(int))


def _packed(numbers: np.ndarray, kind: str) -> str:
    return base64.b64encode(np.ascontiguousarray(numbers, kind).tobytes()).decode()


def _poses(system: System, t: np.ndarray, q: np.ndarray) -> np.ndarray:
    """Position and unit quaternion of each body at each time, in single precision, which is finer
    than pixels.  (frames, bodies, 7)."""
    D = np.asarray(system.call("body_poses", t=t, q=q), float).reshape(len(q), -1, 3, 4)
    turned = coscrew.double.quaternion_from_mat3x3(D[..., :3])
    with np.errstate(over="ignore"):
        return np.concatenate((D[..., 3], turned), -1).astype(np.float32)


def _up(system: System) -> list[float]:
    """The direction opposite to gravity, or z without gravity."""
    for applied in system.scene.effects:
        if applied.effect.name == "gravity":
            g = np.array([_number(system, x) for x in applied.vector("g")])
            if np.any(g):
                return list(-g / np.linalg.norm(g))
    return [0.0, 0.0, 1.0]


def drawn(system: System) -> Drawn:
    """The drawing of the scene's model, everything in the frame of the body it is fixed to."""
    model, result = system.scene.model, Drawn()
    numbers = {WORLD: -1, **{body.name: n for n, body in enumerate(model.bodies)}}
    for joint in model.joints:
        if not joint.kind.floats:
            _add_joint(system, result, joint, numbers)
    for body in model.bodies:
        if body.inertia:
            _add_box(system, result, body.inertia, numbers[body.name])
    return result


def _add_joint(system: System, result: Drawn, joint: Joint, numbers: dict[str, int]) -> None:
    """Add the line from the parent's origin to the joint, and from there to a sliding body."""
    body, at = numbers[joint.parent], _numbers(system, joint.placement.t).tolist()
    result.lines.append({"body": body, "points": [[0, 0, 0], at], "rod": False})
    result.extent.append({"body": body, "points": [at]})
    if joint.kind.moves:
        result.joints.append({"body": body, "point": at})
    if any(not part.turns for part in joint.kind.parts):
        result.slides.append({"body": body, "point": at, "child": numbers[joint.child]})


def _add_box(system: System, result: Drawn, inertia: Inertia, body: int) -> None:
    """Add a box with the body's mass and inertia, and the line to its centre."""
    half, axes = box_of(*(_numbers(system, x) for x in ((inertia.mass,), inertia.moments)))
    half = np.maximum(half, _THIN * (max(half) if max(half) > 0 else _size(system)))
    centre = _numbers(system, inertia.com)
    place = [*centre.tolist(), *coscrew.double.quaternion_from_mat3x3(axes).tolist()]
    result.shapes.append({"body": body, "shape": {"half": half.tolist(), "place": place}})
    result.lines.append({"body": body, "points": [[0, 0, 0], centre.tolist()], "rod": True})
    corners = [(centre + axes @ (half * signs)).tolist() for signs in _corners()]
    result.extent.append({"body": body, "points": corners})


def _corners() -> Iterator[np.ndarray]:
    for i in range(8):
        yield np.array([1 if i >> k & 1 else -1 for k in range(3)])


def box_of(mass: np.ndarray, moments: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Half sides and axes (columns) of the uniform box of this mass and these moments of inertia
    xx, yy, zz, xy, xz, yz about its centre: (2 a)² = 6 (tr I - 2 I_aa) / m along each axis."""
    xx, yy, zz, xy, xz, yz = moments
    if np.any(moments[3:]):
        values, axes = np.linalg.eigh([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
        axes[:, 2] *= np.sign(np.linalg.det(axes))
    else:
        values, axes = moments[:3], np.eye(3)
    squares = 6 * (values.sum() - 2 * values) / mass if mass > 0 else np.zeros(3)
    return np.sqrt(np.maximum(squares, 0)) / 2, axes


def _size(system: System) -> float:
    """The approximate size of the model: the largest distance from a joint to the next joint or a
    centre of mass; 0.1 m if that is zero."""
    model = system.scene.model
    offsets = [np.linalg.norm(_numbers(system, j.placement.t)) for j in model.joints]
    centres = [np.linalg.norm(_numbers(system, b.inertia.com)) for b in model.bodies if b.inertia]
    return float(max((*offsets, *centres), default=0)) or 0.1


def _labels(system: System) -> list[list[float]]:
    """Positions of the bodies' names, in their frames: the centres of mass."""
    return [_numbers(system, body.inertia.com).tolist() if body.inertia else [0.0] * 3
            for body in system.scene.model.bodies]


def _numbers(system: System, values: tuple[Scalar, ...]) -> np.ndarray:
    return np.array([_number(system, x) for x in values])


def _number(system: System, value: Scalar) -> float:
    return system.p[value.index] if isinstance(value, Parameter) else float(value)
