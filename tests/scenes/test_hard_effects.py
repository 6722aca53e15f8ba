"""The emitted kernels stay physical where effects are stiff, stick, vanish, or act far from the
origin."""

from collections.abc import Callable, Iterator
from fractions import Fraction

import numpy as np
import pytest

from coscrew_codegen.scene.mechanism.model import HERE, Body, Joint, Model
from coscrew_codegen.scene.scene import Applied
from tests.support.scenes.kinds import Kind
from tests.support.scenes.mechanisms import (
    X,
    Y,
    Z,
    applied,
    at,
    ball,
    chain,
    free_body,
    gravity,
    inertia,
    numbers,
    pendulum,
    rotor,
    scene,
    slider,
)
from tests.support.scenes.selecting import OneByOne

STIFF = 10**6  # with J = 1 and h = 1e-2: h d/J = 1e4
H = 1e-2
HALF = Fraction(1, 2)
UNIT = {"double": 2.0**-53, "single": 2.0**-24}
both = pytest.mark.parametrize("precision", ["double", "single"])


@pytest.fixture(scope="module")
def load(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Callable[..., OneByOne]]:
    """A model's functions with these effects."""
    def functions(model: Model, *effects: Applied, precision: str = "double") -> OneByOne:
        return OneByOne(scene(model, *effects), precision)

    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("XDG_CACHE_HOME", str(tmp_path_factory.mktemp("cache")))
        yield functions


def run(f: OneByOne, step: str, h: float, steps: int, q: list, v: list) -> tuple[np.ndarray, ...]:
    """q and v after each step, (steps, n)."""
    q, v = (np.asarray(x, f.kind) for x in (q, v))
    step = getattr(f, f"step_{step}")
    results = []
    for _ in range(steps):
        q, v = step(h, q, v)
        results.append((q, v))
    qs, vs = map(np.array, zip(*results, strict=True))
    assert np.all(np.isfinite(qs)) and np.all(np.isfinite(vs))
    return qs, vs


IMPLICIT = "linear_implicit_euler"


# stiff joints


@both
def test_stiff_viscous_joints_decay(load: Callable, precision: str) -> None:
    """Each step gives v/(1 + h d/J), where an explicit step would multiply v by -9999."""
    f = load(rotor(), applied("viscous", "j0", d=STIFF), precision=precision)
    u = UNIT[precision]
    _, v = run(f, IMPLICIT, H, 5, [0], [1])
    exact = (1 + H * STIFF) ** -np.arange(1.0, 6)
    # v + h a cancels to 1e-4 of v: the error of each step is 1e4 u of its result
    assert np.all(np.abs(v[:, 0] - exact) <= 4 * u * np.cumsum(np.r_[1, exact[:-1]]))
    with np.errstate(all="ignore"), pytest.raises(AssertionError):
        run(f, "semi_implicit_euler", H, 200, [0], [1])


def arm() -> Model:
    """Two links of 1 m that turn about y, of 2 kg and 1 kg."""
    return chain((Kind.REVOLUTE, Y, HERE, inertia(2, (HALF, 0, 0), (0, 1, 1, 0, 0, 0))),
                 (Kind.REVOLUTE, Y, at(1, 0, 0), inertia(1, (HALF, 0, 0), (0, 1, 1, 0, 0, 0))),
                 name="arm")


@both
def test_stiff_controllers_hold_an_arm(load: Callable, precision: str) -> None:
    """It comes to rest where kp (target - q) balances the torque of the arm's weight."""
    effects = [applied("actuator", x, kind="pd", kp=STIFF, kd=STIFF, target=y)
               for x, y in (("j0", HALF), ("j1", -1))]
    f = load(arm(), gravity(), *effects, precision=precision)
    q, v = run(f, IMPLICIT, H, 3000, [0, 0], [0, 0])
    still = 1e-9 + 2 * UNIT[precision] / H  # slower, a step's change of q rounds off
    assert np.max(np.abs(v[-1])) <= still
    sag = f.gravity_torques(q[-1]) / STIFF
    assert np.max(np.abs(q[-1] + sag - [0.5, -1])) <= still
    assert np.max(np.abs(q)) <= 1.0001


@pytest.mark.parametrize("effect", [
    applied("viscous", "j1", d=STIFF), applied("spring", "j1", k=100 * STIFF),
    applied("actuator", "j1", kind="dc", voltage=0, gear=100, kt=10, ke=10, R=1),
    applied("coulomb", "j1", tau_c=100, eps=Fraction(1, 10**6)),
    applied("stribeck", "j1", tau_c=100, tau_s=200, v_s=HALF, eps=Fraction(1, 10**6))],
    ids=lambda x: x.effect.name)
