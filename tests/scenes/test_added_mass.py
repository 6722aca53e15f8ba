"""Bodies in ideal fluid move as Kirchhoff's equations say, which are written here once more, at 50
digits; Lamb's integrals give the added masses of an ellipsoid."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from fractions import Fraction

import mpmath
import numpy as np
import pytest
from mpmath import mpf

from coscrew_codegen.dynamics import derive
from coscrew_codegen.scene.function_selection import FunctionsError
from tests.support.scenes.effect_scenes import effects, mechanism
from tests.support.scenes.evaluation import MULTIPRECISE, Evaluated
from tests.support.scenes.kinds import Kind
from tests.support.scenes.mechanisms import (
    HERE,
    Formula,
    X,
    Y,
    Z,
    applied,
    at,
    chain,
    chain_of_three,
    free_body,
    gravity,
    inertia,
    numbers,
    scene,
    slider,
)
from tests.support.scenes.scene_values import random_state
from tests.support.truth.exact import array, rotation_of, skew

CLOSE = mpf(10)**-40
HALF = Fraction(1, 2)
LOWER = (3, 1, 2, 0, HALF, 4, 0, 0, 1, 2, HALF, 0, 0, 0, 1, 0, 1, 0, 0, 0, 3)
MASS, INERTIA, POINT = (4, 9, 7), (HALF, 2, 3), (1, HALF, -2)
RIGID = inertia(2, (0, HALF, 1), (3, 4, 5, HALF, Fraction(1, 3), Fraction(-1, 4)))
WIND = (Formula("3 + sin(t)"), Fraction(-2), Formula("t*t"))
Matrix = np.ndarray


@pytest.fixture(autouse=True)
def fifty_digits() -> Iterator[None]:
    with mpmath.workdps(50):
        yield


def real(x: object) -> mpf:
    return mpf(x.numerator) / x.denominator if isinstance(x, Fraction) else mpf(x)


def solved(A: Matrix, b: Sequence[mpf]) -> Matrix:
    return array(list(mpmath.lu_solve(mpmath.matrix(A.tolist()), mpmath.matrix(list(b)))))


def full() -> Matrix:
    """The added mass at POINT."""
    M = array([[mpf(0)] * 6 for _ in range(6)])
    places = iter(LOWER)
    for i in range(6):
        for j in range(i + 1):
            M[i, j] = M[j, i] = real(next(places))
    return M + np.diag([real(x) for x in (*MASS, *INERTIA)])


def moved(M: Matrix, point: Sequence[object]) -> Matrix:
    """X^T M X, X from (v; w) at the origin to the point."""
    X = array([[mpf(int(i == j)) for j in range(6)] for i in range(6)])
    X[:3, 3:] = -skew(array([real(x) for x in point]))
    return X.T @ M @ X


def rigid() -> Matrix:
    m, c = real(RIGID.mass), [real(x) for x in RIGID.com]
    xx, yy, zz, xy, xz, yz = (real(x) for x in RIGID.moments)
    M = array([[mpf(0)] * 6 for _ in range(6)])
    M[:3, :3] = np.diag([m] * 3)
    M[3:, 3:] = array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    return moved(M, c)


def bias(V: Matrix, M: Matrix) -> Matrix:
    """[ad]*(V) M V."""
    p = M @ V
    return np.concatenate([skew(V[3:]) @ p[:3], skew(V[3:]) @ p[3:] + skew(V[:3]) @ p[:3]])


def added(**more: object) -> object:
    return applied("added_mass", "b0", mass=MASS, inertia=INERTIA, matrix=LOWER, point=POINT,
                   **more)


def hull(*others: object) -> Evaluated:
    return Evaluated(scene(chain((Kind.FREE, Z, HERE, RIGID)), added(), *others), MULTIPRECISE)


with mpmath.workdps(50):
    QUATERNION = [mpf(x) / 10 for x in (5, -7, 5, 1)]
    STATE = {"q": [mpf(1), mpf(-2), mpf(3), *QUATERNION],
             "v": [mpf(x) / 9 for x in (4, -1, 7, 2, 8, -5)]}


def apart(a: Sequence[mpf], b: Sequence[mpf]) -> mpf:
    return max(abs(x - y) for x, y in zip(a, b, strict=True))


# truth


def test_a_free_body_moves_by_kirchhoffs_equations() -> None:
    """(M_B + M_A) V' = -[ad]*(V) (M_B + M_A) V, also with the matrix at another point."""
    V, M = array(STATE["v"]), rigid() + moved(full(), POINT)
    wanted = solved(M, -bias(V, M))
    assert apart(hull()("forward_dynamics", tau=[0] * 6, **STATE), wanted) < CLOSE


