"""Scenes with free bodies, and smooth motions of chains."""

from dataclasses import replace

from tests.support.motions.drawing import Wanted, link, scale
from tests.support.motions.mechanism import (
    Acting,
    Body,
    Joint,
    Mechanism,
    Motion,
    Vector,
    Y,
    rounded,
)
from tests.support.motions.servos import GRAVITY, RATIOS, chain, pd
from tests.support.motions.springs import block

UPRIGHT = (0.0, 0.0, 0.0, 1.0)
TURNED = (0.5, -0.5, 0.1, 0.7)


def tumbling(wanted: Wanted) -> Motion:
    """A body tumbles, its centre of mass beside its frame's origin."""
    draw, shape = wanted.draw, wanted.shape
    moments = (shape.between(0.02, 0.03), shape.between(0.035, 0.045), shape.between(0.05, 0.055))
    com = (0.05, -0.02, shape.between(0.0, 0.2))
    spin = draw.over(5, 100)
    direction = (draw.between(-1, 1), draw.between(-1, 1), draw.between(-1, 1))
    size = sum(x * x for x in direction)**0.5
    w = tuple(rounded(spin * x / size) for x in direction)
    step = rounded(wanted.per_step / spin)
    mechanism = Mechanism((Body("nut", 1.0, moments, com),), (Joint("base", "free", "nut"),),
                          (GRAVITY,) if draw.one((0, 1)) else ())
    return wanted.motion(mechanism, {"base": (0.0, 0.0, 0.0, *UPRIGHT)},
                         {"base": (draw.one((0.0, 3.0)), 0.0, 0.0, *w)}, duration=200 * step,
                         step=step, rate=spin, length=0.3, adaptive=wanted.number % 6 == 0)


def _appendage(wanted: Wanted, *more: Body) -> Motion:
    """A link of 0.2 kg on a free base of 10 kg."""
    draw = wanted.draw
    hinge = Joint("hinge", "continuous", "link", "base", Y, (0.3, 0.0, 0.0))
    mechanism = Mechanism(
        (Body("base", 10.0, (0.5, 0.5, 0.5)), Body("link", 0.2, (0.001, 0.001, 0.001),
                                                   (0.0, 0.0, -0.1)), *more),
        (Joint("root", "free", "base"), hinge, *(Joint(f"to_{x.name}", "free", x.name, xyz=(
            5.0, 0.0, 0.0)) for x in more)), ())
    at = draw.one((0.01, 0.1))
    start = {"root": (0.0, 0.0, 0.0, *draw.one((UPRIGHT, TURNED))), "hinge": (at,)}
    kp = rounded(scale(mechanism, start, {"hinge": 1.0}, wanted.rate))
    servo = pd("hinge", kp, rounded(2 * draw.one((0.0, 0.01, 0.3, 1.0)) * kp / wanted.rate), 0.0)
    speed = draw.one((0.0, 100.0, 300.0))
    v = {"root": (speed, 0.0, 0.0, 0.0, 0.0, 0.0), **{f"to_{x.name}": (
        0.0, 0.0, 0.0, 0.1, 0.0, 0.2) for x in more}}
    return wanted.motion(replace(mechanism, acting=(servo,)), start, v,
                         duration=wanted.seconds(0.1, 0.2), length=0.3,
                         about=f"moving at {speed:g}")


def appendage(wanted: Wanted) -> Motion:
    """A stiff link on a free base that moves at up to 300 m/s."""
    return _appendage(wanted)


def appendage_and_neighbour(wanted: Wanted) -> Motion:
    """Adds a free body of a ton."""
    return _appendage(wanted, Body("ton", 1000.0, (100.0, 120.0, 150.0)))


def two_appendages(wanted: Wanted) -> Motion:
    """A falling, tumbling base with two servos."""
    draw, shape = wanted.draw, wanted.shape
    places: tuple[Vector, Vector] = ((0.3, 0.0, 0.1), (-0.3, 0.1, 0.0))
    mechanism = Mechanism(
        (Body("base", 5.0, (0.2, 0.3, 0.4), (0.02, 0.0, -0.03)), link("left", 0.5, 0.4),
         link("right", shape.between(0.1, 1), 0.3)),
        (Joint("root", "free", "base"), *(Joint(f"j{n}", "continuous", x, "base", Y, places[n])
                                          for n, x in enumerate(("left", "right")))), (GRAVITY,))
    start = {"root": (0.0, 0.0, 0.0, *TURNED), "j0": (0.2,), "j1": (-0.1,)}
    by = scale(mechanism, start, {"j0": 1.0, "j1": 0.3}, wanted.rate)
    ratio = draw.one(RATIOS)
    servos = [pd(name, rounded(by * w), rounded(2 * ratio * by * w / wanted.rate), 0.0)
              for name, w in (("j0", 1.0), ("j1", 0.3))]
    return wanted.motion(
        replace(mechanism, acting=(GRAVITY, *servos)), start,
        {"root": (1.0, 0.0, 0.0, draw.between(-2, 2), draw.between(-2, 2), draw.between(-2, 2))},
        duration=wanted.seconds(0.1, 0.3), length=0.5)


