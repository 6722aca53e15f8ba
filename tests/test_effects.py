"""Each effect alone: its closed form at 50 digits, and its law along motions.

Motions are integrated by Runge and Kutta's method; what is missing at 2n steps must then be what n
and 2n steps differ by, so that no tolerance is chosen.
"""

from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction

import mpmath
import numpy as np
import pytest
from mpmath import mpf

from coscrew_codegen.dynamics.model import HERE, Body, Joint, Kind, Model, Parameter
from coscrew_codegen.dynamics.scene import Applied
from tests.evaluation import DOUBLE, MULTIPRECISE, Evaluated, Moving
from tests.exact import array, rotation_of, skew
from tests.mechanisms import (CATALOGUE, Formula, Y, Z, applied, at, ball, chain, free_body, geared,
                              gravity, inertia, numbers, pendulum, rotor, scene, slider)

TINY = mpf(10)**-45
HALF, TENTH = Fraction(1, 2), Fraction(1, 10)


@pytest.fixture(autouse=True)
def fifty_digits() -> Iterator[None]:
    with mpmath.workdps(50):
        yield


def multiprecise(model: Model, *effects: Applied, **others: object) -> Evaluated:
    return Evaluated(scene(model, *effects, **others), MULTIPRECISE)


def assert_same(found: Sequence, wanted: Sequence) -> None:
    """Equal to 45 digits of the largest."""
    size = max(1, *(abs(x) for x in wanted))
    assert len(found) == len(wanted)
    for x, y in zip(found, wanted, strict=True):
        assert abs(x - y) <= TINY * size, (x, y)


def assert_reaches(truth: float, run: Callable[[int], float], steps: int, order: int = 4) -> None:
    """run(n) tends to the truth with n^-order, and to nothing else: at 2n, to a quarter of its
    error, which must be below a millionth."""
    coarse, fine = run(steps), run(2 * steps)
    error = (fine - coarse) / (2**order - 1)
    assert abs(fine + error - float(truth)) <= abs(error) / 4, (coarse, fine, float(truth))
    assert abs(error) <= 1e-6 * max(1, abs(truth))


def moving(model: Model, *effects: Applied, q: Sequence = (0,), v: Sequence = (0,)) -> Moving:
    return Moving(scene(model, *effects), q, v)


def friction(state: mpf, *effects: Applied, q: object = 0) -> mpf:
    """The torque of effects at a rotor with this speed."""
    return -multiprecise(rotor(), *effects)("bias_torques", q=[q], v=[state])[0]


# gravity


@pytest.mark.parametrize("amplitude, order", [("0.1", 4), ("1.5", 4), ("3.1", 5)])
def test_period_of_the_pendulum_is_an_elliptic_integral(amplitude: str, order: int) -> None:
    """Near upright what counts is the energy, which the method keeps to order 5."""
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


def test_coulomb_friction_stops_in_time() -> None:
    """sinh(v/ε) e^(t tau_c/(J ε)) stays the same, so that J ω0/tau_c is when 0.48 ε is left."""
    J, tau_c, eps, start = 2, Fraction(1, 2), Fraction(1, 10), 1
    stop = mpf(J * start) / mpf("0.5")
    left = mpf("0.1") * mpmath.asinh(mpmath.sinh(start / mpf("0.1")) * mpmath.exp(-10))
    assert_reaches(left, lambda n: moving(
        rotor(J), applied("coulomb", "j0", tau_c=tau_c, eps=eps), v=[start]).rk4(
            float(stop) / n, n).v[0], 400)
    assert abs(left / mpf("0.1") - mpmath.asinh(HALF.numerator / mpf(2))) < mpf(10)**-8


def test_coulomb_friction_takes_the_same_from_each_cycle() -> None:
    """4 tau_c/k, but for a fading friction within eps of rest: less by O(eps²)."""
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
    found = friction(v, applied("coulomb", "j0", tau_c=Fraction(4, 5), eps=Fraction(1, 100)))
    assert_same([found], [-tau_c * mpmath.tanh(v / eps)])
    level = tau_c + (tau_s - tau_c) * mpmath.exp(-(v / v_s)**2)
    found = friction(v, applied("stribeck", "j0", tau_c=Fraction(4, 5), tau_s=Fraction(11, 10),
                                v_s=Fraction(1, 20), eps=Fraction(1, 100)))
    assert_same([found], [-level * mpmath.tanh(v / eps)])


def test_dry_friction_creeps_where_it_holds() -> None:
    """At eps artanh(tau/tau_c); with Stribeck's, at eps artanh(tau/tau_s) but for (creep/v_s)²."""
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
    """Critically damped: e (1 + ω t) e^(-ω t) is left of the error."""
    drive = applied("actuator", "j0", kind="pd", kp=50, kd=20, target=2)
    left = 2 * (1 + 5) * mpmath.exp(-5)
    assert_reaches(2 - left, lambda n: moving(rotor(2), drive).rk4(1 / n, n).q[0], 200)


