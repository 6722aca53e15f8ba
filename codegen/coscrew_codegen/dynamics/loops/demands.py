"""Demands of closed loops on accelerations, and the corrections of states that have left them.

Only for scenes with loops."""

from collections.abc import Sequence

from coscrew_codegen.algebra.recording.numbers import Number, add, equal, negative, scaled, where
from coscrew_codegen.dynamics.algorithms import coordinates, forward
from coscrew_codegen.dynamics.algorithms.motion import Motion
from coscrew_codegen.dynamics.algorithms.rnea import Wrench
from coscrew_codegen.dynamics.function_recording import FunctionRecording
from coscrew_codegen.dynamics.loops.closures import Closure
from coscrew_codegen.dynamics.loops.multipliers import Compliance, ConstraintRows, Demand


def exact(x: FunctionRecording, motion: Motion) -> Demand:
    """E a = -E' v: the rate of E v is zero."""
    rows = ConstraintRows.at(motion, x.scene.model)
    return Demand(rows, rows.of(lambda closure: closure.rates))


def reflection(x: FunctionRecording, motion: Motion, h: Number) -> Demand:
    """E (v0 + v1) = 0 with v1 = v0 + h a: of second order, as E v1 = 0 is not."""
    return _of_step(x, motion, h, 2)


def stop(x: FunctionRecording, motion: Motion, h: Number) -> Demand:
    """E v1 = 0 with v1 = v0 + h a."""
    return _of_step(x, motion, h, 1)


def _of_step(x: FunctionRecording, motion: Motion, h: Number, factor: int) -> Demand:
    rows = ConstraintRows.at(motion, x.scene.model)
    rate = factor / where(equal(h, 0), 1, h)  # a step of 0 moves nothing, however it accelerates
    return Demand(rows, list(scaled(rate, rows.along(motion.v))))


def projected(x: FunctionRecording) -> tuple[list[Number], list[Number]]:
    """q and v moved onto the closures by impulses along the rows, one Newton step for q."""
    motion = x.motion(accelerating=False)
    rows = ConstraintRows.at(motion, x.scene.model)
    W = Compliance(rows, forward.inverse(motion, x.rigids, x.inertias))
    phi = W.solve(negative(rows.of(lambda closure: closure.phi)))
    still = x.recorder.numbers([0] * x.tree.nv)
    q = coordinates.integrated(x.recorder, x.tree, x.names, x.recorder.argument("q"),
                               W.changed(still, phi))
    return q, W.changed(motion.v, W.solve(negative(rows.along(motion.v))))


def wrench(rows: ConstraintRows, multipliers: Sequence[Number], loop: str) -> list[Number]:
    """Σ H̄ λ of one loop: (force; moment) on its first body, in the body's frame, at the loop's
    point."""
    closure = next(x for x in rows.closures if x.loop.name == loop)
    total = closure.total(closure.exerted, _of(rows, multipliers, closure))
    with closure.part("f"):
        return list(closure.at_point(total))


def wrenches(rows: ConstraintRows, multipliers: Sequence[Number]) -> dict[int, Wrench]:
    """The sums of the wrenches that closures exert on links."""
    results: dict[int, Wrench] = {}
    for closure in rows.closures:
        for link, own in closure.on_links(_of(rows, multipliers, closure)):
            results[link] = add(results[link], own) if link in results else own
    return results


def torques(rows: ConstraintRows, multipliers: Sequence[Number]) -> list[Number]:
    """E^T λ."""
    total = [multipliers[0].like(0)] * rows.closures[0].motion.tree.nv
    for closure in rows.closures:
        own = closure.holding(_of(rows, multipliers, closure))
        with closure.part("f"):
            total = list(add(total, own))
    return total


def _of(rows: ConstraintRows, multipliers: Sequence[Number], closure: Closure
        ) -> dict[int, Number]:
    """The multipliers of a closure, by row."""
    return {k: x for (n, k), x in zip(rows.places, multipliers, strict=True)
            if rows.closures[n] is closure}