def test_stiff_joints_make_an_arm_one_pendulum(load: Callable, effect: Applied) -> None:
    """The elbow hardly moves, and no step adds more energy than the error of the method, of order
    h."""
    f = load(arm(), gravity(), effect)
    q, v = run(f, IMPLICIT, 1e-3, 4000, [0, 0], [0, 0])
    assert np.max(np.abs(q[:, 1])) <= 0.01
    total = f.energy(q, v).sum(-1)
    scale = 2 * 9.81 * 2
    assert np.max(total) <= scale * 2e-3
    assert np.min(q[:, 0]) >= -1e-3 and np.max(q[:, 0]) >= 2.5  # it swings: level to level


def test_saturated_controllers_do_not_chatter(load: Callable) -> None:
    """While it saturates, a stiff controller gives its largest torque; then it approaches its
    target without turning back."""
    effect = applied("actuator", "j0", kind="pd", kp=STIFF, kd=STIFF, target=1, limit=4)
    f = load(rotor(), effect)
    q, v = run(f, IMPLICIT, H, 2000, [0], [0])
    assert np.all(v >= -1e-12) and np.max(v) <= np.sqrt(2 * 4 * 1)
    assert abs(q[-1, 0] - 1) <= 1e-6


# stiction


CREEP = float(np.arctanh(0.75))  # speed in eps, friction being 3/4 of tau_c


def held(name: str, eps: Fraction) -> list[Applied]:
    """A constant force of 3 N, as on a slope, against a friction of 4 N."""
    values = {"coulomb": {"tau_c": 4}, "stribeck": {"tau_c": 4, "tau_s": 4, "v_s": HALF}}[name]
    return [gravity(3, 0, -9), applied(name, "j0", eps=eps, **values)]


@both
@pytest.mark.parametrize("name", ["coulomb", "stribeck"])
def test_what_sticks_only_creeps(load: Callable, name: str, precision: str) -> None:
    """In 1e5 steps its speed stays below eps artanh(tau/tau_c), and it moves no farther than at
    that speed."""
    f = load(slider(), *held(name, Fraction(1, 10**6)), precision=precision)
    u, steps = UNIT[precision], 10**5
    q, v = run(f, IMPLICIT, H, steps, [0], [0])
    creep = 1e-6 * CREEP
    assert np.all(v >= 0) and np.all(v <= creep * (1 + 64 * u))
    assert abs(v[-1, 0] - creep) <= 64 * u * creep
    assert q[-1, 0] <= creep * H * steps * (1 + steps * u)


@pytest.mark.parametrize("name", ["coulomb", "stribeck"])
def test_what_slides_stops_once_and_for_all(load: Callable, name: str) -> None:
    """On a slope on which friction can hold it, it slides for the time J v/(tau_c - tau).  Then
    each step takes (tau_c - tau)/tau_c of its speed until it creeps; it never turns back."""
    f = load(slider(), *held(name, Fraction(1, 10**8)))
    _, v = run(f, IMPLICIT, H, 2000, [0], [1])
    stopped = int(1 / ((4 - 3) * H))
    assert np.all(np.diff(v[:stopped - 20, 0]) < 0)
    last = int(np.log(1e8) / -np.log(0.75)) + 60
    assert np.all(v > 0) and np.all(v[stopped + last:] <= 1e-8 * CREEP * (1 + 1e-9))


def test_an_arm_sticks_at_all_its_joints(load: Callable) -> None:
    eps = Fraction(1, 10**6)
    effects = [applied("coulomb", x, tau_c=t, eps=eps) for x, t in (("j0", 40), ("j1", 6))]
    f = load(arm(), gravity(), *effects)
    steps = 10**5
    q, v = run(f, IMPLICIT, H, steps, [0, 0], [0, 0])
    fastest = 1e-6 * np.arctanh(np.abs(f.gravity_torques(np.zeros(2))) / [40, 6])
    assert np.all(np.abs(q[-1]) <= fastest * H * steps * (1 + 1e-2))  # its weight's torque changes
    assert np.all(np.abs(v) <= fastest * (1 + 1e-2))


# heavy and light, fast, far away


@pytest.mark.parametrize("masses", [(1, 10**6), (10**6, 1)])
def test_mass_ratios_of_a_million(load: Callable, masses: tuple) -> None:
    """Shorter steps change the energy less; inverse dynamics returns the torques that forward
    dynamics was given."""
    links = [(Kind.REVOLUTE, Y, at(n, 0, 0), inertia(m, (1, 0, 0), (0, m, m, 0, 0, 0)))
             for n, m in enumerate(masses)]
    f = load(chain(*links), gravity())
    drifts = []
    for steps in (1000, 2000):
        q, v = run(f, "rk4", 1 / steps, steps, [0, 0.5], [0, 0])
        e = f.energy(q, v).sum(-1)
        drifts.append(np.max(np.abs(e - f.energy([0, 0.5], [0, 0]).sum())) / (2 * 9.81 * 1e6))
    assert drifts[0] <= 1e-6 and drifts[1] <= max(drifts[0] / 12, 64 * UNIT["double"])
    rng = np.random.default_rng(0)
    q, v, a = rng.normal(size=(3, 100, 2))
    back = f.forward_dynamics(q, v, f.inverse_dynamics(q, v, a))
    condition = np.linalg.cond(f.mass_matrix(q))
    # error of 1e6 u in torques of 1e6 N m, divided by the mass matrix
    assert np.all(np.max(np.abs(back - a), -1) <= 64 * UNIT["double"] * condition * 10)


