"""Forces, energies and powers of every effect: formulas and quadratures of the tests' own.

Each case is an effect on the least model, at some states.  Torques, forces and powers are compared
with formulas written here once more; energies with quadratures of these forces; the field of a
sphere with its attraction of single points.  All to 45 digits of 50."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import chain

import mpmath
import numpy as np
import pytest
from mpmath import mpf

from coscrew_codegen.scene.effect_quantities import functions_of_effects, units_of
from coscrew_codegen.scene.mechanism.model import Body, Joint, Model
from coscrew_codegen.scene.scene import Applied
from tests.support.scenes.effect_laws import assert_same, multiprecise
from tests.support.scenes.effect_scenes import assert_listed
from tests.support.scenes.kinds import Kind
from tests.support.scenes.mechanisms import (
    CATALOGUE,
    HERE,
    Formula,
    X,
    applied,
    free_body,
    gravity,
    inertia,
    numbers,
    pendulum,
    rotor,
)
from tests.support.truth.exact import array, rotation_of, skew

Vector = np.ndarray
HALF, TENTH = Fraction(1, 2), Fraction(1, 10)
FILE = "tests/scenes/test_effect_values.py"


@pytest.fixture(autouse=True)
def fifty_digits() -> Iterator[None]:
    with mpmath.workdps(50):
        yield


@dataclass(frozen=True)
class Case:
    """An effect, the last of `effects`, at a state: its own quantities; the power that it does not
    store; the torques along all velocities."""

    model: Model
    effects: tuple[Applied, ...]
    state: Mapping[str, Sequence[object]]
    own: Mapping[str, Sequence[mpf]]
    lost: mpf
    along: Sequence[mpf] = ()
    kinetic: mpf | None = None  # energy that counts as kinetic
    others: mpf = field(default_factory=mpf)  # potential energy of the other effects


def work(force: Callable[[mpf], mpf], start: object, end: object) -> mpf:
    """∫ force dx from start to end."""
    return mpmath.quad(force, [mpf(start), mpf(end)])


# joints


def at_joint(name: str, q: object, v: object, exerted: mpf, t: object = 0,
             lost: mpf | None = None, more: Mapping[str, Sequence[mpf]] | None = None,
             **values: object) -> Case:
    """A case at a rotor's joint; without `lost` all power is."""
    power = exerted * mpf(v)
    return Case(rotor(), (applied(name, "j0", **values),),
                {"t": mpf(t), "q": [mpf(q)], "v": [mpf(v)]},
                {"torque": [exerted], "power": [power], **(more or {})},
                power if lost is None else lost, [exerted])


def limited(u: mpf, limit: object, speed: object = 0) -> tuple[mpf, Mapping[str, Sequence[mpf]]]:
    """The torque u within ±limit, at a speed relative to that without load, and whether it is not
    u."""
    most = mpf(limit) * (max(1 - abs(mpf(speed)), 0) if u * speed > 0 else 1)
    applied_torque = max(-most, min(u, most))
    return applied_torque, {"saturated": [mpf(int(applied_torque != u))]}


