"""Derivatives of torques by differentiating their Program: those of effects, and, where a joint's
screws depend on q, those of all.

Derivatives with respect to q are along velocities: of q ⊕ φ at φ = 0.  At a choice's corner they
are those of the option that is taken."""

from collections.abc import Callable, Mapping, Sequence
from itertools import accumulate, pairwise

from coscrew_codegen.algebra.recording import derivatives
from coscrew_codegen.algebra.recording.numbers import Number, subtract
from coscrew_codegen.algebra.recording.recorder import Recorder, array
from coscrew_codegen.dynamics.algorithms import coordinates, rnea
from coscrew_codegen.dynamics.forces.applied_effects import AppliedEffects
from coscrew_codegen.dynamics.function_recording import FunctionRecording
from coscrew_codegen.program import Program
from coscrew_codegen.program.differentiate import Dual
from coscrew_codegen.program.values.quantity import Argument

Matrix = list[list[Number]]
Torques = Callable[[FunctionRecording], Sequence[Number]]
Delays = Mapping[int, Number]
"""By joint's link, what is added to the time at which effects act on the joint."""


def of_effects(x: FunctionRecording, delays: Delays | None = None) -> Sequence[Number]:
    """The torques that joints must supply against effects, besides gravity, and for joints' own
    inertias at a = 0."""
    motion = x.motion(accelerating=False)
    applied = AppliedEffects(x.scene, motion, delays).act()
    none = (*motion.zero, *motion.zero)
    wrenches = [subtract(none, applied.force(n)) for n in range(len(x.tree.links))]
    return rnea.joint_torques(motion, rnea.transmitted(motion, wrenches), applied, x.inertias)


def of_all(x: FunctionRecording, delays: Delays | None = None) -> Sequence[Number]:
    """The torques of inverse dynamics."""
    motion = x.motion()
    return x.torques(motion, AppliedEffects(x.scene, motion, delays).act())


def differentiated(x: FunctionRecording, torques: Torques, by: Sequence[str],
                   given: dict[str, Sequence[Number]]) -> list[Matrix]:
    """The derivatives of torques, or of other numbers, with respect to inputs, row by row, at
    inputs that may be numbers of the recording instead of its own."""
    program = _recorded(x, torques, given)
    sizes = {a.name: x.tree.nv if a.name == "q" else a.quantity.size for a in program.inputs}
    ends = list(accumulate((sizes[name] for name in by), initial=0))
    zero = x.recorder.number(0)
    if not program.instructions and all(not hasattr(r, "argument") for r in program.results):
        return [[[zero] * sizes[name] for _ in program.results] for name in by]
    duals = [_dual(x, given.get(a.name) or x.recorder.argument(a.name), a.name,
                   ends[by.index(a.name)] if a.name in by else None, ends[-1])
             for a in program.inputs]
    known = {}
    if "q" in by:
        x.recorder.replay(program, *([y.value for y in row] for row in duals))
        first, motion = ends[by.index("q")], x.motion(moving=False, accelerating=False)
        known = {y: _spread(y, row[:x.tree.nv], first, ends[-1])
                 for y, row in coordinates.displacement_chart(motion).items()}
        duals = [[known.get(y.value, y) for y in row] for row in duals]
    slopes = derivatives.along(program, x.recorder, duals, known)
    return [[[zero if s is None else s for s in y.slopes[first:last]] for y in slopes]
            for first, last in pairwise(ends)]


def _recorded(x: FunctionRecording, torques: Torques, given: dict[str, Sequence[Number]]
              ) -> Program:
    """The numbers as a Program of h, q, v, a, t, p and what is given."""
    own = {a.name: a for a in x.recorder.inputs}
    inputs: list[Argument] = [a for a in own.values()
                              if a.name in ("h", "t", "p", "q", "v", "a")]
    inputs += [array(name, (len(y),)) for name, y in given.items() if name not in own]
    recorder = Recorder(inputs)
    with recorder.part("tau"):
        results = torques(FunctionRecording(x.scene, x.tree, x.names, recorder))
        return recorder.program("torques", [(array("tau", (len(results),)), list(results))])


def _dual(x: FunctionRecording, numbers: Sequence[Number], name: str, first: int | None, count: int
          ) -> list[Dual[Number]]:
    """An input's components with their derivatives along all directions; its own begin at `first`.
    """
    if first is None:
        return [Dual(n, (None,) * count) for n in numbers]
    one, size = x.recorder.number(1), len(numbers)
    rows = coordinates.chart(x.motion(moving=False, accelerating=False)) if name == "q" else [
        [one if i == j else None for j in range(size)] for i in range(size)]
    return [_spread(n, row, first, count) for n, row in zip(numbers, rows, strict=True)]


def _spread(n: Number, row: Sequence[Number | None], first: int, count: int) -> Dual[Number]:
    """A number with its row of derivatives, which begins at `first` of all directions."""
    return Dual(n, (*[None] * first, *row, *[None] * (count - first - len(row))))
