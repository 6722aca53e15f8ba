"""Each effect on joints alone: its closed form at 50 digits, and its law along motions.

Motions are integrated with the classical Runge-Kutta method.  The error with 2n steps must be at
most the difference between the results with n and with 2n steps: no tolerance is chosen.
"""

from collections.abc import Iterator
from fractions import Fraction

import mpmath
import numpy as np
import pytest
from mpmath import mpf

from coscrew_codegen.scene.scene import Applied
from tests.support.scenes.effect_laws import assert_reaches, assert_same, moving, multiprecise
from tests.support.scenes.evaluation import DOUBLE, Evaluated
from tests.support.scenes.mechanisms import (
    CATALOGUE,
    Formula,
    applied,
    free_body,
    gravity,
    pendulum,
    rotor,
    scene,
    slider,
)
from tests.support.truth.exact import array, rotation_of

HALF, TENTH = Fraction(1, 2), Fraction(1, 10)


@pytest.fixture(autouse=True)
def fifty_digits() -> Iterator[None]:
    with mpmath.workdps(50):
        yield


def friction(state: mpf, *effects: Applied, q: object = 0) -> mpf:
    """The torque of effects at a rotor with this speed."""
    return -multiprecise(rotor(), *effects)("bias_torques", q=[q], v=[state])[0]


# gravity


@pytest.mark.parametrize("amplitude, order", [("0.1", 4), ("1.5", 4), ("3.1", 5)])
def test_period_of_the_pendulum_is_an_elliptic_integral(amplitude: str, order: int) -> None:
    """Near the upright position the period depends on the energy, which the method keeps to order
    5."""
    start, length = mpf(float(amplitude)), Fraction(7, 10)
    period = 4 * mpmath.ellipk(mpmath.sin(start / 2)**2) / mpmath.sqrt(mpf("9.81") / mpf("0.7"))

    def after_three_quarters(n: int) -> float:
        state = moving(pendulum(2, length), gravity(), q=[float(start)])
        return state.rk4(float(3 * period / 4) / n, n).q[0]

    assert_reaches(0, after_three_quarters, 600, order)


def test_gravity_acts_along_its_vector() -> None:
    f = multiprecise(free_body(3, moments=(1, 2, 3, 0, 0, 0)), gravity(1, -2, 3))
    q = [0, 0, 0, *map(mpf, ("0.5", "0.5", "-0.5", "0.5"))]
    R = rotation_of(array(q[3:]))
    a = f("forward_dynamics", q=q, v=[0] * 6, tau=[0] * 6)
    assert_same(a, [*(R.T @ array([1, -2, 3])), 0, 0, 0])


# viscous, coulomb, stribeck


def test_viscous_friction_decays_exponentially() -> None:
    effect = applied("viscous", "j0", d=Fraction(3, 4))
    assert_reaches(5 * mpmath.exp(-mpf(3) / 4 / 2 * 3), lambda n: moving(
        rotor(2), effect, v=[5]).rk4(3 / n, n).v[0], 60)


def test_joint_drag_slows_hyperbolically() -> None:
    """J v' = -c v²: v = v0/(1 + c v0 t/J), in both directions."""
    effect = applied("joint_drag", "j0", c=Fraction(3, 4))
    exact = mpf(5) / (1 + mpf("0.75") * 15 / 2)
    for sign in (1, -1):
        assert_reaches(sign * exact, lambda n, sign=sign: moving(
            rotor(2), effect, v=[sign * 5]).rk4(3 / n, n).v[0], 200)


def test_coulomb_friction_stops_in_time() -> None:
    """sinh(v/ε) e^(t tau_c/(J ε)) is constant, so that the speed is 0.48 ε at the time J ω0/tau_c.
    """
    J, tau_c, eps, start = 2, Fraction(1, 2), Fraction(1, 10), 1
    stop = mpf(J * start) / mpf("0.5")
    left = mpf("0.1") * mpmath.asinh(mpmath.sinh(start / mpf("0.1")) * mpmath.exp(-10))
    assert_reaches(left, lambda n: moving(
        rotor(J), applied("coulomb", "j0", tau_c=tau_c, eps=eps), v=[start]).rk4(
            float(stop) / n, n).v[0], 400)
    assert abs(left / mpf("0.1") - mpmath.asinh(mpf(1) / 2)) < mpf(10)**-8


def test_coulomb_friction_takes_the_same_from_each_cycle() -> None:
    """The amplitude falls by 4 tau_c/k a cycle, except for O(eps²): within eps of rest friction is
    weaker."""
    tau_c, eps, k, m = 0.1, 1e-2, 1.0, 1.0
    state = moving(slider(1), applied("spring", "j0", k=1),
                   applied("coulomb", "j0", tau_c=TENTH, eps=Fraction(1, 100)), q=[2])
    amplitudes = [2.0]
    while len(amplitudes) < 9:
        before = state.v[0]
        state.rk4(2e-3)
        if before * state.v[0] < 0:
            amplitudes.append(np.sqrt(2 * state.energy() / k))
    for first, second in zip(amplitudes, amplitudes[2:], strict=False):
        missing = 4 * tau_c * m * eps**2 * np.pi**2 / 24 / (k * second)**2
        assert abs(first - second - 4 * tau_c / k) <= 2 * missing


