"""What the derivation of a scene hands to the targets: its functions as Programs."""

from dataclasses import dataclass

from coscrew_codegen.program import Program


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
    then a, tau or phi; its outputs follow in C and are returned in Python.  `headings` are (index
    of an instruction, words that stand above it): sections per body.  `internal` ones serve the
    steps alone and are not declared in the header.
    """

    name: str  # inverse_dynamics, jacobian_hand
    words: str  # its equation, and what the output is, with units
    program: Program
    headings: tuple[tuple[int, str], ...] = ()
    internal: bool = False


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
    steps: tuple[str, ...]  # names of integrators: semi_implicit_euler, linear_implicit_euler, rk4
    precisions: tuple[str, ...] = ("double", "single")  # those it is emitted in
    timed: bool = False  # whether what acts depends on time
