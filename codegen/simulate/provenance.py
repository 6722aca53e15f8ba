"""Provenance of recordings: scene, kernels, integrator, compiler, version; no hosts, no dates."""

import numpy as np

from coscrew_codegen import version
from coscrew_codegen.scene.content import content_hash
from coscrew_codegen.simulate.plan import Plan, Trajectory
from coscrew_codegen.simulate.recording import Provenance
from coscrew_codegen.simulate.system import System
from coscrew_codegen.tiers import PLAIN


def provenance(system: System, plan: Plan, trajectory: Trajectory, compiled: str) -> Provenance:
    """Pairs (name, value) for recorded files; `compiled` is the compiler and its flags."""
    how = (f"rtol {plan.rtol:g}, atol {plan.atol:g}" if plan.adaptive else _steps(plan))
    parameters = ", ".join(f"{name} = {_number(values)}" for (name, _), values in zip(
        system.functions.parameters, np.moveaxis(np.array(system.p), -1, 0), strict=True))
    told = (("scene", system.scene.name), ("scene sha256", content_hash(system.scene)),
            ("precision", system.precision.name), ("tier", PLAIN.name),
            ("integrator", f"{plan.integrator}, {how}"), ("compiler", compiled),
            ("parameters", parameters), ("coscrew", version.described()),
            ("stopped", trajectory.stopped))
    return tuple((what, value) for what, value in told if value)


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