def test_pd_controller_follows_a_moving_target() -> None:
    """Started on it, it stays there, if the torque is what the target's acceleration takes."""
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
        asked = 2 * demand("forward_dynamics", **state)[0]
        assert_same(f("forward_dynamics", **state), [max(-4, min(asked, 4)) / mpf(2)])
        seen.add(mpmath.sign(asked) if abs(asked) > 4 else 0)
    assert seen == {1, 0, -1}


def test_bang_bang_is_a_parabola() -> None:
    """A stiff saturated controller drives with all it has: q = L t²/(2 J)."""
    drive = applied("actuator", "j0", kind="pd", kp=10**6, kd=10, target=100, limit=4)
    state = moving(rotor(2), drive).rk4(0.125, 16)
    assert max(abs(state.q[0] - 4), abs(state.v[0] - 4)) <= 16 * 2**-50


def outgoing(alpha: mpf, v: mpf) -> mpf:
    """The speed after a bounce: v/c - ln(1 + c v)/c² is kept by a bounce, c = 1.5 alpha."""
    c = 3 * alpha / 2

    def kept(x: mpf) -> mpf:
        return x / c - mpmath.log(1 + c * x) / c**2

    return mpmath.findroot(lambda x: kept(-x) - kept(v), (v / 2, v), solver="anderson", tol=1e-60)


@pytest.mark.parametrize("side", [-1, 1])
def test_limits_bounce(side: int) -> None:
    """With 1 - alpha v of the speed to first order; exactly, as the law's integral says."""
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
    found = friction(v, applied("limit", "j0", **ends, k=7, alpha=Fraction(1, 5)), q=q)
    assert_same([found], [side * max(push, 0)])


# forces on bodies


def test_constant_force_gives_a_parabola() -> None:
    push = applied("wrench", "b0", force=(1, -2, 3))
    state = moving(free_body(2), push, q=[0, 0, 0, 1, 0, 0, 0], v=[0, 1, 0, 0, 0, 0]).rk4(0.5, 4)
    exact = [1, 0, 3]  # F t²/(2 m) + v t
    assert np.max(np.abs(np.array(state.q[:3]) - exact)) <= 4 * 4 * 2**-52


def test_constant_torque_spins_up() -> None:
    push = applied("wrench", "b0", torque=(0, 0, 6), frame="body")
    state = moving(ball(moments=(1, 2, 3, 0, 0, 0)), push, q=[1, 0, 0, 0], v=[0, 0, 1]).rk4(0.25, 8)
    assert_same(state.v, [0, 0, 5])
    angle = 1 * 2 + mpf(6) / 3 * 4 / 2
    turned = [mpmath.cos(angle / 2), 0, 0, mpmath.sin(angle / 2)]
    assert np.max(np.abs(np.array(state.q) - np.array(turned, float))) <= 8 * 2**-52 * 8


QUATERNION = [mpf(x) / 10 for x in (1, 5, -7, 5)]  # of norm 1


@pytest.mark.parametrize("frame", ["world", "body"])
def test_wrenches_act_at_their_point(frame: str) -> None:
    """The generalised force on a free body is (f; tau + r × f) in its frame."""
    push = applied("wrench", "b0", force=(Formula("t"), 2, 3), torque=(5, Formula("-t"), 7),
                   point=numbers("0.5", 1, -2), frame=frame)
    t, r = mpf("0.3"), array([mpf("0.5"), 1, -2])
    force, torque = array([t, 2, 3]), array([5, -t, 7])
    if frame == "world":
        R = rotation_of(array(QUATERNION))
        force, torque = R.T @ force, R.T @ torque
    f = multiprecise(free_body(2), push)
    found = f("bias_torques", t=t, q=[1, 2, 3, *QUATERNION], v=[0] * 6)
    assert_same([-x for x in found], [*force, *(torque + skew(r) @ force)])


def test_wrenches_may_be_arguments() -> None:
    force = tuple(Parameter(f"push.force.{x}", n, Fraction(n)) for n, x in enumerate("xyz"))
    f = multiprecise(free_body(2), applied("wrench", "b0", force=force), parameters=force)
    a = f("forward_dynamics", p=[4, 6, 8], q=[0, 0, 0, 1, 0, 0, 0], v=[0] * 6, tau=[0] * 6)
    assert_same(a, [2, 3, 4, 0, 0, 0])


