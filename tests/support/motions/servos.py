"""Scenes with servos and motors."""

from dataclasses import replace

from tests.support.motions.drawing import Wanted, link, of_hinge, scale
from tests.support.motions.mechanism import (
    Acting,
    Body,
    Joint,
    Mechanism,
    Mimic,
    Motion,
    State,
    Value,
    rounded,
)

GRAVITY = Acting("gravity", "")
RATIOS = (0.1, 0.3, 0.7, 1.0, 2.0, 5.0)
"""Of damping."""


def pd(joint: str, kp: float, kd: float, target: Value, *also: tuple[str, Value]) -> Acting:
    values = {"kind": "pd", "kp": kp, "kd": kd, "target": target, **dict(also)}
    return Acting("actuator", joint, values, ("kp", "kd"))


def gains(inertia: float, rate: float, ratio: float) -> tuple[float, float]:
    return rounded(inertia * rate**2), rounded(2 * ratio * inertia * rate)


def one_link(wanted: Wanted, *acting: Acting) -> tuple[Mechanism, float]:
    """A link on a hinge under gravity, and its inertia."""
    mass, length = wanted.shape.over(0.1, 5), wanted.shape.over(0.1, 1)
    return Mechanism((link("link", mass, length),), (Joint("hinge", "continuous", "link"),),
                     (GRAVITY, *acting)), of_hinge(mass, length)


def _servo(wanted: Wanted, target: Value, ratio: float, *also: tuple[str, Value]) -> Mechanism:
    mechanism, inertia = one_link(wanted)
    servo = pd("hinge", *gains(inertia, wanted.rate, ratio), target, *also)
    return replace(mechanism, acting=(*mechanism.acting, servo))


def servo_at_rest(wanted: Wanted) -> Motion:
    """Holds its target against gravity."""
    at = wanted.shape.either_way(0.2, 1.5)
    ratio = wanted.draw.one(RATIOS)
    return wanted.motion(_servo(wanted, at, ratio), {"hinge": (at,)},
                         duration=wanted.seconds(0.2, 0.5, damped=True), about=f"ratio {ratio}")


def servo_off_target(wanted: Wanted) -> Motion:
    at, ratio = wanted.shape.either_way(0.1, 1.0), wanted.draw.one(RATIOS)
    return wanted.motion(_servo(wanted, at, ratio), {"hinge": (0.0,)},
                         duration=wanted.seconds(0.1, 0.3, damped=True),
                         about=f"ratio {ratio}")


def servo_tracking(wanted: Wanted) -> Motion:
    """Follows a sine from a start on it."""
    a, w = wanted.shape.between(0.2, 1), wanted.shape.between(2, 10)
    mechanism = _servo(wanted, f"{a}*sin({w}*t)", wanted.draw.one(RATIOS),
                       ("target_v", f"{a}*{w}*cos({w}*t)"))
    return wanted.motion(mechanism, {"hinge": (0.0,)}, {"hinge": (a * w,)},
                         duration=wanted.seconds(0.3, 0.6, damped=True))


def servo_saturated(wanted: Wanted) -> Motion:
    """Its torque is limited to a few times gravity's."""
    mechanism, inertia = one_link(wanted)
    most = rounded(wanted.shape.between(2, 8) * inertia * 15)
    servo = pd("hinge", *gains(inertia, wanted.rate, wanted.draw.one(RATIOS[2:])),
               wanted.shape.between(0.3, 1), ("limit", most))
    return wanted.motion(replace(mechanism, acting=(GRAVITY, servo)), {"hinge": (0.0,)},
                         duration=wanted.seconds(0.3, 0.8, damped=True))


def _servos(wanted: Wanted, mechanism: Mechanism, weights: State, start: State, target: State,
            ratio: float) -> Mechanism:
    """With servos whose gains are proportional to the weights."""
    by = scale(mechanism, start, {name: w[0] for name, w in weights.items()}, wanted.rate)
    acting = [pd(name, rounded(by * w[0]), rounded(2 * ratio / wanted.rate * by * w[0]),
                 target[name][0]) for name, w in weights.items()]
    return replace(mechanism, acting=(*mechanism.acting, *acting))


def chain(bodies: tuple[Body, ...], lengths: tuple[float, ...]) -> Mechanism:
    """A chain of links about y."""
    joints, parent, down = [], "world", 0.0
    for n, body in enumerate(bodies):
        joints.append(Joint(f"j{n}", "continuous", body.name, parent, xyz=(0.0, 0.0, -down)))
        parent, down = body.name, lengths[n]
    return Mechanism(bodies, tuple(joints), (GRAVITY,))


