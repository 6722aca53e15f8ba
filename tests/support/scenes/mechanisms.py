"""Small models and scenes for tests, written with exact numbers."""

from collections.abc import Mapping
from fractions import Fraction
from typing import TypeAlias, TypedDict, Unpack

from coscrew_codegen.program.values.parameter import Parameter, Scalar
from coscrew_codegen.scene.effects import EFFECTS
from coscrew_codegen.scene.formulas import Formula
from coscrew_codegen.scene.mechanism.joint_kind import JointKind
from coscrew_codegen.scene.mechanism.model import (
    HERE,
    WORLD,
    Body,
    Inertia,
    Joint,
    Mimic,
    Model,
    Placement,
)
from coscrew_codegen.scene.scene import Applied, Run, Scene, Setting
from tests.support.scenes.kinds import Kind
from tests.support.scenes.selecting import with_jacobians

CATALOGUE = {effect.name: effect for effect in EFFECTS}
I = HERE.R
O = (Fraction(0),) * 3
X, Y, Z = (tuple(Fraction(int(i == k)) for i in range(3)) for k in range(3))


Exact: TypeAlias = Fraction | int | str  # "0.1" is 1/10
Value: TypeAlias = Scalar | int | Formula | str | None | tuple[Scalar | int | Formula | str, ...]


def numbers(*values: Exact | Parameter) -> tuple[Scalar, ...]:
    """Exact numbers; parameters stay as they are."""
    return tuple(x if isinstance(x, Parameter) else Fraction(x) for x in values)


def inertia(mass: Exact | Parameter, com: tuple[Exact | Parameter, ...] = (0, 0, 0),
            moments: tuple[Exact | Parameter, ...] = (0,) * 6) -> Inertia:
    """Mass, centre of mass, moments xx, yy, zz, xy, xz, yz about it."""
    return Inertia(numbers(mass)[0], numbers(*com), numbers(*moments))


def at(x: Exact, y: Exact, z: Exact) -> Placement:
    """A placement with this origin, without rotation."""
    return Placement(I, (Fraction(x), Fraction(y), Fraction(z)))


def applied(name: str, on: str = "", **values: Value) -> Applied:
    """An effect of the catalogue; missing parameters have their default values."""
    effect = CATALOGUE[name]
    results: dict[str, Value] = {p.name: None if p.default == "model" else p.default
                                 for p in effect.parameters}
    chosen = values.get("kind", results.get("kind"))
    for parameter in effect.parameters:
        if parameter.of and chosen not in parameter.of:
            results[parameter.name] = None
    unknown = set(values) - {*results, "bodies"}
    if unknown:
        raise KeyError(f"{name} has no {sorted(unknown)}")
    return Applied(effect, on, {key: _setting(x) for key, x in {**results, **values}.items()})


def _setting(value: Value) -> Setting:
    match value:
        case (str(first), str(second)):
            return first, second
        case tuple():
            return tuple(_exact(x) for x in value if not isinstance(x, str))
        case int():
            return Fraction(value)
    return value


def _exact(x: Scalar | int | Formula) -> Scalar | Formula:
    return Fraction(x) if isinstance(x, int) else x


def gravity(*g: Exact) -> Applied:
    """Gravity g, by default 9.81 m/s^2 along -z."""
    return applied("gravity", g=numbers(*(g or (0, 0, "-9.81"))))


class Settings(TypedDict, total=False):
    """Settings of a scene, besides its name, model and effects."""

    parameters: tuple[Parameter, ...]
    start_q: Mapping[str, tuple[float, ...]]
    start_v: Mapping[str, tuple[float, ...]]
    run: Run


def scene(model: Model, *effects: Applied, **settings: Unpack[Settings]) -> Scene:
    """The scene of these effects, in the order of the catalogue's names."""
    return with_jacobians(Scene(
        model.name, model, tuple(sorted(effects, key=lambda x: x.effect.name)), **settings))