def actuators() -> Iterator[Case]:
    for q, v, t in (("0.3", "-0.7", "0.2"), ("-9", "2", "0.4"), ("9", "5", "1.3")):
        q, v, t = map(mpf, (q, v, t))
        u = 3 * mpmath.sin(2 * t)
        yield at_joint("actuator", q, v, u, t, kind="torque", torque=Formula("3*sin(2*t)"))
        torque, more = limited(u, mpf("2.5"))
        yield at_joint("actuator", q, v, torque, t, more=more, kind="torque",
                       torque=Formula("3*sin(2*t)"), limit=Fraction(5, 2))
        torque, more = limited(5 * (mpmath.cos(t) - q) + mpf("0.5") * (t - v), 4)
        yield at_joint("actuator", q, v, torque, t, more=more, kind="pd", kp=5, kd=HALF,
                       target=Formula("cos(t)"), target_v=Formula("t"), limit=4)
        torque, more = limited(5 * (mpmath.cos(t) - q), 4, v / 3)
        yield at_joint("actuator", q, v, torque, t, more=more, kind="pd", kp=5, kd=0,
                       target=Formula("cos(t)"), limit=4, speed=3)
        torque, more = limited(3 * mpmath.sin(2 * t), 4, v / 7)
        yield at_joint("actuator", q, v, torque, t, more=more, kind="torque", limit=4, speed=7,
                       torque=Formula("3*sin(2*t)"))
        torque, more = limited(5 * (1 - q) - mpf("0.5") * v + mpmath.exp(-t), 4)
        yield at_joint("actuator", q, v, torque, t, more=more, kind="pd", kp=5, kd=HALF, target=1,
                       torque=Formula("exp(-t)"), limit=4)
        current = (12 * t - mpf("0.04") * 10 * v) / 2
        torque, more = limited(10 * mpf("0.05") * current, 1)
        yield at_joint("actuator", q, v, torque, t, more=more, kind="dc", voltage=Formula("12*t"),
                       gear=10, kt=Fraction(1, 20), ke=Fraction(1, 25), R=2, limit=1)


def compensating() -> Iterator[Case]:
    """On a pendulum, which needs m g l sin q; its weight is no torque of an effect."""
    for q, v in (("0.4", "1.5"), ("-2", "-0.3"), ("9", "0.2")):
        q, v = map(mpf, (q, v))
        weight = 2 * mpf("0.7") * mpf("9.81")
        held = weight * mpmath.sin(q)
        for u, values in ((5 * (1 - q) - mpf("0.5") * v + 3 + held,
                           {"kind": "pd", "kp": 5, "kd": HALF, "target": 1, "torque": 3}),
                          (3 + held, {"kind": "torque", "torque": 3})):
            torque, more = limited(u, 20)
            effect = applied("actuator", "j0", gravity_compensation="true", limit=20, **values)
            yield Case(pendulum(2, Fraction(7, 10)), (gravity(), effect), {"q": [q], "v": [v]},
                       {"torque": [torque], "power": [torque * v], **more}, torque * v, [torque],
                       others=-weight * mpmath.cos(q))


def armatures() -> Iterator[Case]:
    for values, I in (({"inertia": 6}, 6), ({"rotor": TENTH, "gear": 10}, 10),
                      ({"inertia": 6, "rotor": TENTH, "gear": -10}, 16)):
        energy = mpf(I) * mpf("0.7")**2 / 2
        yield Case(rotor(3), (applied("armature", "j0", **values),),
                   {"q": [1], "v": [mpf("0.7")]}, {"energy": [energy]}, mpf(0), [mpf(0)],
                   energy + 3 * mpf("0.7")**2 / 2)


def added_masses() -> Iterator[Case]:
    """Energy V·M V/2 at the point, which counts as kinetic; (f; τ) = -[ad]*(V) M V at a = 0."""
    point = [mpf(1), mpf("0.5"), mpf(-2)]
    v, w = array(TWIST[:3]), array(TWIST[3:])
    u = v + skew(w) @ array(point)
    p, L = array([4, 9, 7]) * u, array([2, 1, 3]) * w
    force, moment = -skew(w) @ p, -(skew(w) @ L + skew(u) @ p)
    energy = (u @ p + w @ L) / 2
    yield Case(free_body(2), (applied("added_mass", "b0", mass=(4, 9, 7), inertia=(2, 1, 3),
                                      point=numbers(1, "0.5", -2)),),
               {"q": [*PLACE, *QUATERNION], "v": TWIST}, {"energy": [energy]}, mpf(0),
               [*force, *(moment + skew(array(point)) @ force)],
               energy + (2 * v @ v + w @ w) / 2)