def far_away(wanted: Wanted) -> Motion:
    """A block creeps far from the origin, where single precision may round its steps away."""
    place = rounded(10.0**(wanted.number % 12 / 2 - 0.5), 2)
    still = Acting("viscous", "slide", {"d": 0.5}, ("d",))
    return wanted.motion(block(1.0, still), {"slide": (place,)}, {"slide": (wanted.draw.one(
        (0.01, 0.1, 1.0)),)}, duration=1.0, rate=1.0, length=0.1, about=f"at {place:g} m")


def far_and_free(wanted: Wanted) -> Motion:
    """A body drifts far from the origin in a thick fluid."""
    place = rounded(10.0**(wanted.number % 12 / 2 - 0.5), 2)
    fluid = Acting("drag", "body", {"kind": "stokes", "b": 0.5}, ("b",))
    mechanism = Mechanism((Body("body", 1.0, (0.02, 0.03, 0.04), (0.0, 0.0, 0.1)),),
                          (Joint("base", "free", "body"),), (fluid,))
    speed = wanted.draw.one((0.01, 0.3))
    return wanted.motion(mechanism, {"base": (place, 50.0, 10.0, *UPRIGHT)},
                         {"base": (speed, 0.02, 0.0, 0.1, 0.2, 0.3)}, duration=1.0, rate=1.0,
                         length=0.1, about=f"at {place:g} m")


def _swinging(wanted: Wanted, count: int, rate: float, duration: float, largest: float,
              chaotic: bool = False) -> Motion:
    """A chain of links that swings freely, at steps for the family's rates."""
    lengths = tuple(wanted.shape.between(0.2, 0.6) for _ in range(count))
    arm = chain(tuple(link(f"b{n}", wanted.shape.between(0.3, 3), x)
                     for n, x in enumerate(lengths)), lengths)
    start = {f"j{n}": (wanted.draw.either_way(0.3, largest),) for n in range(count)}
    step = rounded(min(wanted.per_step, 3.0) / rate)
    count_of_steps = max(60, round(duration / step))
    return wanted.motion(arm, start, duration=count_of_steps * step, step=step, rate=rate,
                         chaotic=chaotic, adaptive=wanted.number % 6 == 0 and not chaotic)


def pendulum(wanted: Wanted) -> Motion:
    return _swinging(wanted, 1, 7.0, 2.0, 2.0)


def double_pendulum(wanted: Wanted) -> Motion:
    return _swinging(wanted, 2, 15.0, 1.0, 0.8)


def triple_pendulum(wanted: Wanted) -> Motion:
    return _swinging(wanted, 3, 25.0, 0.6, 0.6)


def chaotic_double(wanted: Wanted) -> Motion:
    return _swinging(wanted, 2, 20.0, 10.0, 3.0, chaotic=True)


def chaotic_triple(wanted: Wanted) -> Motion:
    return _swinging(wanted, 3, 40.0, 6.0, 3.0, chaotic=True)


def driven_arm(wanted: Wanted) -> Motion:
    """An arm moved by smooth torques."""
    lengths = tuple(wanted.shape.between(0.2, 0.6) for _ in range(3))
    arm = chain(tuple(link(f"b{n}", wanted.shape.between(0.5, 3), x)
                     for n, x in enumerate(lengths)), lengths)
    acting: list[Acting] = [GRAVITY]
    for n in range(3):
        torque = f"{wanted.shape.between(0.5, 3)}*sin({wanted.shape.between(2, 8)}*t)"
        acting += [Acting("actuator", f"j{n}", {"kind": "torque", "torque": torque}),
                   Acting("viscous", f"j{n}", {"d": wanted.shape.between(0.05, 0.3)})]
    step = rounded(min(wanted.per_step, 3.0) / 25.0)
    return wanted.motion(replace(arm, acting=tuple(acting)), {
        f"j{n}": (wanted.draw.between(-0.5, 0.5),) for n in range(3)},
        duration=max(60, round(1.0 / step)) * step, step=step, rate=25.0,
        adaptive=wanted.number % 6 == 0)


def top(wanted: Wanted) -> Motion:
    """A heavy top on a ball joint."""
    draw = wanted.draw
    spin = draw.over(20, 200)
    step = rounded(min(wanted.per_step, 5.0) / spin)
    mechanism = Mechanism((Body("top", 0.5, (2e-3, 2e-3, 1e-3), (0.0, 0.0, 0.05)),),
                          (Joint("ball", "spherical", "top"),), (GRAVITY,))
    return wanted.motion(mechanism, {"ball": (0.2, 0.0, 0.0, 0.9797958971132712)},
                         {"ball": (draw.between(0, 1), 0.0, spin)},
                         duration=max(60, min(400, round(1.0 / step))) * step, step=step, rate=spin)


FAMILIES = (tumbling, appendage, appendage_and_neighbour, two_appendages, far_away, far_and_free,
            pendulum, double_pendulum, triple_pendulum, chaotic_double, chaotic_triple, driven_arm,
            top)