def servos_of_an_arm(wanted: Wanted) -> Motion:
    """Three links whose servos start off target."""
    lengths = tuple(wanted.shape.between(0.2, 0.6) for _ in range(3))
    arm = chain(tuple(link(f"b{n}", wanted.shape.between(0.3, 3), x)
                     for n, x in enumerate(lengths)), lengths)
    start = {f"j{n}": (wanted.shape.between(-0.5, 0.5),) for n in range(3)}
    off = wanted.draw.one((0.0, 0.02, 0.3))
    target = {name: (rounded(x[0] + off),) for name, x in start.items()}
    weights = {"j0": (1.0,), "j1": (0.4,), "j2": (0.1,)}
    return wanted.motion(_servos(wanted, arm, weights, start, target, wanted.draw.one(RATIOS)),
                         start, duration=wanted.seconds(0.2, 0.5, damped=True))


def light_carries_heavy(wanted: Wanted) -> Motion:
    arm = chain((link("light", 0.02, 0.3), link("heavy", 5.0, 0.4)), (0.3, 0.4))
    start = {"j0": (0.3,), "j1": (-0.4,)}
    off = wanted.draw.one((0.0, 0.1))
    target = {name: (x[0] + off,) for name, x in start.items()}
    return wanted.motion(_servos(wanted, arm, {"j0": (1.0,), "j1": (0.5,)}, start, target,
                                 wanted.draw.one(RATIOS)), start,
                         duration=wanted.seconds(0.2, 0.5, damped=True))


def heavy_carries_light(wanted: Wanted) -> Motion:
    """A swinging link of 10 kg carries one of 20 g, which a servo holds."""
    arm = chain((link("heavy", 10.0, 0.5), link("light", 0.02, 0.1)), (0.5, 0.1))
    start = {"j0": (wanted.draw.one((0.0, 0.8)),), "j1": (wanted.draw.one((0.0, 0.1)),)}
    return wanted.motion(_servos(wanted, arm, {"j1": (1.0,)}, start, {"j1": (0.0,)},
                                 wanted.draw.one((0.0, *RATIOS))), start,
                         duration=wanted.seconds(0.1, 0.3, 0.5))


def dc_motor(wanted: Wanted) -> Motion:
    """Its back electromotive force damps at the rate gear² kt ke / (R I)."""
    mechanism, inertia = one_link(wanted)
    rotor, gear = 1e-5, 50.0
    inertia += gear**2 * rotor
    kt = 0.05
    R = rounded(gear**2 * kt**2 / (inertia * wanted.rate))
    voltage = f"{wanted.shape.between(1, 6)}*sin({wanted.shape.between(3, 9)}*t)"
    motor = Acting("actuator", "hinge", {
        "kind": "dc", "voltage": voltage, "gear": gear, "kt": kt, "ke": kt, "R": R}, ("R",))
    armature = Acting("armature", "hinge", {"rotor": rotor, "gear": gear})
    return wanted.motion(replace(mechanism, acting=(GRAVITY, motor, armature)), {"hinge": (0.2,)},
                         duration=wanted.seconds(0.3, 0.6, damped=True))


def mimic(wanted: Wanted) -> Motion:
    """Two fingers, the second follows the first."""
    shape = wanted.shape
    mass, other, length = shape.between(0.1, 1), shape.between(0.1, 1), shape.between(0.1, 0.5)
    ratio = shape.one((-1.0, 0.5, -2.0))
    inertia = of_hinge(mass, length) + ratio**2 * of_hinge(other, length)
    at = 0.1 + wanted.draw.one((0.0, 0.2))
    servo = pd("a", *gains(inertia, wanted.rate, wanted.draw.one(RATIOS)), at)
    mechanism = Mechanism(
        (link("left", mass, length), link("right", other, length)),
        (Joint("a", "continuous", "left"), Joint("b", "continuous", "right", xyz=(0.2, 0.0, 0.0),
                                                 mimic=Mimic("a", ratio, 0.1))),
        (GRAVITY, Acting("mimic", ""), servo))
    return wanted.motion(mechanism, {"a": (0.1,)}, duration=wanted.seconds(0.2, 0.5, damped=True))


def over_at_the_start(wanted: Wanted) -> Motion:
    """A light link is released off its target and comes to rest within fifty steps; a pendulum
    swings on beside it."""
    shape = wanted.shape
    mechanism = Mechanism(
        (link("bob", shape.between(0.5, 3), 0.5), link("light", 0.05, 0.1)),
        (Joint("swing", "continuous", "bob"),
         Joint("snap", "continuous", "light", xyz=(0.5, 0.0, 0.0))), (GRAVITY,))
    inertia = of_hinge(0.05, 0.1)
    servo = pd("snap", *gains(inertia, wanted.rate, wanted.draw.one((0.4, 0.7, 1.0, 2.0))), 0.0)
    return wanted.motion(replace(mechanism, acting=(GRAVITY, servo)),
                         {"swing": (shape.between(0.3, 1),), "snap": (wanted.draw.one(
                             (0.05, 0.5)),)}, duration=wanted.seconds(0.3, 0.6, damped=True))


FAMILIES = (servo_at_rest, servo_off_target, servo_tracking, servo_saturated, servos_of_an_arm,
            light_carries_heavy, heavy_carries_light, dc_motor, mimic, over_at_the_start)