def test_the_fluids_motion_counts() -> None:
    """M_B V' + [ad]*(V) M_B V + M_A V_r' + [ad]*(V_r) M_A V_r = R^T m g, with u' of the stream."""
    t, g = mpf(3) / 4, array([mpf(0), mpf(0), mpf("-9.81")])
    V, A, R = array(STATE["v"]), moved(full(), POINT), rotation_of(array(QUATERNION))
    u = R.T @ array([3 + mpmath.sin(t), mpf(-2), t * t])
    rate = R.T @ array([mpmath.cos(t), mpf(0), 2 * t])
    slower = V - np.concatenate([u, [mpf(0)] * 3])
    carried = np.concatenate([skew(V[3:]) @ u - rate, [mpf(0)] * 3])
    m, com = real(RIGID.mass), array([real(x) for x in RIGID.com])
    weight = m * (R.T @ g)
    forces = np.concatenate([weight, skew(com) @ weight])
    wanted = solved(rigid() + A, forces - bias(V, rigid()) - bias(slower, A) - A @ carried)
    f = hull(gravity(), applied("wind", velocity=WIND))
    assert apart(f("forward_dynamics", tau=[0] * 6, t=t, **STATE), wanted) < CLOSE * 100


@pytest.mark.parametrize("mass", [3, 10**6])
def test_a_light_body_rises_as_slowly_as_its_added_mass_says(mass: int) -> None:
    """a = (m - rho V) g/(m + m_a), from rest; also where the added mass is far larger."""
    f = Evaluated(scene(slider(2, Z), gravity(), applied("buoyancy", "b0", rho=1000, V=HALF),
                        applied("added_mass", "b0", mass=(0, 0, mass))), MULTIPRECISE)
    wanted = (2 - mpf(500)) * mpf("-9.81") / (2 + mass)
    (a,) = f("forward_dynamics", q=[0], v=[0], tau=[0])
    assert abs(a - wanted) < CLOSE * 1000
    (M,) = f("mass_matrix", q=[0])
    assert 2 + mass == M


def lamb(axes: Sequence[mpf]) -> list[mpf]:
    """Added masses along the axes of an ellipsoid in fluid of density 1, by Lamb's integrals."""
    a, b, c = axes
    volume = 4 * mpmath.pi * a * b * c / 3
    results = []
    for x in axes:
        alpha = a * b * c * mpmath.quad(
            lambda s, x=x: 1 / ((x * x + s) * mpmath.sqrt(
                (a * a + s) * (b * b + s) * (c * c + s))), [0, 1, 100, mpmath.inf])
        results.append(volume * alpha / (2 - alpha))
    return results


