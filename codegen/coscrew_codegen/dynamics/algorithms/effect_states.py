"""Motion of the states x of effects, the end of q, apart from the kick of the default integrator.
"""

from collections.abc import Sequence

from coscrew_codegen.algebra.recording.numbers import Number, add, scaled
from coscrew_codegen.dynamics.forces.applied_effects import AppliedEffects
from coscrew_codegen.dynamics.function_recording import FunctionRecording

Numbers = Sequence[Number]


def acting(x: FunctionRecording, q: Numbers | None = None) -> AppliedEffects:
    """The effects at the function's q and v, or at other states of effects."""
    v = x.recorder.argument("v")
    motion = x.motion() if q is None else x.motion(at=(q, v))
    return AppliedEffects(x.scene, motion).act()


def rates(x: FunctionRecording) -> list[Numbers]:
    """x', and q with x within their bounds."""
    states = acting(x).states
    with x.recorder.part("x", heading="states of effects"):
        return [[y for own in states for y in own.rates],
                [*x.recorder.argument("q")[:x.tree.nq], *(y for own in states for y in own.kept)]]


def moved(x: FunctionRecording) -> list[Number]:
    """q with x after h at the velocities v, and within their bounds."""
    (h,), q, nq = x.recorder.argument("h"), x.recorder.argument("q"), x.tree.nq
    states = acting(x).states
    with x.recorder.part("x", heading="states of effects"):
        later = add(tuple(q[nq:]), scaled(h, [y for own in states for y in own.rates]))
    return [*q[:nq], *(y for own in acting(x, [*q[:nq], *later]).states for y in own.kept)]


def switches(x: FunctionRecording) -> list[Number]:
    """The numbers that change their signs where another part of an effect's law begins."""
    return [y for own in acting(x).states for y in own.law.switches]
