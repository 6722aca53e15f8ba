"""Forward dynamics of a scene, explicit or linearly implicit.

A linearly implicit step solves (M + h D + h² K) a = tau - h K v, where D and K are how the effects'
forces fall with speeds and coordinates: on the diagonal where they act at joints, as point masses
h d where they resist the motion of a point, and as rows e^T of constraints that give way,
e^T v = l', where they act between two bodies: what moves both together must not feel them.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

from coscrew_codegen.dynamics import articulated, composite, inverse
from coscrew_codegen.dynamics.acting import Acting, Paired
from coscrew_codegen.dynamics.articulated import Articulated
from coscrew_codegen.dynamics.bodies import Rigid
from coscrew_codegen.dynamics.inverse import Wrench
from coscrew_codegen.dynamics.linear import factored
from coscrew_codegen.dynamics.motion import Motion
from coscrew_codegen.dynamics.numbers import Number, add, scaled, subtract
from coscrew_codegen.dynamics.tree import Link

_Solve = Callable[[Sequence[Number], Sequence[Wrench]], list[Number]]


@dataclass(frozen=True)
class _System:
    """What a step solves: the links' inertias, those of speeds alone, what slopes add to tau."""

    bodies: list[Rigid]
    own: list[Number]
    implied: list[Number]


def accelerations(motion: Motion, acting: Acting, rigids: Sequence[Rigid],
                  inertias: Mapping[str, Number], tau: Sequence[Number],
                  h: Number | None = None) -> list[Number]:
    """a with M a + bias = tau; with a step h linearly implicit in the effects' slopes."""
    system = _system(motion, acting, rigids, inertias, h)
    at_joints = [motion.zero[0]] * motion.tree.nv
    for number in sorted(acting.torques):
        with motion.recorder.part(f"{motion.names[number]}_own", motion.tree.links[number].name):
            inverse.gather(motion, number, [acting.torque(number)], at_joints)
    torques = [t - i + x for t, i, x in zip(tau, system.implied, at_joints, strict=True)]
    solve = _solver(motion, system)
    if h is not None:
        for number, pair in enumerate(acting.pairs):
            with motion.recorder.part(f"pair_{number}", "pairs of bodies"):
                solve, torques = _with_pair(motion, pair, h, solve, torques)
    return solve(torques, inverse.net_wrenches(motion, rigids, acting))


def _system(motion: Motion, acting: Acting, rigids: Sequence[Rigid],
            inertias: Mapping[str, Number], h: Number | None) -> _System:
    tree, zero = motion.tree, motion.zero[0]
    found = _System(list(rigids), [zero] * tree.nv, [zero] * tree.nv)
    for number, link in enumerate(tree.links):
        with motion.recorder.part(f"{motion.names[number]}_own", link.name):
            if link.joint.name in inertias:
                own = inertias[link.joint.name] * _multiplier(link)
                inverse.gather(motion, number, [own], found.own)
            if h is not None and number in acting.torques:
                stiff, v = acting.stiffness(number) * h, motion.speeds(number)[0]
                slope = (acting.damping(number) + stiff) * h
                inverse.gather(motion, number, [slope * _multiplier(link)], found.own)
                inverse.gather(motion, number, [stiff * v], found.implied)
            if h is not None:
                for damping, point in acting.resisting(number):
                    found.bodies[number] = _with_mass(found.bodies[number], h * damping, point)
    return found


def _solver(motion: Motion, system: _System) -> _Solve:
    """From torques, and wrenches the links need at a = 0, to a.  What depends on neither is issued
    once."""
    if not motion.tree.follows:
        bodies = [Articulated.of(body) for body in system.bodies]
        return lambda torques, wrenches: articulated.accelerations(
            motion, bodies, wrenches, torques, system.own)
    M = composite.mass_matrix(motion, system.bodies, {})
    for k, inertia in enumerate(system.own):
        M[k][k] = M[k][k] + inertia

    def solve(torques: Sequence[Number], wrenches: Sequence[Wrench]) -> list[Number]:
        bias = inverse.joint_torques(motion, inverse.transmitted(motion, wrenches), None, {})
        with motion.recorder.part("solution", "M a = tau"):
            return factored(M).solve(subtract(torques, bias))

    return solve


def _with_pair(motion: Motion, pair: Paired, h: Number, solve: _Solve,
               torques: Sequence[Number]) -> tuple[_Solve, list[Number]]:
    """Adds c e e^T to what `solve` inverts, c = h d + h² k, and -h k l' e to the torques.

    a = a' - w (c e·a')/(1 + c e·w), w = solve(e): Sherman and Morrison; nothing divides by zero."""
    still = [(motion.zero, motion.zero)] * len(motion.tree.links)
    wrenches = list(still)
    for link, wrench in pair.apart:
        if link >= 0:
            wrenches[link] = tuple(map(add, wrenches[link], wrench))
    e = inverse.joint_torques(motion, inverse.transmitted(motion, wrenches), None, {})
    w = solve(e, still)
    stiff = h * pair.line.stiffness
    c = h * (pair.line.damping + stiff)
    share = c / (1 + c * _product(e, w))

    def coupled(torques: Sequence[Number], wrenches: Sequence[Wrench]) -> list[Number]:
        a = solve(torques, wrenches)
        return list(subtract(a, scaled(share * _product(e, a), w)))

    return coupled, list(subtract(torques, scaled(stiff * pair.line.rate, e)))


def _product(a: Sequence[Number], b: Sequence[Number]) -> Number:
    total = a[0].like(0)
    for x, y in zip(a, b, strict=True):
        total = total + x * y
    return total


def _multiplier(link: Link) -> object:
    """A follower's multiplier once: `gather` supplies the second."""
    return link.driver.multiplier if link.driver else 1


def _with_mass(body: Rigid, mass: Number, point) -> Rigid:
    """The body with a point mass."""
    zero = mass.like(0)
    total = add(body.numbers, mass.recorder.call(
        "inertia_from_com", mass, point, [zero] * 9))
    return Rigid(total[0], tuple(total[1:4]), tuple(total[4:]))
