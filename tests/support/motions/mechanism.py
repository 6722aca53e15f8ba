"""Mechanisms with their effects, as plain data, and as text of scene files."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

Vector = tuple[float, float, float]
Value = float | str | tuple[float, ...] | tuple[str, str]
ZERO: Vector = (0.0, 0.0, 0.0)
Y: Vector = (0.0, 1.0, 0.0)
Z: Vector = (0.0, 0.0, 1.0)
WORLD = "world"


def rounded(x: float, digits: int = 4) -> float:
    """x with so many decimal digits, so that texts and judges have the same number."""
    return float(f"{x:.{digits}g}")


@dataclass(frozen=True)
class Body:
    """A rigid body: mass in kg, moments about the centre of mass in kg m²."""

    name: str
    mass: float
    moments: Vector
    com: Vector = ZERO


@dataclass(frozen=True)
class Mimic:
    """q = multiplier q_joint + offset."""

    joint: str
    multiplier: float
    offset: float = 0.0


@dataclass(frozen=True)
class Joint:
    """A joint that moves `child`: continuous, revolute, prismatic, spherical or free."""

    name: str
    kind: str
    child: str
    parent: str = WORLD
    axis: Vector = Y
    xyz: Vector = ZERO
    rpy: Vector = ZERO
    lower: float | None = None
    upper: float | None = None
    mimic: Mimic | None = None


@dataclass(frozen=True)
class Acting:
    """An effect on a joint or body, or under a label; `free` are numbers given at run time, so that
    scenes which differ in them share one library."""

    effect: str
    on: str
    values: Mapping[str, Value] = field(default_factory=dict)
    free: tuple[str, ...] = ()

    @property
    def table(self) -> str:
        return f"effects.{self.effect}.{self.on}" if self.on else f"effects.{self.effect}"

    @property
    def settings(self) -> dict[str, float]:
        """The numbers given at run time, by their names in `runtime`."""
        results = {}
        for name in self.free:
            value = self.values[name]
            assert isinstance(value, float | int)
            results[f"{self.effect}.{self.on}.{name}"] = float(value)
        return results


@dataclass(frozen=True)
class Mechanism:
    """Bodies, their joints in order from the root, and effects."""

    bodies: tuple[Body, ...]
    joints: tuple[Joint, ...]
    acting: tuple[Acting, ...]

    @property
    def settings(self) -> dict[str, float]:
        return {name: x for acting in self.acting for name, x in acting.settings.items()}

    def text(self, alike: bool = False) -> str:
        """Its tables; `alike` for all that differ only in numbers given at run time."""
        return "\n".join(self._lines(alike)) + "\n"

    def _lines(self, alike: bool) -> Iterator[str]:
        if self.settings:
            yield f"runtime = {_written(tuple(self.settings))}"
        yield "[bodies]"
        for b in self.bodies:
            yield (f"{b.name} = {{ mass = {b.mass!r}, com = {_written(b.com)}, "
                   f"inertia = {_written(b.moments)} }}")
        for joint in self.joints:
            yield from _of_joint(joint)
        for acting in self.acting:
            yield f"[{acting.table}]"
            for name, value in acting.values.items():
                yield f"{name} = {_written(1.0 if alike and name in acting.free else value)}"


def _of_joint(joint: Joint) -> Iterator[str]:
    yield f"[joints.{joint.name}]"
    yield f'type = "{joint.kind}"\nparent = "{joint.parent}"\nchild = "{joint.child}"'
    if joint.kind in ("continuous", "revolute", "prismatic"):
        yield f"axis = {_written(joint.axis)}"
    yield f"origin = {{ xyz = {_written(joint.xyz)}, rpy = {_written(joint.rpy)} }}"
    ends = [f"{name} = {x!r}" for name, x in (("lower", joint.lower), ("upper", joint.upper))
            if x is not None]
    if ends:
        yield f"limits = {{ {', '.join(ends)} }}"
    if joint.mimic:
        yield (f'mimic = {{ joint = "{joint.mimic.joint}", multiplier = {joint.mimic.multiplier!r}'
               f", offset = {joint.mimic.offset!r} }}")


def _written(value: object) -> str:
    if isinstance(value, tuple):
        return f"[{', '.join(map(_written, value))}]"
    return f'"{value}"' if isinstance(value, str) else repr(value)


State = Mapping[str, tuple[float, ...]]
"""Coordinates or velocities by joint."""


@dataclass(frozen=True)
class Motion:
    """A mechanism's motion from a start.

    `rate` is that of its stiffest part in rad/s, `length` a typical one in m.  A `chaotic` motion
    is compared as long as its own sensitivity leaves it a meaning.  Joints of a `pair` are compared
    in the frame of their centre of mass."""

    family: str
    number: int
    mechanism: Mechanism
    q: State
    v: State
    duration: float
    steps: tuple[float, ...]
    rate: float
    length: float = 1.0
    chaotic: bool = False
    about: str = ""
    adaptive: bool = False  # whether SciPy's integrators run it, too
    pair: tuple[tuple[str, float], ...] = ()  # joints on one rail, with the masses that they move

    @property
    def name(self) -> str:
        return f"{self.family} {self.number}"

    def text(self, step: float, integrator: str = "leapfrog", precision: str = "double",
             tolerances: tuple[float, float] | None = None) -> str:
        """The scene file of a run: a sample at the end of a step, a few hundred in all; with rtol
        and atol, if given."""
        tolerance = "rtol = {!r}\natol = {!r}\n".format(*tolerances) if tolerances else ""
        return (f'precision = "{precision}"\n{self.mechanism.text()}'
                f"[start.q]\n{_state(self.q)}[start.v]\n{_state(self.v)}"
                f"[outputs]\nevery = {self.every(step)!r}\n"
                f'[run]\nduration = {self.duration!r}\nstep = {step!r}\n'
                f'integrator = "{integrator}"\n{tolerance}')

    def every(self, step: float) -> float:
        """The time between samples: a multiple of the step."""
        return step * max(1, round(self.duration / step / SAMPLES))


SAMPLES = 250


def _state(state: State) -> str:
    return "".join(f"{joint} = {x[0]!r}\n" if len(x) == 1 else f"{joint} = {_written(x)}\n"
                   for joint, x in state.items())
