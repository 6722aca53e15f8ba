"""Derivatives of accelerations of closed loops, by the rule of implicit functions.

At the a and λ that solve tau_inverse(q, v, a) - E^T λ = tau and r(q, v, a) = E a + E' v = 0,

    M ∂a - E^T ∂λ = ∂tau - ∂tau_inverse + ∂(E^T λ),   E ∂a = -∂r,   ∂ of the right at fixed a and λ.

This is solved as the accelerations are: W ∂λ = -(∂r + E a₀), a₀ those of the open tree.  Rows that
repeat others make no difference, wherever they do so also near q."""

from collections.abc import Callable, Sequence

from coscrew_codegen.algebra.recording.numbers import Number, subtract
from coscrew_codegen.dynamics.algorithms.linear_systems import LeafFactors
from coscrew_codegen.dynamics.algorithms.motion import Motion
from coscrew_codegen.dynamics.forces import effect_derivatives
from coscrew_codegen.dynamics.function_recording import FunctionRecording
from coscrew_codegen.dynamics.loops import demands
from coscrew_codegen.dynamics.loops.multipliers import Compliance, ConstraintRows, Demand

Matrix = list[list[Number]]
OfInverse = Callable[[FunctionRecording, Sequence[Number]], tuple[Matrix, ...]]
_MULTIPLIERS = "multipliers"


def of_forward(x: FunctionRecording, motion: Motion, a: Sequence[Number], M: LeafFactors,
               of_inverse: OfInverse) -> tuple[Matrix, ...]:
    """∂a/∂q, ∂a/∂v and ∂a/∂tau, from the accelerations of the open tree."""
    demand = demands.exact(x, motion)
    rows, compliance = demand.rows, Compliance(demand.rows, M.solve)
    closed = demand.solved(a, compliance)
    dq, dv, _ = of_inverse(x, closed.a)
    by_q, by_v = effect_derivatives.differentiated(
        x, _of_loops, ("q", "v"), {"a": closed.a, _MULTIPLIERS: closed.multipliers})
    nv = x.tree.nv

    def solved(torques: Sequence[Number], rates: Sequence[Number]) -> list[Number]:
        demand = Demand(rows, list(rates))
        return demand.solved(M.solve(torques), compliance).a

    of_states = (_columns([solved(subtract(own[:nv], column), own[nv:]) for column, own in zip(
        zip(*open_tree, strict=True), zip(*loops, strict=True), strict=True)])
        for open_tree, loops in ((dq, by_q), (dv, by_v)))
    still = [x.recorder.number(0)] * len(rows.places)
    units = [x.recorder.numbers([int(i == k) for i in range(nv)]) for k in range(nv)]
    return (*of_states, _columns([solved(unit, still) for unit in units]))


def _of_loops(x: FunctionRecording) -> Sequence[Number]:
    """E^T λ, then r."""
    motion = x.motion(falling=False)
    rows = ConstraintRows.at(motion, x.scene.model)
    torques = demands.torques(rows, x.recorder.argument(_MULTIPLIERS))
    return [*torques, *rows.of(lambda closure: closure.rates)]


def _columns(columns: Sequence[Sequence[Number]]) -> Matrix:
    """The matrix with these columns."""
    return [list(row) for row in zip(*columns, strict=True)]
