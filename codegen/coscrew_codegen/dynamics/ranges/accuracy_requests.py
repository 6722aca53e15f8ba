"""Accuracy that a scene requests of a function, and the limits between which states are drawn."""

from collections.abc import Iterator, Mapping
from math import inf, isfinite, pi

from coscrew_codegen.dynamics.ranges.argument_ranges import argument_ranges
from coscrew_codegen.program import Program
from coscrew_codegen.program.reported_error import ReportedError
from coscrew_codegen.program.scene_functions import Accuracy, ArgumentRanges
from coscrew_codegen.scene.effect_quantities import states_of
from coscrew_codegen.scene.joints import kind_named
from coscrew_codegen.scene.mechanism.model import Joint
from coscrew_codegen.scene.mechanism.ranges import Intervals
from coscrew_codegen.scene.mechanism.tree import Tree
from coscrew_codegen.scene.names import did_you_mean
from coscrew_codegen.scene.scene import Scene

REACHED_IN = 0.1
"""Time in which accelerations reach the velocity limits, in s."""


class RequestError(ReportedError, ValueError):
    """A request that cannot be met: for an output that the function lacks, or where no states can
    be drawn."""


def requested(program: Program, scene: Scene, tree: Tree) -> Accuracy | None:
    """The accuracy requested of this function; None without a request.  Raises RequestError."""
    within = {x.output: x.within for x in scene.accuracy if x.function == program.name}
    if not within:
        return None
    outputs = [a.name for a in program.outputs]
    for name in within:
        if name not in ("", *outputs):
            raise RequestError(f"{scene.name}: accuracy.{program.name}: no output {name!r}; "
                             f"{did_you_mean(name, outputs)}")
    components = tuple((a.name, k) for a in program.outputs for k in range(a.quantity.size))
    every = within.get("", inf)
    stated = argument_ranges(program, scene.ranges) if scene.ranges else None
    drawn = tuple(_drawn(number, a.name, program, scene, tree, stated)
                  for number, a in enumerate(program.inputs))
    return Accuracy(tuple(within.get(name, every) for name, _ in components), components, drawn,
                    tuple((n, c.q[places])
                          for n, a in enumerate(program.inputs) if a.name == "q"
                          for c in tree.coordinates for places in kind_named(c.kind).quaternions),
                    stated)


def _drawn(number: int, name: str, program: Program, scene: Scene, tree: Tree,
           stated: ArgumentRanges | None) -> Intervals:
    """The intervals from which an input's components are drawn: stated ones where they are finite.
    """
    if stated and all(isfinite(end) for x in stated.intervals[number] for end in x):
        return stated.intervals[number]
    between = _ranges(name, program, scene, tree)
    if not stated:
        return between
    return tuple(x if all(map(isfinite, x)) else y
                 for x, y in zip(stated.intervals[number], between, strict=True))


def _ranges(name: str, program: Program, scene: Scene, tree: Tree) -> Intervals:
    joints = {link.joint.name: link.joint for link in tree.links}
    ranges: Mapping[str, Intervals] = {
        "t": ((0.0, scene.run.duration),),
        "p": tuple((float(x.value), float(x.value)) for x in scene.parameters),
        "r": ((-scene.model.length, scene.model.length),) * 3}
    if name in ranges:
        return ranges[name]
    if name == "q" and (states := states_of(scene)):
        raise RequestError(f"{scene.name}: accuracy.{program.name}: states cannot be drawn for a "
                           f"scene whose effects have some, as {states[0].name}; wanted no "
                           "[accuracy]")
    results: list[tuple[float, float]] = []
    for c in tree.coordinates:
        joint = joints[c.joint]
        if name == "q":
            results += positions(joint)
            continue
        results += [(-half, half) for half in _halves(name, joint, scene, program)]
    return tuple(results)


def positions(joint: Joint) -> Intervals:
    """Ranges of a joint's positions.  A missing limit is one turn, or 2 m, from the other one;
    without both limits the range is half of that to either side of zero."""
    lower, upper = (None if x is None else float(x) for x in (joint.lower, joint.upper))
    results = []
    for unit in joint.kind.units("q"):
        half = pi if unit == "rad" else 1.0
        low = (-half if upper is None else upper - 2 * half) if lower is None else lower
        results.append((low, low + 2 * half if upper is None else upper))
    return tuple(results)


def speeds(joint: Joint) -> tuple[float, ...]:
    """Largest velocities of a joint: without limits π rad/s of angles, 1 m/s and 1 rad/s of
    others."""
    return tuple(float(joint.velocity or (pi if part.unit == "rad" else 1))
                 for part in joint.kind.parts for _ in range(part.speeds))


def _halves(name: str, joint: Joint, scene: Scene, program: Program) -> Iterator[float]:
    """Largest sizes of an input's components at a joint."""
    if name == "tau":
        if not joint.effort:
            raise RequestError(f"{scene.name}: accuracy.{program.name}: joint {joint.name!r} has "
                               "no limit of its effort, which the drawing of states needs; wanted "
                               "limits = { effort = … }")
        yield from [float(joint.effort)] * joint.kind.nv
        return
    factors = {"v": 1.0, "a": 1 / REACHED_IN, "phi": scene.run.step}
    if name not in factors:
        raise RequestError(f"{scene.name}: accuracy.{program.name}: states cannot be drawn for its "
                         f"input {name}")
    yield from (speed * factors[name] for speed in speeds(joint))