def test_falling_bodies_reach_their_terminal_speed() -> None:
    """v_t tanh(g t/v_t), v_t² = 2 m g/(rho area); by Stokes' law v_t (1 - e^(-b t/m)), v_t = m g/b.
    """
    model = slider(Fraction(1, 5), Z)
    drag = applied("drag", "b0", rho=Fraction(6, 5), area=Fraction(1, 4))
    g, t = mpf("9.81"), mpf("0.8")
    terminal = mpmath.sqrt(2 * g / 5 / (mpf("1.2") / 4))
    assert_reaches(-terminal * mpmath.tanh(g * t / terminal),
                   lambda n: moving(model, gravity(), drag).rk4(float(t) / n, n).v[0], 40)
    stokes = applied("drag", "b0", kind="stokes", b=HALF)
    terminal = g / 5 / mpf("0.5")
    assert_reaches(-terminal * (1 - mpmath.exp(-t / 2 * 5)),
                   lambda n: moving(model, gravity(), stokes).rk4(float(t) / n, n).v[0], 40)


@pytest.mark.parametrize("values, resistance", [
    ({"rho": 3, "area": 2}, lambda u: 3 * mpmath.norm(u.tolist())),
    ({"kind": "stokes", "b": 5}, lambda u: 5)])
def test_drag_resists_the_motion_of_its_point(values: dict, resistance: Callable) -> None:
    f = multiprecise(free_body(2), applied("drag", "b0", point=(1, 2, 3), **values))
    r = array([mpf(1), mpf(2), mpf(3)])
    for v in ([1, 2, 3, 4, 5, 6], [0] * 6, [0, 0, 0, 1, 2, 3]):
        u = array(v[:3]) + skew(array(v[3:])) @ r
        force = -resistance(u) * u
        still = multiprecise(free_body(2))("bias_torques", q=[0, 0, 0, *QUATERNION], v=v)
        found = f("bias_torques", q=[0, 0, 0, *QUATERNION], v=v)
        assert_same([a - b for a, b in zip(still, found, strict=True)],
                    [*force, *(skew(r) @ force)])


def test_buoyancy_lifts_at_its_centre() -> None:
    """Net weight (m - rho V) g; the lift's moment about the body's origin is c × f."""
    lift = applied("buoyancy", "b0", rho=1000, V=Fraction(1, 400), centre=(0, 1, 0))
    f = multiprecise(free_body(4), gravity(), lift)
    R = rotation_of(array(QUATERNION))
    found = f("bias_torques", q=[1, 2, 3, *QUATERNION], v=[0] * 6)
    up = R.T @ array([0, 0, mpf("9.81")])
    assert_same([-x for x in found], [*((mpf("2.5") - 4) * up),
                                      *(skew(array([0, 1, 0])) @ (mpf("2.5") * up))])
    low, high = (f("energy", q=[0, 0, z, 1, 0, 0, 0], v=[0] * 6)[1] for z in (0, 1))
    assert_same([high - low], [(4 - mpf("2.5")) * mpf("9.81")])
    weightless = multiprecise(free_body(4), lift)
    assert weightless("bias_torques", q=[0, 0, 0, 1, 0, 0, 0], v=[0] * 6) == [0] * 6


def two_free_bodies() -> Model:
    moments = (1, 1, 1, 0, 0, 0)
    bodies = tuple(Body(x, inertia(m, moments=moments)) for x, m in (("a", 2), ("b", 3)))
    return Model("two", bodies, tuple(Joint(f"j{x.name}", Kind.FREE, "world", x.name)
                                      for x in bodies))


def test_spring_damper_pulls_along_its_line() -> None:
    effect = applied("spring_damper", "tendon", bodies=("a", "b"), first=numbers("0.1", 1, 0),
                     second=numbers(0, "-0.3", 2), k=7, d=3, length=2)
    q = [1, 2, 3, *QUATERNION, -1, 0, 4, *(QUATERNION[k] for k in (2, 1, 3, 0))]
    v = [mpf(x) / 7 for x in (1, -2, 3, 5, 0, 2, 4, 4, -3, 1, 2, -6)]
    points, speeds, turns = [], [], []
    arms = [array([mpf("0.1"), 1, 0]), array([0, mpf("-0.3"), 2])]
    for n, r in enumerate(arms):
        R = rotation_of(array(q[7 * n + 3:7 * n + 7]))
        turns.append(R)
        points.append(array(q[7 * n:7 * n + 3]) + R @ r)
        speeds.append(R @ (array(v[6 * n:6 * n + 3]) + skew(array(v[6 * n + 3:6 * n + 6])) @ r))
    x, u = points[1] - points[0], speeds[1] - speeds[0]
    length = mpmath.sqrt(x @ x)
    pull = (7 * (length - 2) + 3 * (x @ u) / length) / length * x
    wanted = []
    for R, r, force in zip(turns, arms, (pull, -pull), strict=True):
        wanted += [*(R.T @ force), *(skew(r) @ (R.T @ force))]
    free = multiprecise(two_free_bodies())
    f = multiprecise(two_free_bodies(), effect)
    found = [a - b for a, b in zip(free("bias_torques", q=q, v=v), f("bias_torques", q=q, v=v),
                                   strict=True)]
    assert_same(found, wanted)
    assert_same([f("energy", q=q, v=v)[1], f("power", q=q, v=v)],
                [mpf(7) / 2 * (length - 2)**2, -3 * ((x @ u) / length)**2])


