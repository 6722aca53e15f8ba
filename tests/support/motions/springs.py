"""Scenes with springs, ends of ranges, friction and resistance."""

from dataclasses import replace

from tests.support.motions.drawing import STEP, Wanted, link, of_hinge, scale
from tests.support.motions.mechanism import (
    Acting,
    Body,
    Joint,
    Mechanism,
    Motion,
    Z,
    rounded,
)
from tests.support.motions.servos import GRAVITY, one_link

SLIDE = Joint("slide", "prismatic", "block", axis=Z)


def block(mass: float, *acting: Acting, joint: Joint = SLIDE) -> Mechanism:
    return Mechanism((Body("block", mass, (0.01, 0.01, 0.01)),), (joint,), acting)


def spring(wanted: Wanted) -> Motion:
    """A block on a spring, undamped."""
    mass, start = wanted.shape.over(0.1, 10), wanted.draw.one((1e-5, 0.01, 1.0))
    held = Acting("spring", "slide", {"k": rounded(mass * wanted.rate**2)}, ("k",))
    return wanted.motion(block(mass, held), {"slide": (start,)}, duration=wanted.seconds(),
                         about=f"deflection {start}")


def damped_spring(wanted: Wanted) -> Motion:
    mass, ratio = wanted.shape.over(0.1, 10), wanted.draw.one((0.02, 0.1, 0.5, 1.0, 4.0))
    acting = (GRAVITY, Acting("spring", "slide", {"k": rounded(mass * wanted.rate**2)}, ("k",)),
              Acting("viscous", "slide", {"d": rounded(2 * ratio * mass * wanted.rate)}, ("d",)))
    return wanted.motion(block(mass, *acting), {"slide": (wanted.draw.one((0.0, 0.05)),)},
                         duration=wanted.seconds(damped=True), about=f"ratio {ratio}")


def spring_between(wanted: Wanted) -> Motion:
    """Two blocks on a rail under a spring and damper; the pair moves on."""
    a, b = wanted.shape.over(0.1, 10), wanted.shape.over(0.1, 10)
    k = rounded(a * b / (a + b) * wanted.rate**2)
    d = rounded(2 * wanted.draw.one((0.0, 0.1, 1.0)) * k / wanted.rate)
    tie = Acting("spring_damper", "tie", {"bodies": ("left", "right"), "k": k, "d": d,
                                          "length": 0.5}, ("k", "d"))
    mechanism = Mechanism(
        (Body("left", a, (0.01, 0.01, 0.01)), Body("right", b, (0.01, 0.01, 0.01))),
        tuple(Joint(f"to_{x}", "prismatic", x, axis=(1.0, 0.0, 0.0)) for x in ("left", "right")),
        (tie,))
    drift = wanted.draw.one((0.0, 3.0, 300.0))
    return wanted.motion(mechanism, {"to_left": (0.0,), "to_right": (0.5 + wanted.draw.one(
        (0.001, 0.05)),)}, {"to_left": (drift,), "to_right": (drift,)},
        duration=wanted.seconds(0.1, 0.3), about=f"moving at {drift}",
        pair=(("to_left", a), ("to_right", b)))


def spring_to_the_world(wanted: Wanted) -> Motion:
    """A pendulum's tip is tied to a point beside it."""
    mechanism, inertia = one_link(wanted)
    length = -2 * mechanism.bodies[0].com[2]
    k = rounded(inertia / length**2 * wanted.rate**2)
    d = rounded(2 * wanted.draw.one((0.0, 0.2, 1.0)) * k / wanted.rate)
    tie = Acting("spring_damper", "tie", {
        "bodies": ("world", "link"), "first": (length, 0.0, -length),
        "second": (0.0, 0.0, -length), "k": k, "d": d, "length": length}, ("k", "d"))
    return wanted.motion(replace(mechanism, acting=(GRAVITY, tie)), {"hinge": (wanted.draw.one(
        (0.0, 0.1)),)}, duration=wanted.seconds(0.1, 0.3, 0.5))


