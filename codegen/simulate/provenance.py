"""Where recordings come from: scene, kernels, integrator, compiler, version; no hosts, no dates."""

import hashlib
from collections.abc import Iterator, Mapping
from dataclasses import fields, is_dataclass
from enum import Enum

from coscrew_codegen.report.machine import coscrew_version
from coscrew_codegen.scene.effect import Effect
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.simulate.plan import Plan, Trajectory
from coscrew_codegen.simulate.system import System
from coscrew_codegen.tiers import PLAIN

Provenance = tuple[tuple[str, str], ...]


def provenance(system: System, plan: Plan, trajectory: Trajectory, compiled: str) -> Provenance:
    """(what, its value), as files carry them; `compiled` is the compiler and its flags."""
    how = (f"rtol {plan.rtol:g}, atol {plan.atol:g}" if plan.adaptive else _steps(plan))
    parameters = ", ".join(f"{name} = {value:g}" for (name, _), value in
                           zip(system.functions.parameters, system.p))
    told = (("scene", system.scene.name), ("scene sha256", scene_hash(system.scene)),
            ("precision", system.precision.name), ("tier", PLAIN.name),
            ("integrator", f"{plan.integrator}, {how}"), ("compiler", compiled),
            ("parameters", parameters), ("coscrew", coscrew_version()),
            ("stopped", trajectory.stopped))
    return tuple((what, value) for what, value in told if value)


def _steps(plan: Plan) -> str:
    _, h = plan.steps(plan.every)
    if h == plan.step:
        return f"step {plan.step:g} s"
    return (f"step {h:g} s (at most {plan.step:g} s, and a part of "
            f"every = {plan.every:g} s)")


def scene_hash(scene: Scene) -> str:
    """SHA-256 of all that the scene and its model say, however the files were laid out."""
    return hashlib.sha256("\n".join(_told(scene)).encode()).hexdigest()


def _told(value: object) -> Iterator[str]:
    """The value in words, always the same: effects by name, mappings sorted, exact fractions."""
    if isinstance(value, Effect | Enum):
        yield f"{type(value).__name__} {value.name}"
    elif is_dataclass(value):
        yield type(value).__name__
        for field in fields(value):
            if field.compare:
                yield field.name
                yield from _told(getattr(value, field.name))
    elif isinstance(value, Mapping):
        for key in sorted(value):
            yield f"key {key}"
            yield from _told(value[key])
    elif isinstance(value, tuple | list):
        yield f"{len(value)} entries"
        for entry in value:
            yield from _told(entry)
    else:
        yield repr(value)