def frictions() -> Iterator[Case]:
    for v in map(mpf, ("0", "1e-9", "-0.003", "0.2", "-5")):
        slow = mpmath.tanh(v / mpf("0.01"))
        yield at_joint("coulomb", 1, v, -mpf("0.8") * slow, tau_c=Fraction(4, 5),
                       eps=Fraction(1, 100))
        level = mpf("0.8") + mpf("0.3") * mpmath.exp(-(v / mpf("0.05"))**2)
        yield at_joint("stribeck", 1, v, -level * slow, tau_c=Fraction(4, 5),
                       tau_s=Fraction(11, 10), v_s=Fraction(1, 20), eps=Fraction(1, 100))
        yield at_joint("viscous", 1, v, -mpf("0.75") * v, d=Fraction(3, 4))
        excess = max(abs(v) - mpf("0.1"), 0) * mpmath.sign(v)
        yield at_joint("speed_limit", 1, v, -mpf("0.75") * excess, d=Fraction(3, 4), speed=TENTH)
        yield at_joint("joint_drag", 1, v, -mpf("0.75") * v**2 * mpmath.sign(v), c=Fraction(3, 4))


def springs() -> Iterator[Case]:
    for q, v in (("0.4", "1.5"), ("-2", "-0.3")):
        torque = -7 * (mpf(q) - mpf("0.1"))
        stored = -work(lambda x: -7 * (x - mpf("0.1")), mpf("0.1"), q)
        yield at_joint("spring", q, v, torque, lost=mpf(0), more={"energy": [stored]}, k=7,
                       q0=TENTH)


def limits() -> Iterator[Case]:
    """Beyond either end and within; pushed back, released slowly, released too fast to push."""
    for end, side in ((mpf(-1), -1), (mpf("0.2"), 1)):
        for depth in map(mpf, ("0.3", "0.01", "-0.4")):
            for speed in map(mpf, ("0.5", "-0.5", "-4")):  # > 0: into the limit
                q, v, deep = end + side * depth, side * speed, max(depth, mpf(0))
                push = 9 * deep**mpf("1.5") * max(1 + mpf("1.5") * speed / 2, 0)
                stored = work(lambda x: 9 * x**mpf("1.5"), 0, deep)
                elastic = -side * 9 * deep**mpf("1.5")
                yield at_joint("limit", q, v, -side * push, lost=(-side * push - elastic) * v,
                               more={"energy": [stored]}, lower=-1, upper=Fraction(1, 5), k=9,
                               alpha=HALF)


# bodies


with mpmath.workdps(50):
    QUATERNION = [mpf(x) / 10 for x in (5, -7, 5, 1)]  # of norm 1
    PLACE = [mpf(x) / 7 for x in (11, -20, 9)]
    TWIST = [mpf(x) / 9 for x in (4, -1, 7, 2, 8, -5)]  # in the body's frame


def on_body(effects: Sequence[Applied], force: Vector, torque: Vector, stored: mpf | None = None,
            t: object = 0, model: Model | None = None) -> Case:
    """A case at a free body, with force and torque about its origin in the world's axes."""
    R = rotation_of(array(QUATERNION))
    power = force @ (R @ array(TWIST[:3])) + torque @ (R @ array(TWIST[3:]))
    more = {} if stored is None else {"energy": [stored]}
    return Case(model or free_body(2), tuple(effects),
                {"t": mpf(t), "q": [*PLACE, *QUATERNION], "v": TWIST},
                {"force": [*force], "torque": [*torque], "power": [power], **more},
                power if stored is None else mpf(0), [*(R.T @ force), *(R.T @ torque)])


def offset(point: Sequence[mpf]) -> Vector:
    """From the body's origin to one of its points, in the world's axes."""
    return rotation_of(array(QUATERNION)) @ array(point)


def point_velocity(point: Sequence[mpf]) -> Vector:
    R = rotation_of(array(QUATERNION))
    return R @ (array(TWIST[:3]) + skew(array(TWIST[3:])) @ array(point))


