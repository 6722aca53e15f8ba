"""Derivatives of torques by differentiating their Program: those of effects, and, where a joint's
screws depend on q, those of all.

Derivatives with respect to q are along velocities: of q ⊕ φ at φ = 0.  At a choice's corner they
are those of the option that is taken."""

from collections.abc import Callable, Sequence

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


def of_effects(x: FunctionRecording) -> Sequence[Number]:
    """The torques that joints must supply against effects, besides gravity, and for joints' own
    inertias at a = 0."""
    motion = x.motion(accelerating=False)
    applied = AppliedEffects(x.scene, motion).act()
    none = (*motion.zero, *motion.zero)
    wrenches = [subtract(none, applied.force(n)) for n in range(len(x.tree.links))]
    return rnea.joint_torques(motion, rnea.transmitted(motion, wrenches), applied, x.inertias)


def of_all(x: FunctionRecording) -> Sequence[Number]:
    """The torques of inverse dynamics."""
    motion = x.motion()
    return x.torques(motion, AppliedEffects(x.scene, motion).act())


def differentiated(x: FunctionRecording, torques: Torques, by: Sequence[str],
                   given: dict[str, Sequence[Number]]) -> list[Matrix]:
    """The derivatives of torques with respect to q, v or a, row by row, at inputs that may be
    numbers of the recording instead of its own inputs."""
    program = _recorded(x, torques, given)
    if not program.instructions and all(not hasattr(r, "argument") for r in program.results):
        zero = x.recorder.number(0)
        return [[[zero] * x.tree.nv for _ in program.results] for _ in by]
    count = x.tree.nv * len(by)
    duals = [_dual(x, a.name, given.get(a.name) or x.recorder.argument(a.name), by, count)
             for a in program.inputs]
    slopes = derivatives.along(program, x.recorder, duals)
    zero = x.recorder.number(0)
    return [[[zero if (s := y.slopes[k * x.tree.nv + j]) is None else s
              for j in range(x.tree.nv)] for y in slopes] for k in range(len(by))]


def _recorded(x: FunctionRecording, torques: Torques, given: dict[str, Sequence[Number]]
              ) -> Program:
    """The torques as a Program of q, v, a, t and p."""
    nv = x.tree.nv
    own = {a.name: a for a in x.recorder.inputs}
    inputs: list[Argument] = [a for a in own.values() if a.name in ("t", "p", "q", "v", "a")]
    inputs += [array(name, (nv,)) for name in given if name not in own]
    recorder = Recorder(inputs)
    with recorder.part("tau"):
        results = torques(FunctionRecording(x.scene, x.tree, x.names, recorder))
        return recorder.program("torques", [(array("tau", (nv,)), results)])


def _dual(x: FunctionRecording, name: str, numbers: Sequence[Number], by: Sequence[str], count: int
          ) -> list[Dual[Number]]:
    """An input's components with their derivatives along all directions."""
    if name not in by:
        return [Dual(n, (None,) * count) for n in numbers]
    nv, one = x.tree.nv, x.recorder.number(1)
    rows = coordinates.chart(x.motion(moving=False, accelerating=False)) if name == "q" else [
        [one if i == j else None for j in range(nv)] for i in range(nv)]
    before = by.index(name) * nv
    return [Dual(n, (*[None] * before, *row, *[None] * (count - before - nv)))
            for n, row in zip(numbers, rows, strict=True)]
