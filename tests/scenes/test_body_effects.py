"""Effects on bodies and between bodies, each alone; mimic; reactions: closed forms at 50 digits,
and laws along motions."""

from collections.abc import Callable, Iterator
from fractions import Fraction

import mpmath
import numpy as np
import pytest
from mpmath import mpf

from coscrew_codegen.scene.mechanism.model import HERE, Body, Joint, Model, Parameter
from coscrew_codegen.scene.scene import Applied
from tests.support.scenes.effect_laws import assert_reaches, assert_same, moving, multiprecise
from tests.support.scenes.kinds import Kind
from tests.support.scenes.mechanisms import (
    Formula,
    Y,
    Z,
    applied,
    at,
    ball,
    chain,
    free_body,
    geared,
    gravity,
    inertia,
    numbers,
    pendulum,
    slider,
)
from tests.support.truth.exact import array, rotation_of, skew

HALF = Fraction(1, 2)


@pytest.fixture(autouse=True)
def fifty_digits() -> Iterator[None]:
    with mpmath.workdps(50):
        yield


def test_constant_force_gives_a_parabola() -> None:
    push = applied("wrench", "b0", force=(1, -2, 3))
    state = moving(free_body(2), push, q=[0, 0, 0, 0, 0, 0, 1], v=[0, 1, 0, 0, 0, 0]).rk4(0.5, 4)
    exact = [1, 0, 3]  # F t²/(2 m) + v t
    assert np.max(np.abs(np.array(state.q[:3]) - exact)) <= 4 * 4 * 2**-52


def test_constant_torque_spins_up() -> None:
    push = applied("wrench", "b0", torque=(0, 0, 6), frame="body")
    state = moving(ball(moments=(1, 2, 3, 0, 0, 0)), push, q=[0, 0, 0, 1], v=[0, 0, 1]).rk4(0.25, 8)
    assert_same(state.v, [0, 0, 5])
    angle = 1 * 2 + mpf(6) / 3 * 4 / 2
    turned = [0, 0, mpmath.sin(angle / 2), mpmath.cos(angle / 2)]
    assert np.max(np.abs(np.array(state.q) - np.array(turned, float))) <= 8 * 2**-52 * 8


QUATERNION = [mpf(x) / 10 for x in (5, -7, 5, 1)]  # of norm 1


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
    result = f("bias_torques", t=t, q=[1, 2, 3, *QUATERNION], v=[0] * 6)
    assert_same([-x for x in result], [*force, *(torque + skew(r) @ force)])


def test_wrenches_may_be_arguments() -> None:
    force = tuple(Parameter(f"push.force.{x}", n, Fraction(n)) for n, x in enumerate("xyz"))
    f = multiprecise(free_body(2), applied("wrench", "b0", force=force), parameters=force)
    a = f("forward_dynamics", p=[4, 6, 8], q=[0, 0, 0, 0, 0, 0, 1], v=[0] * 6, tau=[0] * 6)
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
        result = f("bias_torques", q=[0, 0, 0, *QUATERNION], v=v)
        assert_same([a - b for a, b in zip(still, result, strict=True)],
                    [*force, *(skew(r) @ force)])


def test_buoyancy_lifts_at_its_centre() -> None:
    """Net weight (m - rho V) g; the lift's moment about the body's origin is c × f."""
    lift = applied("buoyancy", "b0", rho=1000, V=Fraction(1, 400), centre=(0, 1, 0))
    f = multiprecise(free_body(4), gravity(), lift)
    R = rotation_of(array(QUATERNION))
    result = f("bias_torques", q=[1, 2, 3, *QUATERNION], v=[0] * 6)
    up = R.T @ array([0, 0, mpf("9.81")])
    assert_same([-x for x in result], [*((mpf("2.5") - 4) * up),
                                       *(skew(array([0, 1, 0])) @ (mpf("2.5") * up))])
    low, high = (f("energy", q=[0, 0, z, 0, 0, 0, 1], v=[0] * 6)[1] for z in (0, 1))
    assert_same([high - low], [(4 - mpf("2.5")) * mpf("9.81")])
    weightless = multiprecise(free_body(4), lift)
    assert weightless("bias_torques", q=[0, 0, 0, 0, 0, 0, 1], v=[0] * 6) == [0] * 6


PLACE = [mpf(3), mpf(-5), mpf(7)]


def pull_of_field(body: Model, *effects: Applied) -> list[mpf]:
    """Force and moment about the body's origin, in its frame, at rest."""
    return [-x for x in multiprecise(body, *effects)("bias_torques", q=[*PLACE, *QUATERNION],
                                                      v=[0] * 6)]


