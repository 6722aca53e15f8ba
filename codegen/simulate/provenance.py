"""Provenance of recordings: scene, kernels, integrator, compiler, version; no hosts, no dates."""

import numpy as np

from coscrew_codegen import version
from coscrew_codegen.scene.content import content_hash
from coscrew_codegen.simulate.onward import END, end_of
from coscrew_codegen.simulate.plan import Plan, Trajectory
from coscrew_codegen.simulate.recording import Provenance
from coscrew_codegen.simulate.system import System
from coscrew_codegen.tiers import PLAIN


def provenance(system: System, plan: Plan, trajectory: Trajectory, compiled: str,
               start: str = "", controller: str = "", before: int = 0) -> Provenance:
    """Pairs (name, value) for recorded files; `compiled` is the compiler and its flags, `start` and
    `controller` are told if the scene does not give them.  `before`: see end_of."""
    how = (f"rtol {plan.rtol:g}, atol {plan.atol:g}" if plan.adaptive else _steps(plan))
    parameters = ", ".join(f"{name} = {_number(values)}" for (name, _), values in zip(
        system.functions.parameters, np.moveaxis(np.array(system.p), -1, 0), strict=True))
    told = (("scene", system.scene.name), ("scene sha256", content_hash(system.scene)),
            ("precision", system.precision.name), ("tier", PLAIN.name),
            ("integrator", f"{plan.integrator}, {how}"), ("compiler", compiled),
            ("parameters", parameters), ("start", start), ("controller", controller),
            ("coscrew", version.described()), ("stopped", trajectory.stopped),
            (END, _end(system, plan, trajectory, before)))
    return tuple((what, value) for what, value in told if value)


def started(t: float, q: np.ndarray, v: np.ndarray) -> str:
    """What `start` tells: the state, exactly; of a batch, that members differ."""
    if q.ndim > 1:
        return f"t = {t!r}, q and v by member"
    return f"t = {t!r}, q = {_row(q)}, v = {_row(v)}"


def _row(values: np.ndarray) -> str:
    return f"[{', '.join(repr(float(x)) for x in values)}]"


def _end(system: System, plan: Plan, trajectory: Trajectory, before: int) -> str:
    """The end, if a run can go on from it."""
    stopped = trajectory.stopped and not trajectory.interrupted
    if plan.adaptive or stopped or trajectory.q.ndim > 2:
        return ""
    return end_of(system, trajectory, before).told


def _number(values: np.ndarray) -> str:
    """The shortest decimals that read back the same; of a batch if its members have one value."""
    if values.size and (values == values.flat[0]).all():
        return repr(float(values.flat[0])).removesuffix(".0")
    return "by member"


def _steps(plan: Plan) -> str:
    _, h = plan.steps(plan.every)
    if h == plan.step:
        return f"step {plan.step:g} s"
    return (f"step {h:g} s (at most {plan.step:g} s, and a part of "
            f"every = {plan.every:g} s)")
