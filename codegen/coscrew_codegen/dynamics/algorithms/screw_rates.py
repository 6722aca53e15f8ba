"""Rates of a joint's screws in its link's frame."""

from coscrew_codegen.algebra.recording import derivatives
from coscrew_codegen.algebra.recording.numbers import Number
from coscrew_codegen.algebra.recording.recorder import Recorder, array
from coscrew_codegen.dynamics.algorithms.motion import Motion, Twist
from coscrew_codegen.dynamics.algorithms.recorded_joint import RecordedJoint
from coscrew_codegen.program.differentiate import Dual


def subspace_rates(motion: Motion, link: int) -> list[Twist]:
    """S' of the link's joint, a screw for each freedom: zero unless S depends on q."""
    screws, joint = motion.subspace(link), motion.tree.links[link].joint
    zero = motion.zero[0]
    if joint.kind.subspace_rate is None:
        return [(zero,) * 6] * len(screws)
    recorder = Recorder([array("q", (joint.kind.nq,))])
    state = RecordedJoint(tuple(map(recorder.numbers, joint.directions)),
                          recorder.argument("q"), recorder)
    own = [x for screw in joint.kind.subspace(state) for x in screw]
    program = recorder.program("screws", [(array("S", (len(screws), 6)), own)])
    results = derivatives.along(program, motion.recorder, [
        [Dual(q, (rate,)) for q, rate in zip(motion.coordinates(link), _rates(motion, link),
                                             strict=True)]])
    slopes = [zero if x.slopes[0] is None else x.slopes[0] for x in results]
    return [tuple(slopes[6 * k:6 * k + 6]) for k in range(len(screws))]


def _rates(motion: Motion, link: int) -> tuple[Number, ...]:
    """q' of the link's joint."""
    manifold, v = motion.tree.links[link].joint.kind.manifold, motion.speeds(link)
    state = motion.state(link)
    return tuple(manifold.rates(state, state.q, v)) if manifold else v
