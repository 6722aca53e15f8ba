"""Motion of coordinates: q ⊕ phi by exponentials, and the rate of phi for given velocities."""

from collections.abc import Sequence

from coscrew_codegen.algebra.recording.numbers import (
    Number,
    add,
    angular,
    cross,
    dot,
    linear,
    rotated,
    scaled,
    subtract,
)
from coscrew_codegen.algebra.recording.recorder import Recorder
from coscrew_codegen.dynamics.algorithms.motion import Motion
from coscrew_codegen.program.program import name_of
from coscrew_codegen.scene.mechanism.tree import Link, Tree


def neutral(tree: Tree) -> tuple[float, ...]:
    """q with every joint at zero, quaternions at (0, 0, 0, 1)."""
    return tuple(x for link in tree.links if link.driver is None for x in link.joint.kind.neutral)


def integrated(recorder: Recorder, tree: Tree, names: Sequence[str], q: Sequence[Number],
               phi: Sequence[Number]) -> list[Number]:
    """q ⊕ phi: q + phi, or as the joint's kind says; effects' states behind q stay."""
    results: list[Number] = []
    for name, link in zip(names, tree.links, strict=True):
        if link.driver:
            continue
        with recorder.part(name, "q", link.heading):
            own, step = q[link.q.start:link.q.stop], phi[link.v.start:link.v.stop]
            manifold = link.joint.kind.manifold
            results += manifold.integrated(own, step) if manifold else add(own, step)
    return [*results, *q[tree.nq:]]


def carried(recorder: Recorder, tree: Tree, names: Sequence[str], h: Number, q: Sequence[Number],
            v: Sequence[Number]) -> tuple[list[Number], list[Number]]:
    """q and v after h/2.  Of a free base, whose v = (R^T x'; ω), x' stays the same: it moves by
    h/2 x' and turns by h/2 ω, and v becomes (Exp(-h/2 ω) R^T x'; ω)."""
    with recorder.part("phi"):
        phi = scaled(h / 2, v)
    moved, speeds = integrated(recorder, tree, names, q, phi), list(v)
    for name, link in zip(names, tree.links, strict=True):
        if carries(link):
            at, along, turn = link.q.start, link.v.start, link.v.start + 3
            with recorder.part(name, "q", link.heading):
                R = recorder.call("mat3x3_from_quaternion", q[at + 3:link.q.stop])
                moved[at:at + 3] = add(q[at:at + 3], rotated(R, phi[along:turn]))
                speeds[along:turn] = recorder.call("rotate_qconjv", recorder.call(
                    "quaternion_exp", phi[turn:link.v.stop]), v[along:turn])
    return moved, speeds


def carries(link: Link) -> bool:
    """Returns whether it is a free base."""
    return link.parent < 0 and link.joint.kind.floats


def difference(recorder: Recorder, tree: Tree, names: Sequence[str], q1: Sequence[Number],
               q0: Sequence[Number]) -> list[Number]:
    """q1 ⊖ q0, phi with q0 ⊕ phi = q1: q1 - q0, or as the joint's kind says."""
    results: list[Number] = []
    for name, link in zip(names, tree.links, strict=True):
        if link.driver:
            continue
        with recorder.part(name, "phi", link.heading):
            own, start = q1[link.q.start:link.q.stop], q0[link.q.start:link.q.stop]
            manifold = link.joint.kind.manifold
            results += manifold.difference(own, start) if manifold else subtract(own, start)
    return results


def velocities(recorder: Recorder, tree: Tree, names: Sequence[str], q: Sequence[Number],
               rates: Sequence[Number]) -> list[Number]:
    """The velocities at which q changes at these rates; then the rates of effects' states."""
    results: list[Number] = []
    for name, link in zip(names, tree.links, strict=True):
        if link.driver:
            continue
        with recorder.part(name, "vq", link.heading):
            own, rate = q[link.q.start:link.q.stop], rates[link.q.start:link.q.stop]
            manifold = link.joint.kind.manifold
            results += manifold.velocities(own, rate) if manifold else rate
    return [*results, *rates[tree.nq:]]