def buoyancies() -> Iterator[Case]:
    """With gravity, which is left out of the torques by subtraction of a scene without buoyancy."""
    g, r = array([mpf(1), mpf(-2), mpf("-9.81")]), offset([mpf(1), mpf("0.5"), mpf(-2)])
    force = -3 * mpf("0.5") * g
    place = array(PLACE) + r
    stored = -work(lambda s: force @ place, 0, 1)  # from the world's origin
    case = on_body((gravity(1, -2, "-9.81"), applied("buoyancy", "b0", rho=3, V=HALF,
                                                     centre=numbers(1, "0.5", -2))),
                   force, skew(r) @ force, stored)
    yield Case(case.model, case.effects, case.state, case.own, case.lost, case.along, None,
               -2 * (g @ array(PLACE)))


def drags() -> Iterator[Case]:
    point = [mpf(1), mpf("0.5"), mpf(-2)]
    u, r = point_velocity(point), offset(point)
    for values, force in (({"rho": 3, "area": HALF}, -mpf("0.75") * mpmath.sqrt(u @ u) * u),
                          ({"kind": "stokes", "b": 3}, -3 * u)):
        yield on_body((applied("drag", "b0", point=numbers(1, "0.5", -2), **values),), force,
                      skew(r) @ force)


def wrenches() -> Iterator[Case]:
    r, t = offset([mpf(1), mpf("0.5"), mpf(-2)]), mpf("0.3")
    given = {"force": (Formula("t"), 2, 3), "torque": (5, Formula("-t"), 7),
             "point": numbers(1, "0.5", -2)}
    for frame in ("world", "body"):
        force, torque = array([t, 2, 3]), array([5, -t, 7])
        if frame == "body":
            force, torque = offset(force), offset(torque)
        yield on_body((applied("wrench", "b0", frame=frame, **given),), force,
                      torque + skew(r) @ force, t=t)


def fields() -> Iterator[Case]:
    """A body of six points so close together that what MacCullagh's formula neglects, of fourth
    order in their distance, is below 45 digits."""
    tiny, mass, mu = Fraction(1, 10**12), 3, 70
    turn = np.array([[Fraction(x, 3) for x in row] for row in ((2, -1, 2), (2, 2, -1), (-1, 2, 2))])
    com = numbers("0.5", -1, 2)
    arms = [tiny * a * sign * turn[:, k] for k, a in enumerate((1, 2, 4)) for sign in (1, -1)]
    J = sum(Fraction(mass, 6) * (np.eye(3, dtype=int) * (x @ x) - np.outer(x, x)) for x in arms)
    body = inertia(mass, com, (J[0, 0], J[1, 1], J[2, 2], J[0, 1], J[0, 2], J[1, 2]))
    centre = array([mpf(9), mpf(-7), mpf(8)])
    force, torque, stored = array([mpf(0)] * 3), array([mpf(0)] * 3), mpf(0)
    for arm in arms:
        x = offset([mpf(c.numerator) / c.denominator for c in np.array(com) + arm])
        away = array(PLACE) + x - centre
        r = mpmath.sqrt(away @ away)
        pull = -mu * mpf(mass) / 6 / r**3 * away
        force, torque = force + pull, torque + skew(x) @ pull
        stored = stored - mu * mpf(mass) / 6 / r
    model = Model("point", (Body("b0", body),), (Joint("j0", Kind.FREE, "world", "b0", HERE, X),))
    yield on_body((applied("field", "b0", mu=mu, centre=(9, -7, 8)),), force, torque, stored,
                  model=model)