@pytest.mark.parametrize("v", ["0", "1e-9", "-0.003", "0.02", "-0.4", "50"])
def test_dry_friction_follows_its_curve(v: str) -> None:
    v, eps, tau_c, tau_s, v_s = map(mpf, (v, "0.01", "0.8", "1.1", "0.05"))
    result = friction(v, applied("coulomb", "j0", tau_c=Fraction(4, 5), eps=Fraction(1, 100)))
    assert_same([result], [-tau_c * mpmath.tanh(v / eps)])
    level = tau_c + (tau_s - tau_c) * mpmath.exp(-(v / v_s)**2)
    result = friction(v, applied("stribeck", "j0", tau_c=Fraction(4, 5), tau_s=Fraction(11, 10),
                                 v_s=Fraction(1, 20), eps=Fraction(1, 100)))
    assert_same([result], [-level * mpmath.tanh(v / eps)])


def test_dry_friction_creeps_where_it_holds() -> None:
    """The speed is eps artanh(tau/tau_c); with Stribeck friction eps artanh(tau/tau_s), up to
    O((creep/v_s)²)."""
    drive = applied("actuator", "j0", kind="torque", torque=Fraction(3, 4))
    eps = Fraction(1, 1000)
    held = moving(rotor(2), drive, applied("coulomb", "j0", tau_c=1, eps=eps)).implicit(1e-2, 500)
    creep = 1e-3 * np.arctanh(0.75)
    assert abs(held.v[0] - creep) <= 1e-12 * creep
    held = moving(rotor(2), drive, applied("stribeck", "j0", tau_c=HALF, tau_s=1, v_s=TENTH,
                                           eps=eps)).implicit(1e-2, 2000)
    weaker = HALF * Fraction(held.v[0])**2 / Fraction(1, 100)  # by which the level is below tau_s
    assert 0 <= held.v[0] - creep <= float(2 * eps * weaker / (1 - Fraction(9, 16)))


# spring, armature, actuator, limit


def test_spring_swings_with_its_frequency() -> None:
    swing = applied("spring", "j0", k=18, q0=TENTH)
    assert_reaches(mpf("0.1") + mpf("0.9") * mpmath.cos(3 * mpf(5)), lambda n: moving(
        rotor(2), swing, q=[1]).rk4(5 / n, n).q[0], 1500)


@pytest.mark.parametrize("values, added", [({"inertia": 6}, 6), ({"rotor": TENTH, "gear": 10}, 10),
                                           ({"inertia": 6, "rotor": TENTH, "gear": -10}, 16)])
def test_armature_slows_the_swing(values: dict, added: int) -> None:
    effects = applied("spring", "j0", k=18), applied("armature", "j0", **values)
    f = multiprecise(rotor(2), *effects)
    assert_same(f("forward_dynamics", q=[1], v=[0], tau=[0]), [mpf(-18) / (2 + added)])
    assert_same(f("mass_matrix", q=[1]), [2 + added])
    assert_same(f("inverse_dynamics", q=[0], v=[7], a=[3]), [3 * (2 + added)])
    assert_same(f("energy", q=[0], v=[3]), [mpf(9) / 2 * (2 + added), 0])


def test_torque_is_a_function_of_time() -> None:
    drive = applied("actuator", "j0", kind="torque", torque=Formula("3*sin(2*pi*t)"))
    assert_reaches(3 * (1 - mpmath.cos(2 * mpmath.pi * mpf("0.7"))) / (4 * mpmath.pi),
                   lambda n: moving(rotor(2), drive).rk4(0.7 / n, n).v[0], 60)


def test_pd_controller_reaches_its_target() -> None:
    """Critically damped: the error is e (1 + ω t) e^(-ω t)."""
    drive = applied("actuator", "j0", kind="pd", kp=50, kd=20, target=2)
    left = 2 * (1 + 5) * mpmath.exp(-5)
    assert_reaches(2 - left, lambda n: moving(rotor(2), drive).rk4(1 / n, n).q[0], 200)


def test_pd_controller_follows_a_moving_target() -> None:
    """It starts at the target and stays there if the torque is that of the target's acceleration.
    """
    drive = applied("actuator", "j0", kind="pd", kp=5, kd=2, target=Formula("t**2"),
                    target_v=Formula("2*t"))
    feed = applied("actuator", "j0", kind="torque", torque=4)
    f = multiprecise(rotor(2), drive, feed)
    for t in map(mpf, ("0", "0.3", "2")):
        assert_same(f("forward_dynamics", t=t, q=[t**2], v=[2 * t], tau=[0]), [2])


def test_no_load_speed_of_the_motor() -> None:
    """V/(ke n), reached with the time constant R J/(n² kt ke)."""
    drive = applied("actuator", "j0", kind="dc", voltage=12, gear=10, kt=Fraction(1, 20),
                    ke=Fraction(1, 25), R=2)
    speed = mpf(12) / (10 / mpf(25))
    f = multiprecise(rotor(3), drive)
    assert_same(f("forward_dynamics", q=[0], v=[speed], tau=[0]), [0])
    rate = mpf(100) / 20 / 25 / 2 / 3
    assert_reaches(speed * (1 - mpmath.exp(-rate * 20)),
                   lambda n: moving(rotor(3), drive).rk4(20 / n, n).v[0], 60)