# mimic, reaction


@pytest.mark.parametrize("multiplier", [Fraction(-3, 2), Fraction(1, 10**9), Fraction(0)])
def test_followers_add_their_inertia(multiplier: Fraction) -> None:
    """I1 + α² I2, and their torques α of them."""
    alpha = mpf(multiplier.numerator) / multiplier.denominator
    effects = applied("mimic"), applied("spring", "j1", k=8), applied("viscous", "j1", d=3)
    f = multiprecise(geared(multiplier, HALF, (5, 7)), *effects)
    assert f.functions.nv == f.functions.nq == 1
    assert_same(f("mass_matrix", q=[1]), [5 + 7 * alpha**2])
    q, v = mpf("0.3"), mpf("0.9")
    torque = alpha * (-8 * (alpha * q + mpf("0.5")) - 3 * alpha * v)
    assert_same(f("forward_dynamics", q=[q], v=[v], tau=[1]), [(1 + torque) / (5 + 7 * alpha**2)])
    pose = f("body_poses", q=[q])[12:]
    assert_same([pose[0], pose[4]], [g(alpha * q + mpf("0.5")) for g in (mpmath.cos, mpmath.sin)])


def test_joints_that_may_follow_move_alone_without_mimic() -> None:
    f = multiprecise(geared(3, HALF, (5, 7)))
    assert_same(f("mass_matrix", q=[1, 2]), [5, 0, 0, 7])


def test_reaction_at_the_bottom_is_three_weights() -> None:
    f = multiprecise(pendulum(2, Fraction(7, 10)), gravity(), applied("reaction", "j0"))
    v = mpmath.sqrt(2 * mpf("9.81") / mpf("0.7"))  # let go level
    a = f("forward_dynamics", q=[0], v=[v], tau=[0])
    assert_same(f("reaction_j0", q=[0], v=[v], a=a), [0, 0, 3 * 2 * mpf("9.81"), 0, 0, 0])


def test_reactions_along_the_freedoms_are_torques() -> None:
    """S^T f = tau + the effects' torque, of every joint; others are known from statics."""
    links = [(Kind.REVOLUTE, Y, HERE, inertia(2, (1, 0, 0), (1, 2, 3, 0, 0, 0))),
             (Kind.PRISMATIC, Z, at(1, 0, 0), inertia(3, (0, 1, 0), (1, 1, 1, 0, 0, 0)))]
    effects = [gravity(), applied("viscous", "j0", d=2), applied("spring", "j1", k=4),
               *(applied("reaction", x) for x in ("j0", "j1"))]
    f = multiprecise(chain(*links), *effects)
    state = {"q": [mpf("0.4"), mpf("0.2")], "v": [mpf("-0.7"), mpf("1.1")], "a": [mpf("0.3"), -2]}
    tau = f("inverse_dynamics", **state)
    first, second = f("reaction_j0", **state), f("reaction_j1", **state)
    assert_same([first[4], second[2]], [tau[0] - 2 * mpf("-0.7"), tau[1] - 4 * mpf("0.2")])
    held = f("reaction_j0", q=[0, 0], v=[0, 0], a=[0, 0])
    assert_same(held, [0, 0, 5 * mpf("9.81"), 3 * mpf("9.81"), -(2 + 3) * mpf("9.81"), 0])


def test_catalogue_is_complete() -> None:
    """Every effect says what it is, with units for all that is a number."""
    assert list(CATALOGUE) == sorted(CATALOGUE)
    for effect in CATALOGUE.values():
        assert effect.words and effect.equation
        for parameter in effect.parameters:
            assert parameter.words
            assert parameter.unit or parameter.kind in ("choice", "body")
        assert set(effect.any_of) <= {parameter.name for parameter in effect.parameters}


def test_double_precision_is_the_same_program() -> None:
    """The Program in double is near the one at 50 digits: no constant is a float by accident."""
    third = Fraction(1, 3)
    effect = applied("stribeck", "j0", tau_c=third, tau_s=2 * third, v_s=third / 2, eps=third / 3)
    found = Evaluated(scene(rotor(), effect), DOUBLE)("bias_torques", q=[0], v=[0.1])[0]
    assert abs(found - -friction(mpf(0.1), effect)) <= 8 * 2**-53