def test_spinning_top_at_150_rad_per_s(load: Callable) -> None:
    """The heavy top of the reference problems: Euler parameters at 0.2 s agree to five digits;
    energy and the angular momenta about its axis and about the vertical are constant."""
    top = chain((Kind.SPHERICAL, Z, HERE, inertia(
        15, (0, 1, 0), numbers("0.234375", "0.46875", "0.234375", 0, 0, 0))))
    f = load(top, gravity())
    start = np.array([0, 0, 0, 1.0]), np.array([0, 150, -4.61538])
    drifts = []
    for steps in (1000, 2000):
        q, v = run(f, "rk4", 0.2 / steps, steps, *start)
        kept = [np.abs(v[:, 1] - 150) / 150,
                np.abs(f.energy(q, v).sum(-1) / f.energy(*start).sum() - 1),
                np.abs(f.momentum(q, v)[:, 5] / f.momentum(*start)[5] - 1)]
        drifts.append(np.max(kept))
    assert drifts[1] <= max(drifts[0] / 12, 1e-12) and drifts[0] <= 1e-5
    wanted = np.array([0.43878, 0.54573, 0.0894, -0.70828])  # or its negative: the same rotation
    assert np.max(np.abs(q[-1] * np.sign(q[-1, 0]) - wanted)) <= 2e-5


@both
def test_gravity_far_from_the_origin(load: Callable, precision: str) -> None:
    """A million metres away all torques have the same bits as at the origin."""
    def hung(far: int) -> Model:
        I = (1, 1, 1, 0, 0, 0)
        links = chain((Kind.REVOLUTE, Y, at(far, far, -far), inertia(2, (1, 0, 1), I)),
                      (Kind.REVOLUTE, X, at(1, 0, 0), inertia(1, (0, 1, 0), I)))
        return Model("far" if far else "near", links.bodies, links.joints)

    tendon = applied("spring_damper", "s", bodies=("b0", "b1"), first=(0, 0, 1), second=(0, 1, 0),
                     k=100, d=3, length=1)
    near, far = (load(hung(x), gravity(), tendon, precision=precision) for x in (0, 10**6))
    state = [np.array(x, np.float32) for x in ([0.3, -0.4], [1, 2], [0.5, 0.6])]
    assert np.array_equal(near.inverse_dynamics(*state), far.inverse_dynamics(*state))
    assert np.array_equal(near.forward_dynamics(*state), far.forward_dynamics(*state))
    f = load(free_body(3), gravity(), precision=precision)
    zero, q = np.zeros(6, np.float32), np.array([0, 0, 0, 0, 0, 0, 1], np.float32)
    away = np.array([1e6, -1e6, 1e6, 0, 0, 0, 1], np.float32)
    assert np.array_equal(f.forward_dynamics(q, zero, zero), f.forward_dynamics(away, zero, zero))
    assert f.forward_dynamics(away, zero, zero)[2] == pytest.approx(-9.81, rel=4 * UNIT[precision])


# limits, drag, short springs


@pytest.mark.parametrize("step, h", [("semi_implicit_euler", 1e-4), (IMPLICIT, 1e-4),
                                     ("rk4", 1e-4), (IMPLICIT, 1e-2)])
@both
def test_bounces_without_end_come_to_rest(load: Callable, step: str, h: float,
                                          precision: str) -> None:
    """After infinitely many bounces in a finite time it rests at the depth (m g/k)^(2/3)."""
    effect = applied("limit", "j0", lower=0, k=10**5, alpha=HALF)
    f = load(slider(1, Z), gravity(), effect, precision=precision)
    q, v = run(f, step, h, int(12 / h), [1], [0])
    e = f.energy(q, v).sum(-1)
    assert np.max(e) <= 9.81 * (1 + 2 * h * 10)
    depth = (9.81 / 1e5) ** (2 / 3)
    assert np.max(np.abs(q[-100:] + depth)) <= 1e-2 * depth
    assert np.max(np.abs(v[-100:])) <= 1e-3


