"""Scene: a model, the effects it calls for, and what to do with it.  Frozen data, no arithmetic."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction

from coscrew_codegen.formats import BY_NAME, DOUBLE
from coscrew_codegen.integrators import DEFAULT
from coscrew_codegen.scene.effect import Effect
from coscrew_codegen.scene.formulas import Formula
from coscrew_codegen.scene.model import Model, Parameter, Scalar

Setting = Scalar | tuple[Scalar | Formula, ...] | tuple[str, str] | Formula | str | None


@dataclass(frozen=True)
class Applied:
    """An effect where it acts: on a joint, on a body, or under a label of its own (a spring between
    two bodies); gravity and other effects on everything act on "".  `values` has an entry for each
    of the effect's parameters, and of two bodies "bodies", their names.  A label tells several of
    one effect on one body apart."""

    effect: Effect
    on: str
    values: Mapping[str, Setting]
    label: str = ""

    @property
    def name(self) -> str:
        """As in `runtime`: viscous.elbow, wrench.push, gravity."""
        return ".".join(part for part in (self.effect.name, self.label or self.on) if part)


@dataclass(frozen=True)
class Expectation:
    """What a run must reach: |quantity(at) - value| <= rtol |value| + atol."""

    quantity: str  # "q.elbow", "energy", "reaction.elbow.2": as in `record`, one component
    at: float
    value: float
    rtol: float
    atol: float


@dataclass(frozen=True)
class Run:
    """How to integrate: `step` is of the emitted integrators, the tolerances of SciPy's."""

    duration: float = 1.0
    integrator: str = DEFAULT
    step: float = 1e-3
    rtol: float = 1e-9
    atol: float = 1e-9


@dataclass(frozen=True)
class Scene:
    """All that a scene file says."""

    name: str  # a C and Python identifier
    model: Model
    effects: tuple[Applied, ...] = ()
    parameters: tuple[Parameter, ...] = ()  # what stays an argument, in the order of `runtime`
    precision: str = DOUBLE.name  # of runs: double, single, both
    precisions: tuple[str, ...] = tuple(BY_NAME)  # in which it is generated
    implausible: str = "error"  # or warn: bodies that cannot exist are let through
    start_q: Mapping[str, tuple[float, ...]] = field(default_factory=dict)  # by joint
    start_v: Mapping[str, tuple[float, ...]] = field(default_factory=dict)
    record: tuple[str, ...] = ("q", "v")
    every: float = 0.01
    run: Run = Run()
    expectations: tuple[Expectation, ...] = ()
    functions: tuple[str, ...] = ()  # asked for, by name; none: the default ones
    unused: tuple[str, ...] = ()  # physical numbers of the model that nothing here uses, one a line


def zero(value: Setting) -> bool:
    """Whether this is the number zero."""
    return isinstance(value, Fraction) and value == 0
