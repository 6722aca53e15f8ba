"""Data of a scene for targets: its functions as Programs."""

from dataclasses import dataclass, replace
from fractions import Fraction
from math import isfinite
from typing import TypeVar

from coscrew_codegen.program import Input, Program
from coscrew_codegen.program.values.formats import BY_NAME, Precision
from coscrew_codegen.program.values.parameter import Sign
from coscrew_codegen.program.values.quantity import Argument

Arrays = tuple[tuple[str, tuple[int, ...]], ...]
"""Names and shapes of arguments or results."""


@dataclass(frozen=True)
class Coordinate:
    """The entries of q and v that belong to a joint."""

    joint: str
    kind: str  # revolute, prismatic, …
    q: range
    v: range


@dataclass(frozen=True)
class ArgumentRanges:
    """Stated ranges of a function's arguments: an interval of each component of each input, with
    ends rounded outwards; and the components of each unit quaternion."""

    intervals: tuple[tuple[tuple[float, float], ...], ...]
    quaternions: tuple[tuple[Input, ...], ...] = ()

    def sizes(self, precision: Precision) -> list[list[float]]:
        """Bounds of the sizes of components, of the numbers rounded to the precision as well."""
        return [[_rounded_up(max(map(abs, x)), precision) for x in each]
                for each in self.intervals]


def _rounded_up(size: float, precision: Precision) -> float:
    return float(precision.rounded_up(Fraction(size))) if size and isfinite(size) else size


@dataclass(frozen=True)
class Accuracy:
    """Requested error limits of a function's results, and the states for which they hold: ranges of
    each component of each input, and the components that are quaternions."""

    tolerances: tuple[float, ...]  # of each component of the results
    components: tuple[tuple[str, int], ...]  # their outputs and numbers
    ranges: tuple[tuple[tuple[float, float], ...], ...]
    quaternions: tuple[tuple[int, range], ...] = ()  # number of the input, its components
    stated: ArgumentRanges | None = None  # if the scene states ranges: then the limits are proved


@dataclass(frozen=True)
class FunctionProgram:
    """A function of a scene.

    The program's inputs come in this order, as far as it has them: t, h (scalars), p (parameters),
    q, v, then a, tau, phi or others; in C its outputs follow, in Python they are returned.
    `headings` are pairs (index of an instruction, comment above it), one section per body.  An
    `internal` function is called by steps only and is not declared in the header.  Where `plain` is
    given, the results of this plain program are computed first and are the program's last inputs.
    """

    name: str  # inverse_dynamics, jacobian_hand
    words: str  # its equation, and its outputs with units
    program: Program
    headings: tuple[tuple[int, str], ...] = ()
    internal: bool = False
    rounding: str = ""  # statement on its rounding errors, proved in the plain tier
    plain: Program | None = None
    accuracy: Accuracy | None = None  # if requested: then the mixed tier has the function
    units: tuple[str, ...] = ()  # of each component of its results, in order
    ranges: ArgumentRanges | None = None  # if the scene states any

    @property
    def inputs(self) -> tuple[Argument, ...]:
        """The inputs that callers pass."""
        return (self.plain or self.program).inputs

    @property
    def computed(self) -> tuple[Argument, ...]:
        """The inputs of its program that are computed first."""
        return self.program.inputs[len(self.inputs):]

    def takes(self, name: str) -> bool:
        """Returns whether an input has this name."""
        return any(a.name == name for a in self.program.inputs)


@dataclass(frozen=True)
class Call:
    """results = function(inputs): its outputs are assigned to the variables `results`, in order.

    An input is the variable of the same name, unless `given` pairs it with another variable."""

    function: str
    results: tuple[str, ...]
    given: tuple[tuple[str, str], ...] = ()


@dataclass(frozen=True)
class Split:
    """`calls` once over the whole step h or, if the result of `test` is not zero, once for each
    part of it; `parts` returns their number and their length, the variable `part`.  Without a test
    `parts` is always called.

    With many states at once each takes the number of parts that it needs."""

    test: Call | None  # returns a number
    parts: Call  # returns the number of parts and the length of each
    calls: tuple[Call, ...]
    moved: tuple[str, ...]  # variables that each part updates for the next: t, q, v

    @property
    def first(self) -> tuple[Call, ...]:
        """The calls before `calls`."""
        return (self.test, self.parts) if self.test else (self.parts,)


@dataclass(frozen=True)
class IntegratorStep:
    """One step of an integrator: calls in order that take q and v to the end of the step.

    Inputs are t, h, p, q and v, and tau if it `takes_tau`; the variables `zeros` are vectors of
    zeros.  All arithmetic is in the functions called."""

    integrator: str  # its name in scenes and commands: semi-implicit-euler
    name: str  # its function's: step_semi_implicit_euler
    words: str  # its equation
    body: tuple[Call | Split, ...]
    zeros: tuple[str, ...] = ()
    takes_tau: bool = False

    @property
    def calls(self) -> tuple[Call, ...]:
        """All calls, in order."""
        return tuple(call for x in self.body for call in (
            (*x.first, *x.calls) if isinstance(x, Split) else (x,)))