def chain(*links: tuple[JointKind, tuple[Fraction, ...], Placement, Inertia],
          name: str = "chain") -> Model:
    """A chain of joints j0, j1, … and bodies b0, b1, …, each with kind, axis, placement, inertia.
    """
    bodies, joints = [], []
    for n, (kind, axis, placement, body) in enumerate(links):
        bodies.append(Body(f"b{n}", body))
        joints.append(Joint(f"j{n}", kind, f"b{n - 1}" if n else WORLD, f"b{n}", placement, axis))
    return Model(name, tuple(bodies), tuple(joints))


def rotor(J: Exact = 1) -> Model:
    """A wheel of moment of inertia J about z, on its axis."""
    return chain((Kind.REVOLUTE, Z, HERE, inertia(1, moments=(J, J, J, 0, 0, 0))), name="rotor")


def slider(mass: Exact = 1, axis: tuple[Fraction, ...] = X) -> Model:
    """A mass on a line."""
    return chain((Kind.PRISMATIC, axis, HERE, inertia(mass)), name="slider")


def pendulum(mass: Exact = 1, length: Exact = 1) -> Model:
    """A point mass on a massless rod that rotates about y; at rest it hangs along -z."""
    return chain((Kind.REVOLUTE, Y, HERE, inertia(mass, (0, 0, -Fraction(length)))),
                 name="pendulum")


def free_body(mass: Exact = 1, com: tuple[Exact, ...] = (0, 0, 0),
              moments: tuple[Exact, ...] = (1, 1, 1, 0, 0, 0)) -> Model:
    """A body on a free joint."""
    return chain((Kind.FREE, Z, HERE, inertia(mass, com, moments)), name="free_body")


def ball(mass: Exact = 1, com: tuple[Exact, ...] = (0, 0, 0),
         moments: tuple[Exact, ...] = (1, 2, 3, 0, 0, 0)) -> Model:
    """A body on a spherical joint."""
    return chain((Kind.SPHERICAL, Z, HERE, inertia(mass, com, moments)), name="ball")


def geared(multiplier: Exact, offset: Exact = 0, J: tuple[Exact, Exact] = (1, 1)) -> Model:
    """Two wheels; the second one's joint mimics the first one's."""
    wheels = [inertia(1, moments=(j, j, j, 0, 0, 0)) for j in J]
    bodies = (Body("b0", wheels[0]), Body("b1", wheels[1]))
    return Model("geared", bodies, (
        Joint("j0", Kind.REVOLUTE, WORLD, "b0"),
        Joint("j1", Kind.REVOLUTE, WORLD, "b1", at(1, 0, 0),
              mimic=Mimic("j0", Fraction(multiplier), Fraction(offset)))))


__all__ = ["CATALOGUE", "Formula", "I", "O", "X", "Y", "Z", "applied", "at", "ball", "chain",
           "free_body", "geared", "gravity", "inertia", "numbers", "pendulum", "rotor", "scene",
           "slider"]


def chain_of_three() -> Model:
    """Two revolute arms, a slider along the second, and a joint that follows the first."""
    links = chain((Kind.REVOLUTE, Y, HERE, inertia(2, (0, Fraction(1, 2), 1), (1, 2, 3, 0, 0, 0))),
                  (Kind.REVOLUTE, X, at(0, 1, 0), inertia(3, (0, 1, 1), (1, 2, 2, 0, 0, 0))),
                  (Kind.PRISMATIC, Y, at(1, 1, 0), inertia(1, (1, 0, 0), (1, 1, 1, 0, 0, 0))))
    follower = geared(Fraction(-3, 2)).joints[1]
    return Model(links.name, (*links.bodies, Body("c", inertia(2, (1, 0, 0), (1, 1, 1, 0, 0, 0)))),
                 (*links.joints, Joint("k", Kind.REVOLUTE, "b1", "c", at(1, 0, 0),
                                       mimic=follower.mimic)))
