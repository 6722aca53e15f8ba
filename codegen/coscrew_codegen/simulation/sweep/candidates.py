"""Inputs of a scene that can vary: run-time parameters, and the coordinates and velocities at which
it starts, by name."""

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import NoReturn

from coscrew_codegen.scene import patterns
from coscrew_codegen.scene.mechanism.model import Joint
from coscrew_codegen.scene.names import did_you_mean
from coscrew_codegen.scene.parameter_units import parameter_units
from coscrew_codegen.scene.readers.toml.runtime import constants
from coscrew_codegen.scene.recorded_quantities import coordinates
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.simulation.parameter_checks import ranges
from coscrew_codegen.simulation.sweep import SweepError
from coscrew_codegen.simulation.sweep.sweep_options import UNIFORM

START = "start."
"""Prefixes of the names of coordinates and velocities: start.q.elbow, start.v.base.2."""

Ends = tuple[float, float]


@dataclass(frozen=True)
class Candidate:
    """A number that can vary: entry `index` of p, q or v; or of u, which has three numbers for each
    quaternion, from which it follows."""

    name: str  # payload.mass, start.q.elbow
    array: str
    index: int
    unit: str = ""
    limits: Ends | None = None  # of its joint
    fault: str = ""  # why the joint's limits cannot be used


def candidates(scene: Scene, settings: Mapping[str, float]) -> Mapping[str, Candidate]:
    """Returns all inputs that can vary by themselves, by name.  Components of quaternions are not
    among them: they depend on each other."""
    units = parameter_units(scene)
    results = [Candidate(x.name, "p", x.index, units[x.name]) for x in scene.parameters]
    ends = {x.on: (low, high) for x, low, high in ranges(scene, settings)}
    for joint, q, v in coordinates(scene):
        results += _of(joint, "q", q, _positions(joint, ends))
        results += _of(joint, "v", v, _speeds(joint))
    return {x.name: x for x in results}


def rotations(scene: Scene) -> Mapping[str, tuple[Candidate, ...]]:
    """The numbers from 0 to 1 that give each joint's quaternion, by the name of its start."""
    joints = (joint for joint, _, _ in coordinates(scene)
              if joint.kind.quaternions)
    return {name: tuple(Candidate(f"{name}.uniform.{k}", "u", 3 * n + k, "1") for k in range(3))
            for n, name in enumerate(f"{START}q.{joint.name}" for joint in joints)}


def _of(joint: Joint, array: str, places: range, limits: Ends | None) -> Iterator[Candidate]:
    stem, unit = f"{START}{array}.{joint.name}", _unit(joint, array)
    turning = joint.kind.quaternions if array == "q" else ()
    dependent = {k for x in turning for k in range(x.start, x.stop)}
    for k, index in enumerate(places):
        if k in dependent:
            continue
        name = stem if len(places) == 1 else f"{stem}.{k}"
        yield Candidate(name, array, index, unit[k], limits, _fault(joint, array))


def _fault(joint: Joint, array: str) -> str:
    faults = [joint.fault(x) for x in (("lower", "upper") if array == "q" else ("velocity",))]
    return next((f" ({x.place}: {x.problem})" for x in faults if x), "")


def _unit(joint: Joint, array: str) -> tuple[str, ...]:
    return joint.kind.units(array)


def _positions(joint: Joint, ends: Mapping[str, Ends]) -> Ends | None:
    """The range of the joint's limit effect, or else the model's."""
    model = (-math.inf if joint.lower is None else float(joint.lower),
             math.inf if joint.upper is None else float(joint.upper))
    low, high = ends.get(joint.name, model)
    return (low, high) if math.isfinite(high - low) and low < high else None


def _speeds(joint: Joint) -> Ends | None:
    most = float(joint.velocity or 0)
    return (-most, most) if most > 0 else None


def one(option: str, name: str, scene: Scene, known: Mapping[str, Candidate]) -> Candidate:
    """The candidate of this name.  Raises SweepError."""
    names = patterns.matching(name, known)
    if not names:
        _refuse(option, name, scene, known)
    if names != (name,):
        raise SweepError(f"{option} {name}: wanted one name; the pattern matches "
                         f"{', '.join(names)}; --sobol samples all that a pattern matches")
    return known[name]


def matching(option: str, pattern: str, scene: Scene, known: Mapping[str, Candidate]
             ) -> tuple[Candidate, ...]:
    """The candidates whose names match the pattern (* ? [abc]).  Raises SweepError."""
    names = patterns.matching(pattern, known)
    if not names:
        _refuse(option, pattern, scene, known)
    return tuple(known[name] for name in names)


def turned(option: str, pattern: str, scene: Scene) -> tuple[Candidate, ...]:
    """The numbers that give the quaternions whose names match the pattern.  Raises SweepError."""
    known = rotations(scene)
    if not (numbers := tuple(x for name in patterns.matching(pattern, known) for x in known[name])):
        raise SweepError(f"{option} {pattern}={UNIFORM}: matches no start of a joint with a "
                         f"quaternion; there are {', '.join(known) or 'none'}")
    return numbers


def _refuse(option: str, name: str, scene: Scene, known: Mapping[str, Candidate]) -> NoReturn:
    fixed = patterns.matching(name, constants(scene.model, scene.effects))
    if fixed:
        listed = ", ".join(f'"{x}"' for x in (*(x.name for x in scene.parameters), *fixed))
        raise SweepError(f"{option} {name}: a constant of the scene's functions; to vary it, write "
                         f"into the scene's file: runtime = [{listed}]")
    for x in rotations(scene):
        if name.startswith(x) or patterns.matching(name, (x,)):
            raise SweepError(f"{option} {name}: components of a quaternion, which cannot vary one "
                             f"by one; wanted --sobol {x}={UNIFORM}")
    if patterns.is_pattern(name):
        raise SweepError(f"{option} {name}: matches nothing; {did_you_mean(name, known)}")
    raise SweepError(f"{option} {name}: neither a `runtime` parameter nor a start; "
                     f"{did_you_mean(name, known)}")


def limits_of(option: str, candidate: Candidate) -> Ends:
    """The limits of a candidate's joint.  Raises SweepError."""
    if candidate.limits is None:
        what = {"p": "a parameter has no limits", "q": "its joint has no range with two ends",
                "v": "its joint has no velocity limit"}[candidate.array]
        raise SweepError(f"{option}: {candidate.name}: {what}{candidate.fault}; give --sobol "
                         f"{candidate.name}=LOW:HIGH, and a pattern that leaves it out")
    return candidate.limits