@both
def test_drag_stops_light_bodies(load: Callable, precision: str) -> None:
    """With h rho area v/m = 1e6 the speed falls to the terminal speed and keeps its sign, unless it
    is subnormal."""
    light = free_body(Fraction(1, 10**6), moments=(Fraction(1, 10**9),) * 3 + (0,) * 3)
    f = load(light, gravity(), applied("drag", "b0", rho=1, area=1), precision=precision)
    _, v = run(f, IMPLICIT, H, 2000, [0, 0, 0, 0, 0, 0, 1], [100, 0, 0, 0, 0, 0])
    assert np.all(v[:, 0] >= -np.finfo(v.dtype).tiny)
    assert np.all(np.diff(v[:, 0]) <= 0) and v[-1, 0] <= 1e-2
    terminal = np.sqrt(2 * 9.81e-6)
    assert abs(v[-1, 2] + terminal) <= 0.01 * terminal
    f = load(light, applied("drag", "b0", kind="stokes", b=1), precision=precision)
    _, v = run(f, IMPLICIT, H, 3, [0, 0, 0, 0, 0, 0, 1], [0, 8, 0, 0, 0, 0])
    assert abs(v[0, 1] - 8 / 10001) <= 8 * 8 * UNIT[precision]


@both
def test_springs_pass_through_length_zero(load: Callable, precision: str) -> None:
    """With the rest length 0 the spring is linear: its length is cos ωt, through zero.  With
    another rest length its force has no direction where the ends meet; there it is zero, never NaN.
    """
    ends = {"bodies": ("world", "b0"), "k": 100}
    body = free_body(1)
    f = load(body, applied("spring_damper", "s", **ends), precision=precision)
    steps = 1000
    q, _ = run(f, "rk4", np.pi / 10 / steps, steps, [0.5, 0, -0.5, 0, 0, 0, 1], [0] * 6)
    wanted = np.cos(np.pi * np.arange(1, steps + 1) / steps) / 2
    error = np.max(np.abs(q[:, :3] - np.outer(wanted, [1, 0, -1])))
    assert error <= 1e-9 + 20 * steps * UNIT[precision]
    f = load(body, applied("spring_damper", "s", length=1, d=5, **ends), precision=precision)
    met = np.array([0, 0, 0, 0, 0, 0, 1], np.float32), np.array([1, 2, 3, 0, 0, 0], np.float32)
    assert np.array_equal(f.forward_dynamics(*met, np.zeros(6, np.float32)), np.zeros(6))
    for step in ("rk4", IMPLICIT, "semi_implicit_euler"):
        run(f, step, 1e-3, 2000, *met)


def test_stiff_springs_between_bodies_leave_their_fall_alone(load: Callable) -> None:
    """With h d/m = h² k/m = 1e4 along the line, both bodies fall with g, as if free."""
    joints = tuple(Joint(f"j{x}", Kind.FREE, "world", x, at(0, 0, n)) for n, x in enumerate("ab"))
    two = Model("two", tuple(Body(x, inertia(m, moments=(1, 1, 1, 0, 0, 0)))
                             for x, m in (("a", 1), ("b", 3))), joints)
    tendon = applied("spring_damper", "s", bodies=("a", "b"), k=10**8, d=10**6, length=1)
    f = load(two, gravity(), tendon)
    q0 = [0, 0, 0, 0, 0, 0, 1] * 2
    q, v = run(f, IMPLICIT, H, 1000, q0, [0, 0, 1] + [0] * 9)
    fall = 0.25 - 9.81 * H * np.arange(1, 1001)
    assert np.max(np.abs(v[50:, [2, 8]] - fall[50:, None])) <= 1e-9  # 2^-50 of the impulse is left
    assert np.max(np.abs(q[50:, 9] - q[50:, 2])) <= 1e-9


def test_balls_are_kept_from_turning_by_drag_at_their_rim(load: Callable) -> None:
    """Drag at a point of the body also resists its rotation: h b r²/I = 1e4."""
    f = load(ball(moments=(1, 1, 1, 0, 0, 0)),
             applied("drag", "b0", kind="stokes", b=STIFF, point=(1, 0, 0)))
    _, v = run(f, IMPLICIT, H, 50, [0, 0, 0, 1], [2, 3, 4])
    assert np.max(np.abs(v[-1] - [2, 0, 0])) <= 1e-12


def test_pendulum_of_a_light_rod_and_a_heavy_armature(load: Callable) -> None:
    """Ia/I = 1e6: the frequency is that of the armature."""
    f = load(pendulum(), applied("armature", "j0", inertia=10**6), applied("spring", "j0", k=10**6))
    q, _ = run(f, "rk4", 1e-2, 628, [1], [0])
    omega = np.sqrt(1e6 / (1e6 + 1))
    assert np.max(np.abs(q[:, 0] - np.cos(omega * 1e-2 * np.arange(1, 629)))) <= 1e-9
