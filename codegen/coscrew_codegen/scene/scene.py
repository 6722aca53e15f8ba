"""Scene: a model, the effects that act in it, and its run.  Frozen data, no arithmetic."""

import hashlib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, fields, is_dataclass, replace
from enum import Enum
from fractions import Fraction
from functools import cached_property

from coscrew_codegen.program.values.formats import BY_NAME, DOUBLE
from coscrew_codegen.program.values.parameter import Parameter, Scalar, Sign
from coscrew_codegen.scene.effect import Effect, StateOf
from coscrew_codegen.scene.formulas import Formula
from coscrew_codegen.scene.integrators import DEFAULT
from coscrew_codegen.scene.mechanism.joint_kind import JointKind
from coscrew_codegen.scene.mechanism.loop import WeightedCoordinate
from coscrew_codegen.scene.mechanism.model import Model
from coscrew_codegen.scene.mechanism.notices import Notice
from coscrew_codegen.scene.mechanism.ranges import Ranges

Setting = Scalar | tuple[Scalar | Formula, ...] | tuple[str, str] | Formula | str | None


@dataclass(frozen=True)
class Applied:
    """An effect applied to a joint or body, or under a label (a spring between two bodies, or on a
    weighted sum of coordinates, whose `terms` are given).

    `on` is "" for gravity and other effects on the whole scene.  `values` has an entry for each of
    the effect's parameters, and for pairs "bodies", the names of both.  A label distinguishes
    several applications of one effect to one body."""

    effect: Effect
    on: str
    values: Mapping[str, Setting]
    label: str = ""
    terms: tuple[WeightedCoordinate, ...] = ()

    def vector(self, name: str) -> tuple[Scalar, ...]:
        """The numbers of a parameter that is a vector."""
        given = self.values[name]
        return tuple(x for x in given if isinstance(x, Scalar)) if isinstance(given, tuple) else ()

    @property
    def states(self) -> tuple[StateOf, ...]:
        """Its states with these values."""
        return tuple(x for x in self.effect.states if not x.of or self.values[x.of] is not None)

    @property
    def bodies(self) -> tuple[str, ...]:
        """The two bodies of an effect on two."""
        pair = self.values.get("bodies")
        return tuple(map(str, pair)) if isinstance(pair, tuple) else ()

    @property
    def name(self) -> str:
        """Its name in `runtime`: viscous.elbow, wrench.push, gravity."""
        return ".".join(part for part in (self.effect.name, self.label or self.on) if part)


@dataclass(frozen=True)
class Expectation:
    """Value that a run must reach: |quantity(at) - value| <= rtol |value| + atol."""

    quantity: str  # "q.elbow", "energy", "reaction.elbow.2": as in `record`, one component
    at: float
    value: float
    rtol: float
    atol: float


@dataclass(frozen=True)
class Tolerance:
    """Largest rounding error allowed of an output of a function, or of all its outputs, in single
    precision."""

    function: str
    output: str  # "" for all
    within: float  # in the output's unit


@dataclass(frozen=True)
class Run:
    """Settings of integration: `step` is for emitted integrators, the tolerances are for SciPy's.
    """

    duration: float = 1.0
    integrator: str = DEFAULT
    step: float = 1e-3
    rtol: float = 1e-9
    atol: float = 1e-9


@dataclass(frozen=True)
class Scene:
    """The content of a scene file."""

    name: str  # a C and Python identifier
    model: Model
    effects: tuple[Applied, ...] = ()
    parameters: tuple[Parameter, ...] = ()  # run-time parameters, in the order of `runtime`
    precision: str = DOUBLE.name  # of runs: double, single, both
    precisions: tuple[str, ...] = tuple(BY_NAME)  # in which it is generated
    implausible: str = "error"  # or warn: bodies that cannot exist are accepted
    start_q: Mapping[str, tuple[float, ...]] = field(default_factory=dict)  # by joint
    start_v: Mapping[str, tuple[float, ...]] = field(default_factory=dict)
    start_x: Mapping[str, float] = field(default_factory=dict)  # by column
    record: tuple[str, ...] = ("q", "v")
    every: float = 0.01
    run: Run = Run()
    expectations: tuple[Expectation, ...] = ()
    functions: tuple[str, ...] = ()  # selected by name; (): the default functions
    tiers: tuple[str, ...] = ()  # selected besides plain, the cheapest first
    accuracy: tuple[Tolerance, ...] = ()  # accuracy requested of the mixed tier
    ranges: Ranges | None = None  # of arguments; None: those of the model's limits
    notices: tuple[Notice, ...] = ()  # content of the model's file that the scene does not use

    @property
    def unused(self) -> tuple[str, ...]:
        """Numbers of the model's file that the scene does not use, one line for each."""
        return tuple(notice.text for notice in self.notices)

    @cached_property
    def timed(self) -> bool:
        """True if any effect is a function of time."""
        def timed(value: Setting) -> bool:
            parts = value if isinstance(value, tuple) else (value,)
            return any(isinstance(x, Formula) and x.timed for x in parts)

        return any(timed(value) for x in self.effects for value in x.values.values())

    @property
    def signs(self) -> dict[str, Sign]:
        """The signs of the run-time parameters that have one, by name, which scene files require of
        the same numbers: masses are positive, and effects say what their parameters are."""
        results = {body.inertia.mass.name: Sign.POSITIVE for body in self.model.bodies
                   if body.inertia and isinstance(body.inertia.mass, Parameter)}
        for applied in self.effects:
            for described in applied.effect.parameters:
                if described.sign:
                    value = applied.values.get(described.name)
                    results |= {x.name: described.sign
                                for x in (value if isinstance(value, tuple) else (value,))
                                if isinstance(x, Parameter)}
        return results

    @property
    def content_hash(self) -> str:
        """SHA-256 of everything in the scene and its model, independent of the files' layout."""
        return hashed(self)

    @cached_property
    def motion_hash(self) -> str:
        """The hash of everything that a motion in a given precision depends on; the selected
        precisions, functions and tiers, which options replace, do not count."""
        return hashed(replace(self, precision="", precisions=(), implausible="", functions=(),
                              tiers=(), accuracy=(), ranges=None, notices=()))


def zero(value: Setting) -> bool:
    """Returns whether this is the number zero."""
    return isinstance(value, Fraction) and value == 0


def hashed(value: object) -> str:
    """SHA-256 of everything in a value, such as a scene and its model, independent of the files'
    layout."""
    return hashlib.sha256("\n".join(_as_text(value)).encode()).hexdigest()


def _as_text(value: object) -> Iterator[str]:
    """The value as unambiguous text: effects and kinds of joints by name, mappings sorted, exact
    fractions."""
    if isinstance(value, Effect | JointKind | Enum):
        yield f"{type(value).__name__} {value.name}"
    elif is_dataclass(value):
        yield type(value).__name__
        for field in fields(value):
            empty = "unhashed if empty" in field.metadata and not getattr(value, field.name)
            if field.compare and not empty:
                yield field.name
                yield from _as_text(getattr(value, field.name))
    elif isinstance(value, Mapping):
        for key in sorted(value):
            yield f"key {key}"
            yield from _as_text(value[key])
    elif isinstance(value, tuple | list):
        yield f"{len(value)} entries"
        for entry in value:
            yield from _as_text(entry)
    else:
        yield repr(value)
