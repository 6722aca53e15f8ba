"""Floating trees: their first joint is free, and no external force acts on them except uniform
gravity.  Their motion as a whole is known at all times: momentum p(t) = p + m g t, constant angular
momentum about the centre of mass, and the centre of mass x(t) = x + p t/m + g t²/2."""

from collections.abc import Sequence
from dataclasses import dataclass

from coscrew_codegen.algebra.recording.numbers import (
    Number,
    Vector,
    add,
    angular,
    cross,
    linear,
    rotated,
    rotated_back,
    rotation,
    scaled,
    subtract,
    translation,
)
from coscrew_codegen.algebra.recording.recorder import Recorder, array
from coscrew_codegen.dynamics.algorithms import crba, energies
from coscrew_codegen.dynamics.algorithms.bodies import Rigid
from coscrew_codegen.dynamics.algorithms.linear_systems import Factors, factored
from coscrew_codegen.dynamics.algorithms.motion import Motion
from coscrew_codegen.dynamics.forces.applied_effects import AppliedEffects, alone
from coscrew_codegen.dynamics.forces.own_inertias import gravity, joint_inertias
from coscrew_codegen.dynamics.function_recording import FunctionRecording
from coscrew_codegen.scene.effect_quantities import count_of, places_of, states_of
from coscrew_codegen.scene.mechanism.tree import Tree
from coscrew_codegen.scene.scene import Applied, Scene


def floating(scene: Scene, tree: Tree, roots: Sequence[int]) -> tuple[int, ...]:
    """The first links of the floating trees; `roots` are all links with a free joint in the world.
    """
    tied = {root for applied in scene.effects for root in _tied(applied, tree)
            if not _idle(scene, tree, applied)}
    for number, link in enumerate(tree.links):
        if link.driver and _root(tree, number) != _root(tree, link.driver.link):
            tied |= {_root(tree, number), _root(tree, link.driver.link)}
    for loop in scene.model.loops:
        ends = {_root(tree, tree.link_and_body(body)[0]) for body in loop.bodies}
        tied |= ends if len(ends) > 1 else set()
    return tuple(root for root in roots if root not in tied)


def _tied(applied: Applied, tree: Tree) -> set[int]:
    """The trees on which an effect exerts an external force, by first link."""
    if applied.effect.body_force or applied.effect.body_inertia:
        return {_root(tree, tree.link_and_body(applied.on)[0])}
    if applied.effect.pair_force or applied.effect.bodies_force:
        ends = {_root(tree, tree.link_and_body(body)[0]) for body in applied.bodies}
        return ends if len(ends) > 1 else set()
    if applied.effect.joint_torque or applied.effect.joint_inertia:
        roots = {number for number, link in enumerate(tree.links)
                 if link.parent < 0 and link.joint.name == applied.on}
        return {number for number in roots if tree.links[number].joint.kind.floats}
    return set()


def _idle(scene: Scene, tree: Tree, applied: Applied) -> bool:
    """Returns whether the numbers of an effect make its forces and its inertia zero in every state.
    """
    recorder = Recorder([array("t", ()), array("p", (len(scene.parameters),)),
                         array("q", (tree.nq + count_of(states_of(scene)),)),
                         array("v", (tree.nv,))])
    motion = Motion(recorder, tree, [f"link{n}" for n in range(len(tree.links))],
                    gravity(scene, recorder), states=places_of(scene))
    only = alone(scene, applied)
    acting, own = AppliedEffects(only, motion).act(), joint_inertias(only, recorder, tree)
    numbers = [*(x for link in acting.forces for x in acting.force(link)),
               *(x for link in acting.torques for x in acting.torque(link)),
               *(x for inertias in acting.inertias.values() for y in inertias for x in y.entries),
               *own.values(), *(x.inertia for x in own.sums)]
    return all(x.is_zero for x in numbers)


def _root(tree: Tree, number: int) -> int:
    """The first link of a link's tree; -1 for the world."""
    while number >= 0 and tree.links[number].parent >= 0:
        number = tree.links[number].parent
    return number


@dataclass(frozen=True)
class _Whole:
    """A floating tree as one body, in its first link's frame."""

    rigid: Rigid
    com: Vector
    p: Vector  # linear momentum
    L: Vector  # angular momentum about the centre of mass


def _wholes(x: FunctionRecording, motion: Motion, roots: Sequence[int]) -> list[_Whole]:
    momenta, bodies = energies.momenta(x, motion), crba.composites(motion, x.rigids)
    results = []
    for root in roots:
        with motion.part(root, "L"):
            com = scaled(1 / bodies[root].m, bodies[root].h)  # folds 1/m if m is constant
            about_com = x.recorder.call("product_CoAdtinvc", com, momenta[root])
            results.append(_Whole(bodies[root], com, linear(about_com), angular(about_com)))
    return results


def momentum(x: FunctionRecording, roots: Sequence[int]) -> list[Number]:
    """(p; L; x) of each floating tree, by its first link (see `floating`), in the world's axes:
    momentum, angular momentum about the centre of mass, and the centre of mass."""
    motion = x.motion(accelerating=False)
    results: list[Number] = []
    for root, whole in zip(roots, _wholes(x, motion, roots), strict=True):
        with motion.part(root, "p"):
            R = rotation(motion.pose(root))
            results += [*rotated(R, whole.p), *rotated(R, whole.L), *_centre(motion, root, whole)]
    return results


def corrected(x: FunctionRecording, roots: Sequence[int]) -> tuple[list[Number], list[Number]]:
    """q and v with each floating base moved so that its tree has the centre of mass
    x + p t/m + g t²/2 and the momentum (p + m g t; L), from the input c = (p; L; x)."""
    motion = x.motion(accelerating=False)
    (t,), c, v = x.recorder.argument("t"), x.recorder.argument("c"), list(motion.v)
    q = list(x.recorder.argument("q"))
    for n, (root, whole) in enumerate(zip(roots, _wholes(x, motion, roots), strict=True)):
        link, (p, L, start) = x.tree.links[root], (
            tuple(c[9 * n + k:9 * n + k + 3]) for k in (0, 3, 6))
        with motion.part(root, "v"):
            R, m = rotation(motion.pose(root)), whole.rigid.m
            now = add(p, scaled(m * t, motion.gravity))
            faster = scaled(1 / m, subtract(rotated_back(R, now), whole.p))
            w = _about_com(whole).solve(subtract(rotated_back(R, L), whole.L))
            change = (*subtract(faster, cross(tuple(w), whole.com)), *w)
            v[link.v.start:link.v.stop] = add(v[link.v.start:link.v.stop], change)
        with motion.part(root, "q"):
            path = add(scaled(t / m, p), scaled(t * t / 2, motion.gravity))
            off = subtract(add(start, path), _centre(motion, root, whole))
            places = slice(link.q.start, link.q.start + 3)
            own = rotated_back(x.recorder.numbers(link.placement.R), off)
            q[places] = add(q[places], own)
    return q, v


def _centre(motion: Motion, root: int, whole: _Whole) -> Vector:
    """The centre of mass of a floating tree, in the world."""
    D = motion.pose(root)
    return add(translation(D), rotated(rotation(D), whole.com))


def _about_com(whole: _Whole) -> Factors:
    """The moments of inertia about the centre of mass, factored."""
    nine = whole.rigid.m.recorder.call("spatial_inertia_about_com", whole.rigid.numbers)
    return factored([nine[3 * i:3 * i + 3] for i in range(3)])