def beside_a_slow_one(wanted: Wanted) -> Motion:
    """A light tip vibrates at the end of a heavy pendulum."""
    tip = link("tip", wanted.shape.over(0.01, 0.1), 0.1)
    mechanism = Mechanism(
        (link("heavy", 5.0, 1.0), tip),
        (Joint("swing", "continuous", "heavy"),
         Joint("flex", "continuous", "tip", "heavy", xyz=(0.0, 0.0, -1.0))), (GRAVITY,))
    start = {"swing": (0.6,), "flex": (wanted.draw.one((0.0, 0.002, 0.05)),)}
    k = rounded(scale(mechanism, start, {"flex": 1.0}, wanted.rate))
    held = Acting("spring", "flex", {"k": k}, ("k",))
    return wanted.motion(replace(mechanism, acting=(GRAVITY, held)), start,
                         duration=wanted.seconds(0.2, 0.5),
                         about=f"deflection {start['flex'][0]}")


def _limit(joint: str, k: float, alpha: float) -> Acting:
    return Acting("limit", joint, {"k": k, "alpha": alpha}, ("k", "alpha"))


def _impact(mass: float, speed: float, rate: float) -> float:
    """The stiffness with which a contact at this speed takes half a period of the rate."""
    deepest = 3.1416 * speed / (2.94 * rate)
    return rounded(1.25 * mass * speed**2 / deepest**2.5)


def bounce(wanted: Wanted) -> Motion:
    """A ball falls onto the end of its range."""
    mass, height = wanted.shape.over(0.1, 5), wanted.draw.one((0.05, 0.2))
    speed = (2 * 9.81 * height)**0.5
    fall = replace(SLIDE, lower=0.0)
    alpha = rounded(wanted.draw.one((0.1, 0.4, 1.0)) / speed)
    acting = (GRAVITY, _limit("slide", _impact(mass, speed, wanted.rate), alpha))
    return wanted.motion(block(mass, *acting, joint=fall), {"slide": (height,)},
                         duration=wanted.draw.one((0.4, 0.9)), adaptive=wanted.number % 6 == 0)


def stop_late(wanted: Wanted) -> Motion:
    """A pendulum meets the end of its range in the last third of the run."""
    mechanism, inertia = one_link(wanted)
    hinge = replace(mechanism.joints[0], kind="revolute", lower=-0.2, upper=3.0)
    k, alpha = _impact(inertia, 4.0, wanted.rate), wanted.draw.one((0.02, 0.1))
    return wanted.motion(
        replace(mechanism, joints=(hinge,), acting=(GRAVITY, _limit("hinge", k, alpha))),
        {"hinge": (1.0,)}, duration=wanted.draw.one((0.5, 0.8)))


def lying_on_its_end(wanted: Wanted) -> Motion:
    """A ball rests on the end of its range."""
    mass = wanted.shape.over(0.1, 5)
    depth = 9.81 * 1.5 / wanted.rate**2  # rate² = 1.5 k √depth / m, m g = k depth^1.5
    k = rounded(mass * 9.81 / depth**1.5)
    acting = (GRAVITY, _limit("slide", k, wanted.draw.one((0.0, 0.5))))
    return wanted.motion(block(mass, *acting, joint=replace(SLIDE, lower=0.0)),
                         {"slide": (rounded(-depth, 12) if wanted.draw.one((0, 1)) else 0.0,)},
                         duration=wanted.seconds(0.2, 0.5))


def coulomb(wanted: Wanted) -> Motion:
    """A block slides to a stop."""
    mass, brake = wanted.shape.over(0.1, 10), wanted.shape.between(3, 8)
    eps = rounded(brake / wanted.rate)
    dry = Acting("coulomb", "slide", {"tau_c": rounded(mass * brake), "eps": eps}, ("eps",))
    return wanted.motion(block(mass, dry), {"slide": (0.0,)}, {"slide": (wanted.draw.one(
        (0.2, 1.0)),)}, duration=wanted.seconds(0.2, 0.5, damped=True))


