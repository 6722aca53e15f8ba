"""Rows of contacts between bodies in an implicit step: terms m e e^T of its matrix, all at once.

With the rows E and S = √m, the accelerations a' without them change to

    a = a' - M⁻¹ E^T S (1 + S W S)⁻¹ S E a',   W = E M⁻¹ E^T,

by Woodbury's formula: never singular, and an open contact, m = 0, changes nothing.  Rows of trees
that do not touch each other leave zeros in W, which cost nothing."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from coscrew_codegen.algebra.recording.numbers import Number, Vector, less, sqrt, where
from coscrew_codegen.dynamics.algorithms.aba import Joint
from coscrew_codegen.dynamics.algorithms.linear_systems import factored, product
from coscrew_codegen.dynamics.algorithms.rnea import Wrench
from coscrew_codegen.scene.effect import Slopes

Weights = Callable[..., tuple[Number, Number]]
"""(damping, stiffness, damping over the inertia that it acts on, in 1/s, and for forces on bodies
also stiffness over it, in 1/s²) -> (m, c)."""
Solve = Callable[[Joint, Sequence[Wrench]], list[Number]]


@dataclass(frozen=True)
class SoftRow:
    """A direction of a contact: e^T v is the rate along it, with these slopes of the force."""

    e: list[Number]
    slopes: Slopes
    rate: Number  # at the initial velocities of the step
    faster: Number | None  # rate now less that; None if it is the same


def with_soft_rows(rows: Sequence[SoftRow], weights: Weights, solve: Solve, joint: Joint,
                   still: Sequence[Wrench]) -> tuple[Solve, Joint]:
    """`solve` for the matrix plus Σ m e e^T, and `joint` with the torques d (rate - initial rate) -
    c rate of each row added."""
    def column(e: Sequence[Number]) -> list[Number]:
        return solve(lambda k, inertia: (e[k], joint(k, inertia)[1]), still)

    columns = [column(row.e) for row in rows]
    W = [[product(row.e, w) for w in columns[:i + 1]] for i, row in enumerate(rows)]
    roots: list[Number] = []
    added = [rows[0].e[0].like(0)] * len(rows[0].e)
    for i, row in enumerate(rows):
        d, k = row.slopes.damping, row.slopes.stiffness
        mass, c = weights(d, k, d * W[i][i], k * W[i][i])
        roots.append(sqrt(mass))
        push = -(c * row.rate) if row.faster is None else d * row.faster - c * row.rate
        added = [x + push * e for x, e in zip(added, row.e, strict=True)]
    factors = factored([[(1 if i == j else 0) + roots[i] * W[i][j] * roots[j]
                         for j in range(i + 1)] for i in range(len(rows))])

    def coupled(joint: Joint, wrenches: Sequence[Wrench]) -> list[Number]:
        a = solve(joint, wrenches)
        x = factors.solve([root * product(row.e, a)
                           for root, row in zip(roots, rows, strict=True)])
        for w, root, y in zip(columns, roots, x, strict=True):
            a = [z - c * (root * y) for z, c in zip(a, w, strict=True)]
        return a

    def joint_with_rows(k: int, inertia: Number) -> tuple[Number, Number]:
        torque, own = joint(k, inertia)
        return torque + added[k], own

    return coupled, joint_with_rows


def axes_about(n: Vector) -> tuple[Vector, Vector, Vector]:
    """n and two directions across it, all of length 1 (Duff et al., Building an orthonormal basis,
    revisited, 2017): without a pole."""
    x, y, z = n
    sign = where(less(z, 0), -1, z.like(1))
    a = -1 / (sign + z)
    b = x * y * a
    return n, (1 + sign * (x * x * a), sign * b, -(sign * x)), (b, sign + y * y * a, -y)
