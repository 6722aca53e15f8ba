"""Provenance of recordings: everything needed to repeat the run, and the software that made it; no
hosts, no dates."""

import json
from importlib.metadata import version as version_of

import numpy as np

from coscrew_codegen.accuracy.tiers import PLAIN
from coscrew_codegen.backends import version
from coscrew_codegen.simulation.checkpoint import END, START, Checkpoint, end_of, of_run
from coscrew_codegen.simulation.plan import Plan, Trajectory
from coscrew_codegen.simulation.recordings.recording import Provenance
from coscrew_codegen.simulation.system import System

ASKED = "run"
"""Name in provenance of the settings of a run, as JSON: arguments of `run`."""


def provenance(system: System, plan: Plan, trajectory: Trajectory, compiled: str, start: Checkpoint,
               record: tuple[str, ...], controller: str = "") -> Provenance:
    """Pairs (name, value) for recorded files; `compiled` is the compiler and its flags."""
    parameters = ", ".join(f"{name} = {_number(values)}" for (name, _), values in zip(
        system.functions.parameters, np.moveaxis(np.array(system.p), -1, 0), strict=True))
    settings = {"until": plan.until, "step": plan.step, "integrator": plan.integrator,
                "every": plan.every, "record": list(record)}
    entries = (("scene", system.scene.name), ("scene sha256", of_run(system)[1]),
               ("precision", system.precision.name), ("tier", PLAIN.name),
               ("integrator", f"{plan.integrator}, {_how(plan)}"), ("compiler", compiled),
               ("parameters", parameters), (ASKED, json.dumps(settings)), (START, start.as_json),
               ("controller", controller), ("coscrew", version.described()),
               ("stopped", trajectory.stopped), (END, _end(system, plan, trajectory, start)))
    return tuple((what, value) for what, value in entries if value)


def _end(system: System, plan: Plan, trajectory: Trajectory, start: Checkpoint) -> str:
    """The end of the run, if another can continue from it."""
    stopped = trajectory.stopped and not trajectory.interrupted
    if plan.adaptive or stopped or trajectory.q.ndim > 2:
        return ""
    return end_of(system, trajectory, start).as_json


def _number(values: np.ndarray) -> str:
    """The shortest decimals that read back the same; for a batch only if all members have one
    value."""
    if values.size and (values == values.flat[0]).all():
        return repr(float(values.flat[0])).removesuffix(".0")
    return "by member"


def _how(plan: Plan) -> str:
    """States the length of the steps, or their tolerances."""
    if plan.adaptive:
        return f"rtol {plan.rtol:g}, atol {plan.atol:g}, SciPy {version_of('scipy')}"
    _, h = plan.steps(plan.every)
    if h == plan.step:
        return f"step {plan.step:g} s"
    return (f"step {h:g} s (at most {plan.step:g} s, and a part of "
            f"every = {plan.every:g} s)")
