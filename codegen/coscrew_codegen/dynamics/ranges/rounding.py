"""States proved bounds of a plain function's rounding errors for all states within the joints'
limits; nothing where a bound is infinite or too large to be of use.

Also the accuracy that a scene requests of a function, and the limits between which states are drawn
to tune it."""

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from math import inf, isfinite, pi

from coscrew_codegen.accuracy.float_rounding import FloatRounding
from coscrew_codegen.accuracy.rounding_rules import ValueBounds, followed
from coscrew_codegen.dynamics.ranges.argument_ranges import argument_ranges
from coscrew_codegen.program import Op, Program
from coscrew_codegen.program.reported_error import ReportedError
from coscrew_codegen.program.roundoff import RoundedRange
from coscrew_codegen.program.scene_functions import Accuracy, ArgumentRanges
from coscrew_codegen.program.values.digits import two_digits_up
from coscrew_codegen.program.values.formats import Precision, named
from coscrew_codegen.scene.effect_quantities import states_of
from coscrew_codegen.scene.joints import kind_named
from coscrew_codegen.scene.mechanism.model import Joint
from coscrew_codegen.scene.mechanism.ranges import Intervals, ranges_of_model
from coscrew_codegen.scene.mechanism.tree import Tree
from coscrew_codegen.scene.names import did_you_mean
from coscrew_codegen.scene.scene import Scene

USEFUL = 1000
"""Largest bound that is stated, in units u of the largest size that an output's components can
have."""


def statement(program: Program, scene: Scene, tree: Tree) -> str:
    """The bounds of a plain function's outputs in the scene's precisions, for all arguments in
    limits; "" without any."""
    if not followed(program) or Op.DIV in program.counts:
        return ""
    limits = ranges_of_model(tree, scene.parameters)
    sizes = [[max(map(abs, x)) for x in limits.of(a.name, a.quantity.size)]
             for a in program.inputs]
    words: dict[str, list[str]] = {}
    for precision in named(scene.precisions):
        values = ValueBounds(program, sizes, FloatRounding(precision, plain=True))
        for name, bound in _bounds(program, values.results, precision):
            words.setdefault(name, []).append(f"{two_digits_up(bound)} in {precision.name}")
    if not words:
        return ""
    bounds = "; ".join(f"{name} by at most {' and '.join(texts)}" for name, texts in words.items())
    domain = _domain(program, tree)
    return f"Proved: rounding moves {bounds} precision{f', for every {domain}' if domain else ''}."


def _bounds(program: Program, components: Sequence[RoundedRange], precision: Precision
            ) -> Iterator[tuple[str, float]]:
    """The outputs with a useful bound."""
    start = 0
    for a in program.outputs:
        parts = components[start:start + a.quantity.size]
        start += a.quantity.size
        bound, size = max(x.error for x in parts), max(x.size for x in parts)
        if 0 < bound <= USEFUL * precision.u * Fraction(size if isfinite(size) else 0):
            yield a.name, bound


def _domain(program: Program, tree: Tree) -> str:
    taken = {a.name for a in program.inputs}
    words = [f"{name} within the joints' {limits}" for name, limits in (
        ("q", "limits"), ("v", "velocities")) if name in taken]
    if "q" in taken and not any(link.joint.lower is not None for link in tree.links):
        words[0] = "q"
    if "p" in taken:
        words.append("parameters up to the scene's in size")
    return " and ".join(words)


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
