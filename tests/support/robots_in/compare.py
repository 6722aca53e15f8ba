"""Reads one file of a package, and compares it with the program that reads its format, too."""

import hashlib
import re
import time
from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from functools import cache
from pathlib import Path

import mujoco

from coscrew_codegen.program.scene_functions import SceneFunctions
from coscrew_codegen.scene.mechanism.inertia_checks import WARN
from coscrew_codegen.scene.readers.foreign import root_of
from coscrew_codegen.scene.readers.model_formats import reader_of
from coscrew_codegen.scene.readers.model_reader import ModelSource
from coscrew_codegen.scene.readers.scene_error import SceneError
from coscrew_codegen.scene.readers.toml.toml_scene import SceneOverrides, read_scene
from coscrew_codegen.scene.readers.xacro.xacro_reader import expanded
from coscrew_codegen.scene.scene import Scene
from tests.support.robots_in.drake_states import drake_states
from tests.support.robots_in.outcome import (
    AGREES,
    DIFFERS,
    NOT_COMPARED,
    REFUSED,
    STILL,
    NotCompared,
    Outcome,
)
from tests.support.robots_in.pinocchio_states import pinocchio_states
from tests.support.scenes.mujoco_pairs import mujoco_states
from tests.support.scenes.peer_states import PeerState, derived, worst_of_programs

FORMATS = ("MJCF", "URDF", "xacro", "SDF")
_SUFFIXES = {".xml": "MJCF", ".mjcf": "MJCF", ".urdf": "URDF", ".xacro": "xacro", ".sdf": "SDF"}
CLOSE = 1e-9
_LARGE, _STATES, _FEW = 60, 10, 2
_SOFT = frozenset(("loops", "equalities"))
"""Groups of constraints, without which MuJoCo's numbers are computed, too."""


def files_of(folder: Path, formats: Iterable[str]) -> Iterator[tuple[Path, str]]:
    """The files of models in a folder, with their formats, in order."""
    for path in sorted(folder.rglob("*")):
        format_ = _SUFFIXES.get(path.suffix.lower(), "")
        if format_ in formats and path.is_file() and (
                format_ != "MJCF" or _root(path) == "mujoco"):
            yield path, format_


def _root(path: Path) -> str:
    try:
        return root_of(path)
    except SceneError:
        return ""


def outcome_of(package: str, path: Path, format_: str, folder: Path) -> Outcome:
    """The outcome of reading and comparing a file."""
    result = Outcome(package, str(path.relative_to(folder)), format_, REFUSED)
    start = time.process_time()
    try:
        scene = _read(path, folder)
    except SceneError as error:
        return _refusal(result, path, error)
    result = replace(result, reading=time.process_time() - start, model=_hash(scene),
                     without=_left_out(scene))
    try:
        functions = derived(scene)
        result = replace(result, velocities=functions.nv)
        states = _states(scene, functions, path, folder, format_)
        largest = worst_of_programs(scene, functions, states)
    except NotCompared as reason:
        return replace(result, status=NOT_COMPARED, reason=str(reason))
    if largest.all <= CLOSE:
        return replace(result, status=AGREES, error=largest.all)
    what = [name for name in ("mass_matrix", "bias", "torques")
            if not getattr(largest, name) <= CLOSE]
    return replace(result, status=DIFFERS, error=largest.all, reason=", ".join(what))


@cache
def packages_of(folder: Path) -> dict[str, Path]:
    """Packages of ROS that a file of xacro calls NAME_support, and PyPI's package just NAME."""
    return {f"{x.parent.name.removesuffix('_description')}_support": x.parent
            for x in folder.rglob("urdf") if x.is_dir()}


def _read(path: Path, folder: Path) -> Scene:
    """The scene of the file alone, without what no scene can have; with implausible inertias if
    there are any.  Effects that MuJoCo counts among actuators and constraints are not there."""
    reader = reader_of(path)
    packages = packages_of(folder) if reader and reader.takes_arguments else {}
    given = SceneOverrides(precision="double", leave_out=reader.leaves_out if reader else (),
                           packages=tuple((x, str(y)) for x, y in packages.items()))
    try:
        scene = read_scene(path, overrides=given)
    except SceneError as error:
        if "implausible" not in str(error):
            raise
        scene = read_scene(path, overrides=replace(given, implausible=WARN))
    mjcf = reader is not None and reader.name == "MJCF"
    return replace(scene, parameters=(), effects=tuple(
        x for x in scene.effects if (x.effect.name != "actuator" if mjcf else
                                     x.effect.name == "gravity")))


def _states(scene: Scene, functions: SceneFunctions, path: Path, folder: Path, format_: str
            ) -> Iterator[PeerState]:
    """States with the results of the other program."""
    if format_ == "MJCF":
        model = mujoco.MjModel.from_xml_path(str(path))
        return mujoco_states(scene, functions.coordinates, model,
                             _FEW if model.nv > _LARGE else _STATES)
    if format_ == "SDF":
        return drake_states(scene, functions, path)
    text = path.read_bytes().decode("utf-8", "replace") if format_ == "URDF" else \
        expanded(ModelSource(path, packages=packages_of(folder)))[0]
    return pinocchio_states(scene, functions, text)


def _left_out(scene: Scene) -> tuple[str, ...]:
    """The groups that were left out, except constraints, which the comparison leaves out, too."""
    groups = {match[1] for x in scene.notices
              if (match := re.fullmatch(r".*: left out \((\w+)\)", x.text))}
    return tuple(sorted(groups - _SOFT))


def _hash(scene: Scene) -> str:
    """A hash of masses, moments and joints: of copies it is the same."""
    model = scene.model
    bodies = sorted(repr(x.inertia) for x in model.bodies if x.inertia)
    joints = sorted(repr((x.kind.name, x.placement, x.axis)) for x in model.joints if x.kind.moves)
    return hashlib.sha256("\n".join(bodies + joints).encode()).hexdigest()


_KINDS: tuple[tuple[str, Callable[[str], bool]], ...] = (
    (STILL, lambda text: any(
        x in text for x in ("has no joint that moves", "nothing moves", "has no bodies"))),
    (NOT_COMPARED, lambda text: "MuJoCo says" in text))


def _refusal(result: Outcome, path: Path, error: SceneError) -> Outcome:
    """The outcome of a file that is refused, with the message less names and places."""
    text = re.sub(r"'[^']*'|\bline \d+\b|[-+]?\d[\d.e+-]*", "…", error.problem)[:90]
    status = next((status for status, fits in _KINDS if fits(error.problem)), REFUSED)
    return replace(result, status=status, reason=text)