def test_field_pulls_and_turns_by_the_gravity_gradient() -> None:
    """f = -mu m r/r³ + mu/2 [15 (r·I r) r/r² - 6 I r - 3 tr(I) r]/r⁵, moment 3 mu r × I r/r⁵ about
    the centre of mass."""
    com, moments, mu = (1, 0, -2), (3, 4, 5, HALF, Fraction(1, 3), Fraction(-1, 4)), 11
    model = chain((Kind.FREE, Z, HERE, inertia(2, com, moments)))
    result = pull_of_field(model, applied("field", "b0", mu=mu, centre=(1, 1, 2)))
    R, c = rotation_of(array(QUATERNION)), array([mpf(x) for x in com])
    r = R.T @ (array(PLACE) + R @ c - array([mpf(1), mpf(1), mpf(2)]))
    xx, yy, zz, xy, xz, yz = (mpf(x.numerator) / x.denominator for x in map(Fraction, moments))
    I = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]], object)
    size, I_r = mpmath.norm(r.tolist()), I @ r
    force = -mu * 2 * r / size**3 + mpf(mu) / 2 / size**5 * (
        15 * (r @ I_r) * r / size**2 - 6 * I_r - 3 * (xx + yy + zz) * r)
    assert_same(result, [*force, *(3 * mu * skew(r) @ I_r / size**5 + skew(c) @ force)])


def test_field_is_newtons_on_six_points() -> None:
    """Six points of 1 kg, two on each axis, at different distances a: the series omits terms of
    relative size (a/r)⁴."""
    arms, mu = [Fraction(n, 10**9) for n in (1, 2, 3)], 11
    squares = [2 * a**2 for a in arms]
    moments = (*(sum(squares) - x for x in squares), 0, 0, 0)
    body = chain((Kind.FREE, Z, HERE, inertia(6, (0, 0, 0), moments)))
    result = pull_of_field(body, applied("field", "b0", mu=mu))
    R = rotation_of(array(QUATERNION))
    force, moment = array([mpf(0)] * 3), array([mpf(0)] * 3)
    for axis, length in enumerate(arms):
        for side in (1, -1):
            arm = array([mpf(0)] * 3)
            arm[axis] = side * mpf(length.numerator) / length.denominator
            r = R.T @ array(PLACE) + arm
            pull = -mu * r / mpmath.norm(r.tolist())**3
            force, moment = force + pull, moment + skew(arm) @ pull
    part = 3 * mpf(10)**-9 / mpmath.norm(PLACE)
    for x, y in zip(result, [*force, *moment], strict=True):
        assert abs(x - y) <= 10 * part**4 * mu
    assert max(abs(x) for x in result[3:]) > part**2 / 10


def test_field_moves_bodies_on_ellipses() -> None:
    """mu = a = 1, e = 1/2: from the pericentre to the apocentre in half the period, π."""
    sphere = free_body(3, moments=(1, 1, 1, 0, 0, 0))
    effect, start = applied("field", "b0", mu=1), [0.5, 0, 0, 0, 0, 0, 1]

    def across(n: int) -> float:
        return moving(sphere, effect, q=start, v=[0, 3**0.5, 0, 0, 0, 0]).rk4(
            float(mpmath.pi) / n, n).q[1]

    assert_reaches(0, across, 400)


def two_free_bodies() -> Model:
    moments = (1, 1, 1, 0, 0, 0)
    bodies = tuple(Body(x, inertia(m, moments=moments)) for x, m in (("a", 2), ("b", 3)))
    return Model("two", bodies, tuple(Joint(f"j{x.name}", Kind.FREE, "world", x.name)
                                      for x in bodies))


def test_spring_damper_pulls_along_its_line() -> None:
    effect = applied("spring_damper", "tendon", bodies=("a", "b"), first=numbers("0.1", 1, 0),
                     second=numbers(0, "-0.3", 2), k=7, d=3, length=2)
    q = [1, 2, 3, *QUATERNION, -1, 0, 4, *(QUATERNION[k] for k in (0, 2, 3, 1))]
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
    results = [a - b for a, b in zip(free("bias_torques", q=q, v=v), f("bias_torques", q=q, v=v),
                                     strict=True)]
    assert_same(results, wanted)
    assert_same([f("energy", q=q, v=v)[1], f("power", q=q, v=v)],
                [mpf(7) / 2 * (length - 2)**2, -3 * ((x @ u) / length)**2])


# mimic, reaction


@pytest.mark.parametrize("multiplier", [Fraction(-3, 2), Fraction(1, 10**9), Fraction(0)])
def test_followers_add_their_inertia(multiplier: Fraction) -> None:
    """A follower adds α² I2 to the leader's inertia and α times its torque to the leader's."""
    alpha = mpf(multiplier.numerator) / multiplier.denominator
    effects = applied("mimic"), applied("spring", "j1", k=8), applied("viscous", "j1", d=3)
    f = multiprecise(geared(multiplier, HALF, (5, 7)), *effects)
    assert f.nv == f.nq == 1
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
    v = mpmath.sqrt(2 * mpf("9.81") / mpf("0.7"))  # released from the horizontal
    a = f("forward_dynamics", q=[0], v=[v], tau=[0])
    assert_same(f("reaction_j0", q=[0], v=[v], a=a), [0, 0, 3 * 2 * mpf("9.81"), 0, 0, 0])


def test_reactions_along_the_freedoms_are_torques() -> None:
    """S^T f = tau + the effects' torque at every joint; at rest, the other components follow from
    statics."""
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