def rates(motion: Motion, v: Sequence[Number]) -> list[Number]:
    """q' at these velocities; effects' states have the rates behind them, or are held."""
    results: list[Number] = []
    for number, link in enumerate(motion.tree.links):
        if link.driver:
            continue
        own, manifold = v[link.v.start:link.v.stop], link.joint.kind.manifold
        state = motion.state(number)
        results += manifold.rates(state, state.q, own) if manifold else own
    return [*results, *(v[motion.tree.nv:] or (motion.zero[0] for _ in motion.x))]


def chart(motion: Motion, states: bool = False) -> list[list[Number | None]]:
    """∂(q ⊕ φ)/∂φ at φ = 0, row by row: how each coordinate moves with each velocity; None where it
    does not, whatever q is, as the states of effects behind them.  With `states` these have columns
    of their own."""
    width = motion.tree.nv + (len(motion.x) if states else 0)
    rows: list[list[Number | None]] = []
    for number, link in enumerate(motion.tree.links):
        if link.driver:
            continue
        state, manifold = motion.state(number), link.joint.kind.manifold
        columns: list[Sequence[Number]] = []
        for k in range(len(link.v)):
            unit = motion.recorder.numbers([int(i == k) for i in range(len(link.v))])
            columns.append(manifold.rates(state, state.q, unit) if manifold else unit)
        for own in zip(*columns, strict=True):
            row: list[Number | None] = [None] * width
            row[link.v.start:link.v.stop] = [None if x.is_zero else x for x in own]
            rows.append(row)
    one = motion.recorder.number(1)
    return [*rows, *([one if motion.tree.nv + k == j else None for j in range(width)]
                     for k in range(len(motion.x)))]


def displacement_chart(motion: Motion) -> dict[Number, list[Number | None]]:
    """The derivatives by velocities of displacements D = [R | t] of joints with a manifold, by
    entry, as rows of the chart: for a row (r, t) of D and a screw (l; e) they are r × e and r·l,
    fewer operations than the chain rule through the quaternion takes.  Only of the rows of D that
    the recording has computed."""
    computed = {"", *(step.name for step in motion.recorder.issued(0))}
    rows: dict[Number, list[Number | None]] = {}
    for number, link in enumerate(motion.tree.links):
        if link.driver or not link.joint.kind.manifold:
            continue
        D, screws = motion.frame(number), motion.subspace(number)
        for r, t in ((D[k:k + 3], D[k + 3]) for k in (0, 4, 8)):
            if not computed.issuperset(name_of(x.operand) for x in r):
                continue
            by = [(*cross(r, angular(s)), dot(r, linear(s))) for s in screws]
            for entry, own in zip((*r, t), zip(*by, strict=True), strict=True):
                rows[entry] = [None] * (motion.tree.nv + len(motion.x))
                rows[entry][link.v.start:link.v.stop] = [None if x.is_zero else x for x in own]
    return rows


def chart_rate(recorder: Recorder, tree: Tree, names: Sequence[str]) -> list[Number]:
    """v + [phi, v]/2 + [phi, [phi, v]]/12: the inverse of the right Jacobian to third order."""
    v, phi = recorder.argument("v"), recorder.argument("phi")
    results: list[Number] = []
    for name, link in zip(names, tree.links, strict=True):
        if link.driver:
            continue
        with recorder.part(name, "v", link.heading):
            own, at = v[link.v.start:link.v.stop], phi[link.v.start:link.v.stop]
            if manifold := link.joint.kind.manifold:
                first = manifold.bracket(at, own)
                second = manifold.bracket(at, first)
                own = add(own, add(scaled(own[0].like(1) / 2, first),
                                   scaled(own[0].like(1) / 12, second)))
            results += own
    return results