def test_an_ellipsoid_turns_broadside() -> None:
    """Munk's moment (m_x - m_y) u v about z, of Lamb's added masses; a sphere has half its volume.
    """
    with mpmath.workdps(20):
        sphere = lamb([mpf(1)] * 3)
        assert max(abs(x - 2 * mpmath.pi / 3) for x in sphere) < mpf(10)**-9
        mx, my, mz = lamb([mpf(3), mpf(2), mpf(1)])
    masses = numbers(*(f"{mpmath.nstr(x, 12)}" for x in (mx, my, mz)))
    mx, my, mz = map(real, masses)
    f = Evaluated(scene(free_body(2, moments=(5, 6, 7, 0, 0, 0)),
                        applied("added_mass", "b0", mass=masses)), MULTIPRECISE)
    a = f("forward_dynamics", q=[0, 0, 0, 0, 0, 0, 1], v=[3, 2, 0, 0, 0, 0], tau=[0] * 6)
    assert apart(a, [0, 0, 0, 0, 0, (mx - my) * 3 * 2 / 7]) < CLOSE
    assert mx < my < mz and a[5] < 0  # from the small mass towards the large one


# with other effects


def swims(*others: object) -> Evaluated:
    """A mass of 2 kg on a line, with 3 kg of added mass."""
    return Evaluated(scene(slider(2), applied("added_mass", "b0", mass=(3, 1, 1)), *others),
                     MULTIPRECISE)


def steps(f: Evaluated, h: mpf, count: int, q: object, v: object, t: object = 0
          ) -> tuple[mpf, mpf]:
    """q and v after steps of the default integrator."""
    q, v, t = mpf(q), mpf(v), mpf(t)
    for _ in range(count):
        q += h / 2 * v
        (a,) = f("midpoint_acceleration", t=t + h / 2, h=h, q=[q], v=[v])
        v, t = v + h * a, t + h
        q += h / 2 * v
    return q, v


def test_drag_stops_it_later() -> None:
    """v0/(1 + c v0 t), c = rho area/2(m + m_a)."""
    f, wanted = swims(applied("drag", "b0", rho=4, area=1)), 2 / (1 + mpf(2) / 5 * 2)
    off = [abs(steps(f, mpf(1) / n, n, 0, 2)[1] - wanted) for n in (32, 64)]
    assert off[0] < mpf("1e-3") and mpf("3.5") < off[0] / off[1] < mpf("4.5")


def test_a_spring_swings_slower() -> None:
    """q0 cos(sqrt(k/(m + m_a)) t)."""
    f, wanted = swims(applied("spring", "j0", k=20)), mpmath.cos(2)
    off = [abs(steps(f, mpf(1) / n, n, 1, 0)[0] - wanted) for n in (32, 64)]
    assert off[0] < mpf("1e-2") and mpf("3.8") < off[0] / off[1] < mpf("4.2")


def test_a_stream_that_begins_to_flow_carries_it_along() -> None:
    """(m + m_a) v' = m_a u': the share m_a/(m + m_a) of the stream's speed, from rest."""
    f = swims(applied("wind", velocity=(Formula("5*tanh(t)"), 0, 0)))
    _, v = steps(f, mpf(1) / 64, 64, 0, 0)
    assert abs(v - mpf(3) / 5 * 5 * mpmath.tanh(1)) < mpf("1e-3")


def test_a_motor_under_water_takes_longer() -> None:
    """v = speed (1 - e^(-t/T)), T = (m + m_a) speed/limit."""
    f = swims(applied("actuator", "j0", kind="torque", torque=9, limit=5, speed=2))
    _, v = steps(f, mpf(1) / 64, 64, 0, 0)
    assert abs(v - 2 * (1 - mpmath.exp(-mpf(1) / 2))) < mpf("1e-4")


# what follows from it