def weights() -> Iterator[Case]:
    """Gravity has no force of its own in recordings: energy -m g·c, power m g·c'."""
    com = [mpf("0.5"), mpf(-1), mpf(2)]
    g = array([mpf(1), mpf(-2), mpf("-9.81")])
    model = free_body(2, numbers("0.5", -1, 2))
    r = offset(com)
    case = on_body((gravity(1, -2, "-9.81"),), 2 * g, skew(r) @ (2 * g), -2 * (g @ (
        array(PLACE) + r)), model=model)
    power = 2 * g @ point_velocity(com)
    assert abs(power - case.own["power"][0]) < mpf(10)**-48
    yield Case(model, case.effects, case.state, {"power": [power], "energy": case.own["energy"]},
               mpf(0), case.along)


def pairs() -> Iterator[Case]:
    """A spring between a point of the world and one of a body."""
    for k, d in ((7, 3), (7, None), (None, 3)):
        arm = [mpf(1), mpf("0.5"), mpf(-2)]
        x = array(PLACE) + offset(arm) - array([mpf(1), mpf(2), mpf(3)])
        length = mpmath.sqrt(x @ x)
        rate = x @ point_velocity(arm) / length
        tension = (k or 0) * (length - 2) + (d or 0) * rate
        stored = work(lambda l, k=k: (k or 0) * (l - 2), 2, length)
        force = -tension / length * x
        effect = applied("spring_damper", "a", bodies=("world", "b0"), first=(1, 2, 3),
                         second=numbers(1, "0.5", -2), k=k, d=d, length=2)
        case = on_body((effect,), force, skew(offset(arm)) @ force, stored)
        yield Case(case.model, case.effects, case.state,
                   {"force": [tension], "power": [-tension * rate], "energy": [stored]},
                   -(d or 0) * rate**2, case.along)


CASES: Mapping[str, Callable[[], Iterator[Case]]] = {
    "actuator": lambda: chain(actuators(), compensating()), "armature": armatures,
    "added_mass": added_masses,
    "buoyancy": buoyancies, "coulomb": frictions, "drag": drags, "field": fields,
    "gravity": weights, "joint_drag": frictions, "limit": limits, "speed_limit": frictions,
    "spring": springs, "spring_damper": pairs, "stribeck": frictions, "viscous": frictions,
    "wrench": wrenches}
"""Cases of each effect that exerts or stores anything; some yield others', too."""


def test_every_effect_has_a_case() -> None:
    acting = [name for name, x in CATALOGUE.items() if not (x.mimic or x.reaction or x.wind)]
    assert_listed(CASES, acting, "CASES", FILE)
    for name, cases in CASES.items():
        assert any(case.effects[-1].effect.name == name for case in cases()), name


def cases_of(name: str) -> list[Case]:
    return [case for case in CASES[name]() if case.effects[-1].effect.name == name]


@pytest.mark.parametrize("name", sorted(CASES))
def test_quantities_of_an_effect_are_their_formulas(name: str) -> None:
    for case in cases_of(name):
        f = multiprecise(case.model, *case.effects)
        function, own = next((x, y) for x, y in functions_of_effects(f.scene).items()
                             if y.effect.name == name)
        units = units_of(own, f.scene)
        assert {x: len(y) for x, y in units.items()} == {x: len(y) for x, y in case.own.items()}
        result = iter(f.components(function, **case.state))
        for quantity in units:
            wanted = case.own[quantity]
            assert_same([next(result) for _ in wanted], wanted)


@pytest.mark.parametrize("name", sorted(CASES))
def test_energy_power_and_torques_of_a_scene_are_those_of_its_effect(name: str) -> None:
    for case in cases_of(name):
        f = multiprecise(case.model, *case.effects)
        without = multiprecise(case.model, *case.effects[:-1])
        kinetic, potential = f("energy", **case.state)
        if case.kinetic is None:
            assert_same([potential], [case.own.get("energy", [mpf(0)])[0] + case.others])
        else:
            assert_same([kinetic, potential], [case.kinetic, 0])
        assert_same([f("power", **case.state)], [case.lost])
        torques = [x - y for x, y in zip(without("bias_torques", **case.state),
                                         f("bias_torques", **case.state), strict=True)]
        assert_same(torques, case.along)