@dataclass(frozen=True)
class Signature:
    """A function's inputs and outputs: names and shapes.  If `moved`, q and v change in place."""

    name: str
    inputs: Arrays
    outputs: Arrays
    words: tuple[str, ...]
    moved: bool = False
    zero: bool = False  # whether its outputs are zero whatever the inputs

    @property
    def repeats(self) -> bool:
        """True if it is a step that many steps in one call repeat: one that does not take tau."""
        return self.moved and "tau" not in dict(self.inputs)

    @property
    def arguments(self) -> tuple[tuple[str, tuple[int, ...], bool], ...]:
        """Name, shape and whether it is written, of each argument in C, in order."""
        written = {x for x, _ in self.outputs}
        moved = written if self.moved else set()
        return (*((x, shape, x in moved) for x, shape in self.inputs),
                *((x, shape, True) for x, shape in self.outputs if x not in moved))

    @property
    def read(self) -> Arrays:
        """The inputs that are only read."""
        return tuple(x for x in self.inputs if not self.moved or x not in self.outputs)


@dataclass(frozen=True)
class SceneInterface:
    """Interface of a scene's functions for callers: sizes, names and entries of q and v; no
    Programs."""

    name: str
    nq: int
    nv: int
    coordinates: tuple[Coordinate, ...]
    bodies: tuple[str, ...]
    parameters: tuple[tuple[str, float], ...]
    neutral: tuple[float, ...]
    precisions: tuple[str, ...]
    timed: bool
    signatures: tuple[Signature, ...]  # the public functions, steps last
    signs: tuple[tuple[str, Sign], ...] = ()  # names of the parameters with a sign
    tiers: tuple[str, ...] = ()  # selected besides plain
    mark: str = ""  # of the tier of these functions: their names in C end in it
    states: tuple[tuple[str, str], ...] = ()  # names and units of effects' states, the end of q


@dataclass(frozen=True)
class SceneFunctions:
    """A scene's functions and data for targets."""

    name: str
    nq: int
    nv: int
    coordinates: tuple[Coordinate, ...]
    bodies: tuple[str, ...]  # in the order of body_poses
    parameters: tuple[tuple[str, float], ...]  # names of the elements of p, and their values
    neutral: tuple[float, ...]  # the q at which every joint's displacement is the identity
    functions: tuple[FunctionProgram, ...]
    steps: tuple[IntegratorStep, ...] = ()  # of each integrator
    precisions: tuple[str, ...] = tuple(BY_NAME)  # in which it is emitted
    timed: bool = False  # whether forces depend on time
    signs: tuple[tuple[str, Sign], ...] = ()  # names of the parameters with a sign
    tiers: tuple[str, ...] = ()  # in which the public functions are emitted, too
    mark: str = ""  # of the tier of these functions: their names in C end in it
    states: tuple[tuple[str, str], ...] = ()  # names and units of effects' states, the end of q
    box: tuple[tuple[str, tuple[float, ...]], ...] = ()  # stated largest sizes of arguments'
    # components, by argument; infinite where nothing is stated

    def named(self, name: str) -> FunctionProgram:
        """The function of this name; a ValueError if there is none."""
        function = next((f for f in self.functions if f.name == name), None)
        if function is None:
            raise ValueError(f"scene {self.name!r} has no function {name!r}")
        return function

    def has(self, name: str) -> bool:
        """Returns whether there is a function of this name."""
        return any(f.name == name for f in self.functions)


def c_name(scene: SceneFunctions | SceneInterface, name: str, precision: Precision) -> str:
    """arm_forward_dynamics, arm_forward_dynamicsf, arm_forward_dynamics_accurate."""
    return f"{scene.name}_{name}{scene.mark and f'_{scene.mark}'}{precision.suffix}"


Scene = TypeVar("Scene", SceneFunctions, SceneInterface)


def many(scene: Scene) -> Scene:
    """The scene, with the names in C of its functions of many states: arm_energy_many."""
    return replace(scene, mark=marked(scene.mark, "many"))


def marked(*marks: str) -> str:
    """Joins the marks that end names in C, without empty ones."""
    return "_".join(filter(None, marks))


def signs(scene: SceneFunctions | SceneInterface) -> tuple[tuple[int, str, bool], ...]:
    """Returns for each parameter with a sign: its index in p, its name, whether it may be zero."""
    names = [name for name, _ in scene.parameters]
    return tuple((names.index(name), name, sign is Sign.NONNEGATIVE) for name, sign in scene.signs)