@pytest.mark.parametrize("model", [mechanism, chain_of_three], ids=["tree", "with a follower"])
def test_forward_and_inverse_dynamics_agree(model: Callable) -> None:
    """M a is what acceleration adds to the torques, and v·M v/2 the kinetic energy."""
    own = [applied("added_mass", "b1", mass=MASS, inertia=INERTIA, matrix=LOWER, point=POINT),
           applied("added_mass", "b2", mass=MASS, point=POINT)]
    mimic = effects("mimic") if model is chain_of_three else ()
    f = Evaluated(scene(model(), gravity(), applied("wind", velocity=WIND), *own, *mimic),
                  MULTIPRECISE)
    state = random_state(f, 3)
    tau = state.pop("tau")
    a, n = f("forward_dynamics", tau=tau, **state), len(tau)
    assert apart(f("inverse_dynamics", a=a, **state), tau) < CLOSE
    M = array(f("mass_matrix", q=state["q"])).reshape(n, n)
    bias_torques = array(f("bias_torques", **state))
    assert apart(M @ array(a) + bias_torques, tau) < CLOSE
    v = array(state["v"])
    assert abs(f("energy", **state)[0] - v @ M @ v / 2) < CLOSE


@pytest.mark.parametrize("stream", [(), (applied("wind", velocity=WIND),)], ids=["still", "wind"])
def test_work_of_the_stream_is_the_change_of_energy(stream: tuple) -> None:
    """dT/dt along the motion is the power; none without a stream."""
    f = hull(*stream)
    state = {"t": mpf(3) / 4, **STATE}
    a = f("forward_dynamics", tau=[0] * 6, **state)
    h = mpf(10)**-16

    def energy(side: int) -> mpf:
        q = f("integrated", q=STATE["q"], phi=[side * h * x for x in STATE["v"]])
        v = [x + side * h * y for x, y in zip(STATE["v"], a, strict=True)]
        return sum(f("energy", t=state["t"], q=q, v=v))

    power = f("power", **state)
    assert abs((energy(1) - energy(-1)) / (2 * h) - power) < mpf(10)**-28
    assert (abs(power) > 1) if stream else power == 0


def test_derivatives_are_those_of_the_dynamics() -> None:
    """Differences over 1e-16, of torques by q, v and a, and of the kinetic energy."""
    own = scene(chain((Kind.REVOLUTE, Y, HERE, RIGID), (Kind.REVOLUTE, X, at(0, 1, 0), RIGID)),
                added(), applied("added_mass", "b1", mass=MASS), gravity(),
                applied("wind", velocity=WIND))
    f = Evaluated(own, MULTIPRECISE)
    state = {"t": mpf(1) / 3, "q": [mpf("0.3"), mpf("-1.2")], "v": [mpf("0.7"), mpf("2.1")],
             "a": [mpf("-3"), mpf("1.5")]}
    h, results = mpf(10)**-16, f("inverse_dynamics_derivatives", **state)
    for n, name in enumerate(("q", "v", "a")):
        for k in range(2):
            ends = [f("inverse_dynamics", **{**state, name: [
                x + (side * h if i == k else 0) for i, x in enumerate(state[name])]})
                for side in (1, -1)]
            for i, (x, y) in enumerate(zip(*ends, strict=True)):
                assert abs((x - y) / (2 * h) - results[4 * n + 2 * i + k]) < mpf(10)**-28
    slopes = f("energy_gradients", **{x: state[x] for x in "tqv"})
    for n, name in enumerate(("q", "v")):
        for k in range(2):
            x, y = (f("energy", t=state["t"], **{"q": state["q"], "v": state["v"], name: [
                x + (side * h if i == k else 0) for i, x in enumerate(state[name])]})[0]
                for side in (1, -1))
            assert abs((x - y) / (2 * h) - slopes[2 * n + k]) < mpf(10)**-28


def test_momentum_is_not_kept_and_its_function_is_not_there() -> None:
    """Fluid takes momentum: no step corrects it."""
    with_it, without = hull().scene, scene(chain((Kind.FREE, Z, HERE, RIGID)))
    names = [{x.name for x in derive(s).functions} for s in (with_it, without)]
    assert names[1] - names[0] == {"free_momentum", "with_free_momentum"}
    with pytest.raises(FunctionsError, match="no base is floating"):
        derive(replace(with_it, functions=("free_momentum",)))


# runs
