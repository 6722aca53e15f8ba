"""Motion of coordinates: q ⊕ phi by exponentials, and the rate of phi for given velocities."""

from collections.abc import Sequence

from coscrew_codegen.algebra.recording.numbers import Number, add, cross, rotated, scaled, sqrt
from coscrew_codegen.algebra.recording.recorder import Recorder
from coscrew_codegen.scene.mechanism.model import Kind
from coscrew_codegen.scene.mechanism.tree import Tree


def neutral(tree: Tree) -> tuple[float, ...]:
    """q with every joint at zero, quaternions at (0, 0, 0, 1)."""
    results: list[float] = []
    for link in tree.links:
        if link.driver is None:
            turned = {Kind.FREE: 6, Kind.SPHERICAL: 3}.get(link.joint.kind)
            results += [float(i == turned) for i in range(link.joint.kind.nq)]
    return tuple(results)


def integrated(recorder: Recorder, tree: Tree, names: Sequence[str], q: Sequence[Number],
               phi: Sequence[Number]) -> list[Number]:
    """q ⊕ phi: q + phi; quaternions times exp(phi/2), free joints moved by the screw motion phi."""
    results: list[Number] = []
    for name, link in zip(names, tree.links, strict=True):
        if link.driver:
            continue
        with recorder.part(name, "q", link.heading):
            own, step = q[link.q.start:link.q.stop], phi[link.v.start:link.v.stop]
            if link.joint.kind is Kind.FREE:
                exponential = recorder.call("SE3_exp", step)
                R = recorder.call("mat3x3_from_quaternion", own[3:])
                results += add(own[:3], rotated(R, exponential[3::4]))
                own, step = own[3:], step[3:]
            if len(own) == 4:
                results += _turned(recorder, own, step)
            else:
                results += add(own, step)
    return results


def _turned(recorder: Recorder, q: Sequence[Number], step: Sequence[Number]) -> tuple[Number, ...]:
    """q exp(step/2) / |q exp(step/2)|: of norm 1 to rounding for any q whose square neither over-
    nor underflows.  So rounding errors do not add up, and a wrong norm does not last."""
    turned = recorder.call("quaternion_product_qq", q, recorder.call("quaternion_exp", step))
    (square,) = recorder.call("dot_qq", turned, turned)
    return scaled(1 / sqrt(square), turned)


def chart_rate(recorder: Recorder, tree: Tree, names: Sequence[str]) -> list[Number]:
    """v + [phi, v]/2 + [phi, [phi, v]]/12: the inverse of the right Jacobian to third order."""
    v, phi = recorder.argument("v"), recorder.argument("phi")
    results: list[Number] = []
    for name, link in zip(names, tree.links, strict=True):
        if link.driver:
            continue
        with recorder.part(name, "v", link.heading):
            own, at = v[link.v.start:link.v.stop], phi[link.v.start:link.v.stop]
            if link.joint.kind is Kind.SPHERICAL:
                first = cross(at, own)
                own = add(own, add(scaled(own[0].like(1) / 2, first),
                                   scaled(own[0].like(1) / 12, cross(at, first))))
            if link.joint.kind is Kind.FREE:
                first = recorder.call("cross_ss", at, own)
                second = recorder.call("cross_ss", at, first)
                own = add(own, add(scaled(own[0].like(1) / 2, first),
                                   scaled(own[0].like(1) / 12, second)))
            results += own
    return results
