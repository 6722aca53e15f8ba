"""What the derivation of a scene hands to the targets: its functions as Programs."""

from dataclasses import dataclass

from coscrew_codegen.program import Program

Arrays = tuple[tuple[str, tuple[int, ...]], ...]
"""Names and shapes of arguments or results."""


@dataclass(frozen=True)
class Coordinate:
    """A joint's places in q and v."""

    joint: str
    kind: str  # revolute, prismatic, spherical, free
    q: range
    v: range


@dataclass(frozen=True)
class Function:
    """A function of a scene.

    The program's inputs are, of those it has, in this order: t, h (scalars), p (parameters), q, v,
    then a, tau, phi or others; its outputs follow in C and are returned in Python.  `headings` are
    (index of an instruction, words that stand above it): sections per body.  `internal` ones serve
    the steps alone and are not declared in the header.
    """

    name: str  # inverse_dynamics, jacobian_hand
    words: str  # its equation, and what the output is, with units
    program: Program
    headings: tuple[tuple[int, str], ...] = ()
    internal: bool = False

    def takes(self, name: str) -> bool:
        """Whether an input has this name."""
        return any(a.name == name for a in self.program.inputs)


@dataclass(frozen=True)
class Call:
    """results = function(inputs): the variables `results` take its outputs, in order.  An input is
    the variable of its own name, or the one that `given` names beside it."""

    function: str
    results: tuple[str, ...]
    given: tuple[tuple[str, str], ...] = ()


@dataclass(frozen=True)
class Split:
    """`calls` once with `part` = h; where the result of `test` is not zero as often, and with that
    part of h, as the results of `parts` say.

    States are independent of each other: with many at once each takes as many parts as it needs."""

    test: Call  # its result: a number
    parts: Call  # its results: how many, and how long each is
    calls: tuple[Call, ...]
    moved: tuple[str, ...]  # variables that go on from one part to the next: t, q, v


@dataclass(frozen=True)
class Step:
    """What an integrator does in a step: calls, in order, after which q and v have moved.

    Inputs are t, h, p, q and v; the variables `zeros` are vectors of zeros.  Nothing is computed
    but by the functions called."""

    integrator: str  # as scenes and commands call it: semi-implicit-euler
    name: str  # of its function: step_semi_implicit_euler
    words: str  # its equation
    body: tuple[Call | Split, ...]
    zeros: tuple[str, ...] = ()

    @property
    def calls(self) -> tuple[Call, ...]:
        """All calls, in order."""
        return tuple(call for x in self.body
                     for call in ((x.test, x.parts, *x.calls) if isinstance(x, Split) else (x,)))


@dataclass(frozen=True)
class Signature:
    """What a function takes and returns: names, shapes; those of `moved` are changed in place."""

    name: str
    inputs: Arrays
    outputs: Arrays
    words: tuple[str, ...]
    moved: bool = False
    computes: bool = True  # and does not only hand on inputs and constants

    @property
    def read(self) -> Arrays:
        """The inputs that are only read."""
        return tuple(x for x in self.inputs if not self.moved or x not in self.outputs)


@dataclass(frozen=True)
class SceneInterface:
    """A scene as those see it who call its functions: sizes, names and places; no Programs."""

    name: str
    nq: int
    nv: int
    coordinates: tuple[Coordinate, ...]
    bodies: tuple[str, ...]
    parameters: tuple[tuple[str, float], ...]
    neutral: tuple[float, ...]
    precisions: tuple[str, ...]
    timed: bool
    signatures: tuple[Signature, ...]  # the public functions, steps behind the others


@dataclass(frozen=True)
class SceneFunctions:
    """A scene as its targets see it."""

    name: str
    nq: int
    nv: int
    coordinates: tuple[Coordinate, ...]
    bodies: tuple[str, ...]  # as body_poses orders them
    parameters: tuple[tuple[str, float], ...]  # names of the elements of p, and their values
    neutral: tuple[float, ...]  # q where every joint is at rest in its placement
    functions: tuple[Function, ...]
    steps: tuple[Step, ...] = ()  # of each integrator
    precisions: tuple[str, ...] = ("double", "single")  # those it is emitted in
    timed: bool = False  # whether what acts depends on time

    def named(self, name: str) -> Function:
        """The function of this name; a ValueError if there is none."""
        found = next((f for f in self.functions if f.name == name), None)
        if found is None:
            raise ValueError(f"scene {self.name!r} has no function {name!r}")
        return found

    def has(self, name: str) -> bool:
        """Whether there is a function of this name."""
        return any(f.name == name for f in self.functions)