@pytest.mark.parametrize("values", [
    {"kind": "torque", "torque": Formula("9 - 18*t")},
    {"kind": "pd", "kp": 5, "kd": TENTH, "target": 40},
    {"kind": "dc", "voltage": 24, "kt": 1, "ke": 1, "R": 1}])
def test_actuators_saturate(values: dict) -> None:
    f = multiprecise(rotor(2), applied("actuator", "j0", limit=4, **values))
    demand = multiprecise(rotor(2), applied("actuator", "j0", **values))
    seen = set()
    for t, q, v in ((0, 0, 0), (mpf("0.4"), mpf("39.5"), mpf("23.5")), (1, 90, 90)):
        state = {"t": t, "q": [q], "v": [v], "tau": [0]}
        requested = 2 * demand("forward_dynamics", **state)[0]
        assert_same(f("forward_dynamics", **state), [max(-4, min(requested, 4)) / mpf(2)])
        seen.add(mpmath.sign(requested) if abs(requested) > 4 else 0)
    assert seen == {1, 0, -1}


def test_bang_bang_is_a_parabola() -> None:
    """A stiff controller is saturated and gives its limit L: q = L t²/(2 J)."""
    drive = applied("actuator", "j0", kind="pd", kp=10**6, kd=10, target=100, limit=4)
    state = moving(rotor(2), drive).rk4(0.125, 16)
    assert max(abs(state.q[0] - 4), abs(state.v[0] - 4)) <= 16 * 2**-50


def outgoing(alpha: mpf, v: mpf) -> mpf:
    """The speed after a bounce; v/c - ln(1 + c v)/c², c = 1.5 alpha, is the same before and after
    it."""
    c = 3 * alpha / 2

    def kept(x: mpf) -> mpf:
        return x / c - mpmath.log(1 + c * x) / c**2

    return mpmath.findroot(lambda x: kept(-x) - kept(v), (v / 2, v), solver="anderson", tol=1e-60)


@pytest.mark.parametrize("side", [-1, 1])
def test_limits_bounce(side: int) -> None:
    """The speed after a bounce is 1 - alpha v times that before it, to first order; the integral of
    the law gives it exactly."""
    alpha, speed = mpf("0.2"), mpf("0.5")
    truth = outgoing(alpha, speed)
    assert abs(truth / speed - (1 - alpha * speed)) <= (alpha * speed)**2
    effect = applied("limit", "j0", lower=-1, upper=1, k=1000, alpha=Fraction(1, 5))

    def bounced(steps: int) -> float:
        state = moving(rotor(2), effect, q=[side], v=[side * float(speed)])
        return -side * state.rk4(1 / steps, steps).v[0]

    coarse, fine = bounced(1000), bounced(4000)
    assert abs(fine - truth) <= abs(fine - coarse) <= 1e-6


@pytest.mark.parametrize("ends", [{"lower": -1}, {"upper": 1}, {"lower": -1, "upper": 1}])
@pytest.mark.parametrize("q, v", [("-1", "-2"), ("-1.3", "-2"), ("-1.3", "3"), ("-1.3", "9"),
                                  ("0.2", "5"), ("1", "1"), ("1.6", "-3"), ("1.6", "-9"),
                                  ("1.6", "4")])
def test_limits_push_and_never_pull(ends: dict, q: str, v: str) -> None:
    q, v, k, alpha = mpf(q), mpf(v), 7, mpf("0.2")
    depth, side = max((mpf(ends.get("lower", -9)) - q, 1), (q - mpf(ends.get("upper", 9)), -1))
    push = k * depth**mpf("1.5") * (1 - 3 * alpha / 2 * side * v) if depth > 0 else mpf(0)
    result = friction(v, applied("limit", "j0", **ends, k=7, alpha=Fraction(1, 5)), q=q)
    assert_same([result], [side * max(push, 0)])


def test_catalogue_is_complete() -> None:
    """Every effect has a description, and units for all its numbers."""
    assert list(CATALOGUE) == sorted(CATALOGUE)
    for effect in CATALOGUE.values():
        assert effect.words and effect.equation
        for parameter in effect.parameters:
            assert parameter.words
            assert parameter.unit or parameter.kind in ("choice", "body", "flag")
        assert set(effect.any_of) <= {parameter.name for parameter in effect.parameters}


def test_double_precision_is_the_same_program() -> None:
    """Results in double precision are near those with 50 digits: no constant is a float by mistake.
    """
    third = Fraction(1, 3)
    effect = applied("stribeck", "j0", tau_c=third, tau_s=2 * third, v_s=third / 2, eps=third / 3)
    result = Evaluated(scene(rotor(), effect), DOUBLE)("bias_torques", q=[0], v=[0.1])[0]
    assert abs(result - -friction(mpf(0.1), effect)) <= 8 * 2**-53
