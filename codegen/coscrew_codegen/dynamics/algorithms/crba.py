"""The mass matrix by composite rigid bodies (CRBA): the links beyond a joint move as one body.

A column holds the torques, at a joint and at all joints between it and the base, for a unit
acceleration of that joint.  Columns and rows of followers are added to those of their leaders.
"""

from collections.abc import Sequence
from fractions import Fraction

from coscrew_codegen.algebra.recording.numbers import Number, add
from coscrew_codegen.dynamics.algorithms.aba import Articulated
from coscrew_codegen.dynamics.algorithms.bodies import Rigid, rigid_of
from coscrew_codegen.dynamics.algorithms.motion import Motion
from coscrew_codegen.dynamics.algorithms.rnea import along
from coscrew_codegen.dynamics.forces.own_inertias import OwnInertias


def composites(motion: Motion, rigids: Sequence[Rigid]) -> list[Rigid]:
    """The inertia of each link and all beyond it, in its frame."""
    results = list(rigids)
    for number in reversed(range(len(results))):
        parent = motion.tree.links[number].parent
        if parent >= 0:
            with motion.part(number, "Cp"):
                moved = motion.recorder.call("spatial_inertia_transformed", motion.frame(number),
                                             results[number].numbers)
                _label(motion, "Cp", rigid_of(moved))
            with motion.part(parent, "C"):
                results[parent] = rigid_of(add(results[parent].numbers, moved))
                _label(motion, "C", results[parent])
    return results


def _added(motion: Motion, rigids: Sequence[Rigid]) -> dict[int, Articulated]:
    """The inertia that effects add to each link and all beyond it, where there is any."""
    results = {n: Articulated(x.added) for n, x in enumerate(rigids) if x.added}
    for number in reversed(range(len(rigids))) if results else ():
        parent = motion.tree.links[number].parent
        if number in results and parent >= 0:
            with motion.part(number, "Ap"):
                moved = results[number].transformed(motion.frame(number))
            with motion.part(parent, "A"):
                results[parent] = results[parent].plus(moved) if parent in results else moved
    return results


def _label(motion: Motion, symbol: str, body: Rigid) -> None:
    """Name mass, first and second moments."""
    for part, value in (("m", body.m), ("h", body.h), ("I", body.I)):
        motion.recorder.label(f"{symbol}{part}", value)


def mass_matrix(motion: Motion, rigids: Sequence[Rigid],
                inertias: OwnInertias) -> list[list[Number]]:
    """M; `inertias`, those of joints themselves, are added to its diagonal, and of sums to their
    rows."""
    tree, zero = motion.tree, motion.zero[0]
    M = [[zero] * tree.nv for _ in range(tree.nv)]
    bodies, added = composites(motion, rigids), _added(motion, rigids)
    for number, link in enumerate(tree.links):
        with motion.part(number, "M"):
            for freedom, screw in enumerate(motion.subspace(number)):
                column = motion.recorder.call("product_Bs", bodies[number].numbers, screw)
                if number in added:
                    column = add(column, added[number].times(screw))
                _enter(motion, number, freedom, column, M)
            if link.joint.name in inertias:
                for freedom in range(len(motion.subspace(number))):
                    own, factor = _speed(motion, number, freedom)
                    M[own][own] = M[own][own] + inertias[link.joint.name] * (factor * factor)
    return inertias.enter(
        [[M[max(i, j)][min(i, j)] for j in range(tree.nv)] for i in range(tree.nv)])


def _enter(motion: Motion, number: int, freedom: int, column: Sequence[Number],
           M: list[list[Number]]) -> None:
    """Enter the torques, at its joint and those before it, for a unit acceleration of a freedom."""
    wrench, at = tuple(column), number
    j, factor_j = _speed(motion, number, freedom)
    while at >= 0:
        parts = along(motion, at, wrench)
        for k in range(freedom + 1 if at == number else len(parts)):
            i, factor_i = _speed(motion, at, k)
            value = parts[k] * (factor_i * factor_j)
            twice = i == j and (at, k) != (number, freedom)
            row, place = max(i, j), min(i, j)
            M[row][place] = M[row][place] + (value * 2 if twice else value)
        if motion.tree.links[at].parent >= 0:
            with motion.part(number, "F"):
                wrench = motion.recorder.call("product_CoAdc", motion.frame(at), wrench)
        at = motion.tree.links[at].parent


def _speed(motion: Motion, number: int, freedom: int) -> tuple[int, Fraction | int]:
    """(index of the velocity that a freedom depends on, its multiplier)."""
    link = motion.tree.links[number]
    if link.driver:
        return motion.tree.links[link.driver.link].v.start, link.driver.multiplier
    return link.v.start + freedom, 1
