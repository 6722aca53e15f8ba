"""Gradients of the kinetic and the potential energy, along velocities: of q ⊕ φ at φ = 0.

With constant screws s, the momentum p of all beyond a joint and its parent's twist V there,

    ∂T/∂q_j = p·(V × s_j),   ∂T/∂v_j = p·s_j

Other joints' kinetic energy, and the potential energy of effects, are differentiated as Programs.
"""

from collections.abc import Callable, Sequence

from coscrew_codegen.algebra.recording import derivatives
from coscrew_codegen.algebra.recording.numbers import Number
from coscrew_codegen.algebra.recording.recorder import Recorder, array
from coscrew_codegen.dynamics.algorithms import coordinates, energies, rnea, rnea_derivatives
from coscrew_codegen.dynamics.algorithms.motion import Motion
from coscrew_codegen.dynamics.forces.applied_effects import AppliedEffects
from coscrew_codegen.dynamics.function_recording import FunctionRecording
from coscrew_codegen.program.values.quantity import Argument

Vector = list[Number]
Energy = Callable[[FunctionRecording, Motion], Number]


def of_kinetic(x: FunctionRecording, motion: Motion) -> tuple[Vector, Vector]:
    """∂T/∂q and ∂T/∂v = M v."""
    momenta = energies.momenta(x, motion, added=True)
    dq, dv = ([motion.zero[0]] * x.tree.nv for _ in range(2))
    for number, link in enumerate(x.tree.links):
        p = momenta[number]
        with motion.part(number, "dT"):
            along = list(rnea.along(motion, number, p))
            if link.joint.name in x.inertias:
                for k, v in enumerate(motion.speeds(number)):
                    along[k] = along[k] + x.inertias[link.joint.name] * v
            rnea.gather(motion, number, along, dv)
            if link.parent >= 0:
                rnea.gather(motion, number, _turning(motion, number, p), dq)
    dv = x.inertias.with_sums(dv, motion.v)
    if not rnea_derivatives.constant_screws(motion):
        dq = _gradient(x, energies.kinetic)
    return dq, dv


def _turning(motion: Motion, number: int, p: rnea.Wrench) -> list[Number]:
    """p·(V × s) of each freedom."""
    call = motion.recorder.call
    V = call("product_Adinvs", motion.frame(number), motion.twist(motion.tree.links[number].parent))
    return [call("dot_cs", p, call("cross_ss", V, s))[0] for s in motion.subspace(number)]


def of_potential(x: FunctionRecording, motion: Motion) -> Vector:
    """∂V/∂q: the torques that hold the model against gravity and the forces of effects that have a
    potential energy."""
    holding = rnea.holding_torques(motion)
    if not x.scene.effects:
        return holding
    own = _gradient(x, lambda y, moving: AppliedEffects(y.scene, moving).act().potential())
    return [a + b for a, b in zip(holding, own, strict=True)]


def _gradient(x: FunctionRecording, energy: Energy) -> Vector:
    """∂/∂q of an energy, by the adjoint of its Program."""
    recorder = Recorder(x.recorder.inputs)
    with recorder.part("energy"):
        inner = FunctionRecording(x.scene, x.tree, x.names, recorder)
        program = recorder.program(
            "energy", [(array("e", ()), [energy(inner, inner.motion())])])
    given: list[Sequence[Number]] = [x.recorder.argument(a.name) for a in program.inputs]
    results = x.recorder.replay(derivatives.adjoint(program), *given, (x.recorder.number(1),))
    first = 1 + sum(a.quantity.size for a in program.inputs[:_place(program.inputs)])
    rows = coordinates.chart(x.motion())
    slopes = results[first:first + len(rows)]
    total = [x.recorder.number(0)] * x.tree.nv
    for slope, row in zip(slopes, rows, strict=True):
        total = [y if z is None else y + slope * z for y, z in zip(total, row, strict=True)]
    return total


def _place(inputs: Sequence[Argument]) -> int:
    """The place of q among the inputs."""
    return next(i for i, a in enumerate(inputs) if a.name == "q")
