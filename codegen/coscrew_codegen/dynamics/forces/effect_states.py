"""Motion of the states x of effects, the end of q, apart from the kick of the default integrator.
"""

from collections.abc import Sequence

from coscrew_codegen.algebra.recording.numbers import Number, Vector, add, scaled
from coscrew_codegen.dynamics.algorithms import kicks
from coscrew_codegen.dynamics.forces.applied_effects import AppliedEffects
from coscrew_codegen.dynamics.forces.moving_states import MovingStates
from coscrew_codegen.dynamics.forces.rotors import eliminated
from coscrew_codegen.dynamics.function_recording import FunctionRecording
from coscrew_codegen.scene.effect import Torque, required

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
    """q with x after h at the velocities v, and within their bounds.

    A rotor moves as in an implicit step, in which its joint has reached v already."""
    (h,), q, nq = x.recorder.argument("h"), x.recorder.argument("q"), x.tree.nq
    states = acting(x).states
    with x.recorder.part("x", heading="states of effects"):
        later = [y for own in states for y in _after(own, h)]
    return [*q[:nq], *(y for own in acting(x, [*q[:nq], *later]).states for y in own.kept)]


def _after(own: MovingStates, h: Number) -> Vector:
    """The states of an effect after h."""
    if own.lagging:
        return own.followed(h)
    if own.rotor:
        turned = eliminated(own.rotor, own.rotor, kicks.end_weights(h))
        speed = own.x[1] + h * turned.acceleration(h.like(0))
        return own.x[0] + h * speed, speed
    return add(own.x, scaled(h, own.rates))


def bristles(x: FunctionRecording) -> list[Numbers]:
    """The energy that bristles store, and the power of the effects that have them, without that of
    their potential energies."""
    stored, power = x.recorder.number(0), x.recorder.number(0)
    for law in (own.law for own in acting(x).states):
        if law.stored is not None:
            stored = stored + law.stored
            power = power + (required(law.torque) * law.rates[0] if isinstance(law, Torque) else
                             required(law.power))
    return [[stored], [power]]


def switches(x: FunctionRecording) -> list[Number]:
    """The numbers that change their signs where another part of an effect's law begins."""
    return [y for own in acting(x).states for y in own.law.switches]
