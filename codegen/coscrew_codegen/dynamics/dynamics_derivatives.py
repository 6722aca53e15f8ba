"""Derivatives of inverse and of forward dynamics.

Those of rigid bodies come from a recursion, where each joint's screws are constants in its link's
frame and no effect adds inertia, and those of effects, which are added, from their torques'
Program.  Forward dynamics is not differentiated: with a at these torques,

    ∂a/∂q = -M⁻¹ ∂tau/∂q,   ∂a/∂v = -M⁻¹ ∂tau/∂v,   ∂a/∂tau = M⁻¹,   ∂tau of inverse dynamics at a.

With closed loops, at these a and λ, `closed_derivatives` adds what the rows change.
"""

from collections.abc import Sequence

from coscrew_codegen.algebra.recording.numbers import Number, add, subtract
from coscrew_codegen.dynamics.algorithms import crba, rnea_derivatives
from coscrew_codegen.dynamics.algorithms.linear_systems import factored_from_leaves
from coscrew_codegen.dynamics.forces import effect_derivatives
from coscrew_codegen.dynamics.forces.applied_effects import AppliedEffects
from coscrew_codegen.dynamics.function_recording import FunctionRecording
from coscrew_codegen.dynamics.loops import closed_derivatives

Matrix = list[list[Number]]


def of_inverse(x: FunctionRecording, a: Sequence[Number] | None = None) -> tuple[Matrix, ...]:
    """∂tau/∂q, ∂tau/∂v and ∂tau/∂a = M, at the function's accelerations or at `a`."""
    given = {"a": a} if a else {}
    motion = x.motion(a=a)
    if not rnea_derivatives.constant_screws(motion) or any(r.added for r in x.rigids):
        return tuple(effect_derivatives.differentiated(
            x, effect_derivatives.of_all, ("q", "v", "a"), given))
    rigid = rnea_derivatives.derivatives(motion, x.rigids, x.inertias)
    if not _forces(x):
        return rigid.dq, rigid.dv, rigid.M
    dq, dv = effect_derivatives.differentiated(x, effect_derivatives.of_effects, ("q", "v"), {})
    return _sum(rigid.dq, dq), _sum(rigid.dv, dv), rigid.M


def of_forward(x: FunctionRecording) -> tuple[Matrix, ...]:
    """∂a/∂q, ∂a/∂v and ∂a/∂tau = M⁻¹."""
    motion = x.motion(accelerating=False)
    bias = x.torques(motion, AppliedEffects(x.scene, motion).act())
    M = factored_from_leaves(crba.mass_matrix(motion, x.rigids, x.inertias))
    a = M.solve(subtract(x.tau, bias))
    if x.scene.model.loops:
        return closed_derivatives.of_forward(x, motion, a, M, of_inverse)
    dq, dv, mass = of_inverse(x, a)
    M = factored_from_leaves(mass)
    solutions = M.solve_columns({f"{n}_of_{name}": column for name, A in (("dq", dq), ("dv", dv))
                                 for n, column in enumerate(zip(*A, strict=True))})
    return _rows(solutions[:len(dq)]), _rows(solutions[len(dq):]), M.inverse()


def _forces(x: FunctionRecording) -> bool:
    """True if an effect besides gravity acts, or joints' own inertias take torques at a = 0."""
    curved = {y.name for y in x.scene.model.joints
              if y.kind.manifold and y.kind.manifold.inertial}
    return any(e.effect.joint_torque or e.effect.body_force or e.effect.pair_force
               or e.effect.joint_inertia and e.on in curved for e in x.scene.effects)


def _sum(A: Matrix, B: Matrix) -> Matrix:
    return [list(add(a, b)) for a, b in zip(A, B, strict=True)]


def _rows(columns: Sequence[Sequence[Number]]) -> Matrix:
    """The rows of a matrix with these columns."""
    return [list(row) for row in zip(*columns, strict=True)]