def stick_slip(wanted: Wanted) -> Motion:
    """A torque that swings to and fro breaks a link away from dry friction."""
    mass, length = wanted.shape.between(0.5, 2), wanted.shape.between(0.2, 0.4)
    inertia, tau_s = of_hinge(mass, length), wanted.shape.between(1, 4)
    eps = rounded(min(0.02, tau_s / (inertia * wanted.rate)))
    most = rounded(tau_s * wanted.shape.between(1.1, 1.6))
    torque = f"{most}*sin({wanted.shape.between(4, 9)}*t)"
    acting = (Acting("stribeck", "hinge", {
        "tau_c": rounded(tau_s * wanted.draw.one((0.1, 0.4, 0.8))), "tau_s": tau_s, "v_s": 0.1,
        "eps": eps}, ("tau_c", "eps")),
        Acting("actuator", "hinge", {"kind": "torque", "torque": torque}))
    return wanted.motion(Mechanism((link("link", mass, length),), (Joint(
        "hinge", "continuous", "link"),), acting), {"hinge": (0.0,)},
        duration=wanted.draw.one((0.8, 1.5)), rate=rounded(tau_s / (inertia * eps)))


def pulse_late(wanted: Wanted) -> Motion:
    """A short push in the last third of a swing."""
    mechanism, inertia = one_link(wanted)
    width = rounded(STEP / min(wanted.per_step, 2))
    height = rounded(inertia * wanted.shape.between(1, 3) / (1.772 * width))
    push = Acting("actuator", "hinge", {"kind": "torque", "torque":
                                        f"{height}*exp(-((t-0.35)/{width})**2)"})
    return wanted.motion(replace(mechanism, acting=(GRAVITY, push)),
                         {"hinge": (wanted.draw.between(-0.5, 0.5),)},
                         duration=0.5, rate=rounded(2 / width))


def drag(wanted: Wanted) -> Motion:
    """A block that falls fast into a fluid."""
    mass, speed = wanted.shape.over(0.1, 10), wanted.draw.one((1.0, 20.0))
    area = rounded(2 * mass * wanted.rate / (1000 * speed))
    fluid = Acting("drag", "block", {"kind": "quadratic", "rho": 1000.0, "area": area}, ("area",))
    return wanted.motion(block(mass, GRAVITY, fluid), {"slide": (0.0,)}, {"slide": (-speed,)},
                         duration=wanted.seconds(0.2, 0.5, damped=True))


def joint_drag(wanted: Wanted) -> Motion:
    """A link that spins in a fluid."""
    mechanism, inertia = one_link(wanted)
    speed = wanted.draw.one((2.0, 20.0))
    fluid = Acting("joint_drag", "hinge", {"c": rounded(inertia * wanted.rate / speed)}, ("c",))
    return wanted.motion(replace(mechanism, acting=(GRAVITY, fluid)), {"hinge": (0.1,)},
                         {"hinge": (speed,)}, duration=wanted.seconds(0.2, 0.5, damped=True))


def viscous(wanted: Wanted) -> Motion:
    """A link that sinks in grease."""
    mechanism, inertia = one_link(wanted)
    grease = Acting("viscous", "hinge", {"d": rounded(inertia * wanted.rate)}, ("d",))
    return wanted.motion(replace(mechanism, acting=(GRAVITY, grease)), {"hinge": (1.2,)},
                         {"hinge": (wanted.draw.one((0.0, 5.0)),)},
                         duration=wanted.seconds(0.2, 0.5, damped=True))


FAMILIES = (spring, damped_spring, spring_between, spring_to_the_world, beside_a_slow_one, bounce,
            stop_late, lying_on_its_end, coulomb, stick_slip, pulse_late, drag, joint_drag, viscous)
