"""Slopes of effects are the derivatives of their forces, and the work of forces is the change of
energy, at 50 digits.

Derivatives are central differences over 1e-16, wrong by about 1e-32 of the third derivative.
"""

from collections.abc import Callable, Iterator
from fractions import Fraction

import mpmath
import pytest
from mpmath import mpf

from coscrew_codegen.algebra.recording.numbers import (
    Number,
    add,
    dot,
    negative,
    scaled,
    subtract,
)
from coscrew_codegen.algebra.recording.recorder import Recorder, array
from coscrew_codegen.dynamics.forces.linearization import JointEffect
from coscrew_codegen.scene.effect import (
    BodyState,
    CoordinateState,
    Effect,
    Force,
    ParameterOf,
    Place,
    PointSlopes,
    Slopes,
    Torque,
    Values,
)
from coscrew_codegen.scene.mechanism.model import HERE, Body, Joint, Model, Parameter
from coscrew_codegen.scene.scene import Applied
from tests.support.scenes.effect_scenes import PLACES, assert_listed, effects, mechanism
from tests.support.scenes.evaluation import MULTIPRECISE, Evaluated, evaluator
from tests.support.scenes.kinds import Kind
from tests.support.scenes.mechanisms import (
    CATALOGUE,
    Formula,
    Z,
    applied,
    at,
    chain,
    chain_of_three,
    gravity,
    inertia,
    numbers,
    scene,
)
from tests.support.scenes.scene_values import random_state

STEP, CLOSE = mpf(10)**-16, mpf(10)**-24
HALF = Fraction(1, 2)


@pytest.fixture(autouse=True)
def fifty_digits() -> Iterator[None]:
    with mpmath.workdps(50):
        yield


def slope(f: Callable[[mpf], mpf], x: mpf) -> mpf:
    """f'(x)."""
    return (f(x + STEP) - f(x - STEP)) / (2 * STEP)


# effects on joints, by themselves: with their true slopes, or bounds of them

TRUE = {
    "viscous": [{"d": 3}],
    "spring": [{"k": 3, "q0": HALF}],
    "actuator": [{"kind": "torque", "torque": Formula("sin(t)")},
                 {"kind": "pd", "kp": 5, "kd": 2, "target": Formula("t"), "target_v": 1},
                 {"kind": "dc", "voltage": 3, "gear": 4, "kt": HALF, "ke": 2, "R": 3}],
    "limit": [{"lower": -1, "upper": 1, "k": 9, "alpha": HALF}, {"lower": -1, "k": 9},
              {"upper": -1, "k": 9, "alpha": HALF}]}
FRICTION = {
    "coulomb": [{"tau_c": 3, "eps": HALF}],
    "joint_drag": [{"c": 2}],
    "speed_limit": [{"speed": HALF, "d": 3}],
    "stribeck": [{"tau_c": 2, "tau_s": 3, "v_s": HALF, "eps": Fraction(1, 5)}]}
BOUNDED = {
    "actuator": [{"kind": "pd", "kp": 5, "kd": 2, "target": HALF, "limit": 2},
                 {"kind": "pd", "kp": 5, "kd": 2, "target": HALF, "limit": 2, "speed": 3},
                 {"kind": "torque", "torque": Formula("2*t"), "limit": 2, "speed": 3},
                 {"kind": "dc", "voltage": 3, "gear": 4, "kt": HALF, "ke": 2, "R": 3, "limit": 4}]}
CASES = [pytest.param(name, values, name in TRUE and values in TRUE[name],
                      id=f"{name}-{values.get('kind', '')}-{n}")
         for table in (TRUE, FRICTION, BOUNDED) for name, cases in table.items()
         for n, values in enumerate(cases)]
STATES = [(mpf(q), mpf(v)) for q in ("-3", "-1.2", "0", "0.3", "1.1", "2.7")
          for v in ("-4", "-0.9", "-0.01", "0", "0.2", "1", "6")]


def torque_of(name: str, values: dict) -> Callable[[mpf, mpf], dict[str, mpf | None]]:
    """The effect's Torque at q, v and t = 0.7; None where the effect gives none."""
    recorder = Recorder([array(x, ()) for x in "qvt"])
    q, v, t = (recorder.argument(x)[0] for x in "qvt")
    made = applied(name, "joint", **values)
    along = JointEffect(made.effect.joint_torque, CoordinateState(q, v, t), made.values,
                        recorder.current)
    fields = {x: y for x, y in (*vars(along.torque).items(), *vars(along.slopes).items())
              if isinstance(y, Number) and x != "limit"}
    program = recorder.program(name, [(array(x, ()), [y]) for x, y in fields.items()])
    evaluate = evaluator(program, MULTIPRECISE)

    def at_state(q: mpf, v: mpf) -> dict[str, mpf | None]:
        results = dict(zip(fields, evaluate([[q], [v], [mpf("0.7")]]), strict=True))
        return {x: results.get(x) for x in ("torque", "damping", "stiffness", "energy", "power")}

    return at_state


def test_every_effect_on_joints_is_here() -> None:
    wanted = [name for name, effect in CATALOGUE.items() if effect.joint_torque]
    assert_listed({*TRUE, *FRICTION, *BOUNDED}, wanted, "TRUE (its slopes are those of its "
                  "torque), BOUNDED (bounds of them) or FRICTION", "tests/scenes/test_slopes.py")


@pytest.mark.parametrize("name, values, true", CASES)
def test_slopes_are_those_of_the_torque(name: str, values: dict, true: bool) -> None:
    """`true`: they are the derivatives.  Else they are no smaller, and damping by friction is at
    least |torque| / |v|."""
    f = torque_of(name, values)
    for q, v in STATES:
        result = f(q, v)
        slopes = {"damping": -slope(lambda x: f(q, x)["torque"], v),
                  "stiffness": -slope(lambda x: f(x, v)["torque"], q)}
        for key, wanted in slopes.items():
            given = result[key] or 0
            assert given >= 0
            if name == "joint_drag" and v == 0:
                wanted = mpf(0)  # a difference of |v| v about 0 is off by its step
            assert abs(given - wanted) <= CLOSE if true else given >= wanted - CLOSE, (key, q, v)
        if name in FRICTION:  # the line through rest is as steep
            assert result["damping"] * abs(v) >= abs(result["torque"]) - CLOSE


def of_law(law: Callable[[CoordinateState, object], Torque], limit: mpf | None = None
           ) -> list[mpf]:
    """Torque, damping and stiffness of a law at q = 2, v = 0, t = 3; `limit` is parameter 0."""
    recorder = Recorder([*(array(x, ()) for x in "qvt"), array("p", (1,))])
    q, v, t = (recorder.argument(x)[0] for x in "qvt")
    values = {} if limit is None else {"limit": Parameter("limit", 0, Fraction(1))}
    along = JointEffect(law, CoordinateState(q, v, t), values, recorder.current)
    program = recorder.program("law", [(array(x, ()), [y]) for x, y in (
        ("torque", along.torque.torque), ("damping", along.slopes.damping),
        ("stiffness", along.slopes.stiffness))])
    p = mpf(1) if limit is None else limit
    return evaluator(program, MULTIPRECISE)([[mpf(2)], [mpf(0)], [mpf(3)], [p]])


def test_torques_of_energies_are_their_slopes() -> None:
    """V = q³: τ = -3 q², k = 6 q."""
    assert of_law(lambda at, _: Torque(energy=at.q * at.q * at.q)) == [-12, 0, 12]


@pytest.mark.parametrize("law, words", [
    (lambda at, _: Torque(energy=at.q * at.v), "depends on q alone"),
    (lambda at, _: Torque(energy=at.q * at.t), "depends on q alone"),
    (lambda at, _: Torque(), "gives neither"),
    (lambda at, _: Torque(at.q, limit=at.q, energy=at.q), "has no energy")])
def test_laws_that_say_too_little_or_too_much_are_refused(law: Callable, words: str) -> None:
    with pytest.raises(TypeError, match=words):
        of_law(law)


@pytest.mark.parametrize("torque", [0, 5])
def test_a_limit_may_be_zero_at_run_time(torque: int) -> None:
    result = of_law(lambda at, values: Torque(at.q * torque - at.v * 7, limit=values["limit"]),
                    mpf(0))
    assert result == [0, 0, 0]


@pytest.mark.parametrize("name, values, true", CASES)
def test_torques_work_is_energy_and_power(name: str, values: dict, true: bool) -> None:
    """τ v = -V'(q) v + P; without V, P may be left out, and is all."""
    f = torque_of(name, values)
    for q, v in STATES:
        result = f(q, v)
        if result["energy"] is None:
            assert result["power"] is None
            continue
        conservative = -slope(lambda x: f(x, v)["energy"], q)
        assert abs(result["torque"] * v - conservative * v - (result["power"] or 0)) <= CLOSE
        assert result["power"] is None or result["power"] <= 0


# all effects in a scene: energy, and implicit steps


EFFECTS: dict[str, tuple[Applied, ...]] = {
    **{name: effects(name) for name in PLACES}, "buoyancy": effects("gravity", "buoyancy"),
    "all": effects(*PLACES), "none": ()}


@pytest.mark.parametrize("name", EFFECTS)
def test_energy_changes_by_what_is_fed_in(name: str) -> None:
    """d(kinetic + potential)/dt = power + tau·v."""
    f = Evaluated(scene(mechanism(), *EFFECTS[name]), MULTIPRECISE)
    for seed in range(3):
        x = random_state(f, seed)
        a = f("forward_dynamics", **x)

        def energy(s: mpf, x: dict = x, a: list = a) -> mpf:
            q = f("integrated", q=x["q"], phi=[s * v for v in x["v"]])
            return sum(f("energy", t=x["t"], q=q, v=[v + s * y for v, y in zip(x["v"], a,
                                                                               strict=True)]))

        fed = f("power", **x) + sum(t * v for t, v in zip(x["tau"], x["v"], strict=True))
        assert abs(slope(energy, mpf(0)) - fed) <= CLOSE * 1000


STIFF = (applied("viscous", "j0", d=5), applied("spring", "j1", k=70),
         applied("actuator", "j2", kind="pd", kp=50, kd=20, target=Formula("sin(t)")),
         applied("actuator", "j0", kind="dc", voltage=9, kt=2, ke=1, R=3),
         applied("limit", "j2", lower=3, k=40, alpha=HALF), applied("armature", "j1", inertia=2),
         applied("viscous", "k", d=7), applied("spring", "k", k=9, q0=1),
         applied("spring_damper", "s", bodies=("world", "b2"), first=(3, 0, 1), d=9),
         applied("spring_damper", "r", bodies=("c", "b0"), first=(3, 0, 1), d=9),
         applied("drag", "b1", kind="stokes", b=8, point=(0, 1, 1)),
         applied("drag", "b2", rho=9, area=2, point=(1, 0, 2)))


@pytest.mark.parametrize("following", [False, True])
def test_implicit_steps_solve_with_all_slopes(following: bool) -> None:
    """(M + h D + h² K) a = -bias - h K v, where D and K are -∂/∂v and -∂/∂q of the effects'
    torques."""
    extra = (gravity(), *((applied("mimic"),) if following else ()))
    inertial = tuple(x for x in STIFF if x.effect.joint_inertia)
    bare = Evaluated(scene(chain_of_three(), *extra, *inertial), MULTIPRECISE)
    f = Evaluated(scene(chain_of_three(), *extra, *STIFF), MULTIPRECISE)
    x, n, h = random_state(f, 5), f.nv, mpf(3) / 4

    def added(q: list, v: list) -> mpmath.matrix:
        return mpmath.matrix([a - b for a, b in zip(*(g("bias_torques", t=x["t"], q=q, v=v)
                                                      for g in (f, bare)), strict=True)])

    def at_joints(q: list, v: list) -> mpmath.matrix:
        """D and K of effects at joints; those on and between bodies, whose K is left out, do not
        count."""
        return mpmath.matrix([a - b for a, b in zip(*(g("bias_torques", t=x["t"], q=q, v=v)
                                                      for g in (joints_only, bare)), strict=True)])

    joints_only = Evaluated(scene(chain_of_three(), *extra, *(
        e for e in STIFF if e.effect.joint_torque or e.effect.joint_inertia)), MULTIPRECISE)

    def columns(g: Callable, key: str) -> mpmath.matrix:
        result = mpmath.matrix(n, n)
        for j in range(n):
            def moved(s: mpf, j: int = j) -> mpmath.matrix:
                y = {k: list(x[k]) for k in "qv"}
                y[key][j] += s
                return g(y["q"], y["v"])
            result[:, j] = (moved(STEP) - moved(-STEP)) / (2 * STEP)
        return result

    M = mpmath.matrix(n, n)
    for k, entry in enumerate(bare("mass_matrix", **x)):
        M[k // n, k % n] = entry
    D, K = columns(added, "v"), columns(at_joints, "q")
    bias = mpmath.matrix(f("bias_torques", **x))
    wanted = mpmath.lu_solve(M + h * D + h**2 * K, -bias - h * (K * mpmath.matrix(x["v"])))
    result = f("implicit_acceleration", h=h, **x)
    assert max(abs(a - b) for a, b in zip(result, wanted, strict=True)) <= CLOSE * 100


K_ACROSS, K_ALONG, D_ACROSS, D_ALONG = 40, 900, 3, 70


def _tether(state: BodyState, values: Values) -> Force:
    """Springs and dampers at a point, other ones along the world's z axis than across it."""
    point, zero = values.vector("point"), state.t.like(0)
    n = state.own_direction((zero, zero, zero.like(1)))
    x = state.own_direction(subtract(state.world_position(point), values.vector("rest")))
    u = state.velocity(point)
    across = add(scaled(zero.like(K_ACROSS), x), scaled(zero.like(D_ACROSS), u))
    along = dot(n, x) * (K_ALONG - K_ACROSS) + dot(n, u) * (D_ALONG - D_ACROSS)
    return Force(point, negative(add(across, scaled(along, n))), slopes=PointSlopes(
        Slopes(zero.like(D_ACROSS), zero.like(K_ACROSS)),
        Slopes(zero.like(D_ALONG), zero.like(K_ALONG)), n))


TETHER = Effect("tether", "holds", "f = -k x - d u", Place.BODY, tuple(
    ParameterOf(name, "m", "a point", "vector") for name in ("point", "rest")), body_force=_tether)


@pytest.mark.parametrize("body", ["b2", "c"])
@pytest.mark.parametrize("following", [False, True])
def test_implicit_steps_solve_with_the_slopes_of_a_point(following: bool, body: str) -> None:
    """(M + J^T (h D + h² K) J) a = -bias - h J^T K J v, where the springs are at rest: J is the
    Jacobian of the point, D and K are diagonal in the world's axes."""
    bare = (gravity(), *((applied("mimic"),) if following else ()))
    f, h, point = Evaluated(scene(chain_of_three(), *bare), MULTIPRECISE), mpf(3) / 4, (1, 0, 2)
    x, place = random_state(f, 5), 12 * [y.name for y in f.scene.model.bodies].index(body)

    def position(s: mpf, along: list) -> list[mpf]:
        moved = f("integrated", q=x["q"], phi=[s * y for y in along])
        pose = f("body_poses", q=moved)[place:place + 12]
        return [sum(pose[4 * i + j] * point[j] for j in range(3)) + pose[4 * i + 3]
                for i in range(3)]

    still = position(mpf(0), [0] * f.nv)
    rest = tuple(Fraction(int(y * 10**45), 10**45) for y in still)
    held = Evaluated(scene(chain_of_three(), *bare, Applied(
        TETHER, body, {"point": tuple(map(Fraction, point)), "rest": rest})), MULTIPRECISE)
    J = mpmath.matrix(3, f.nv)
    for j in range(f.nv):
        along = [int(k == j) for k in range(f.nv)]
        J[:, j] = (mpmath.matrix(position(STEP, along)) - mpmath.matrix(position(-STEP, along))
                   ) / (2 * STEP)
    K = J.T * mpmath.diag([K_ACROSS, K_ACROSS, K_ALONG]) * J
    D = J.T * mpmath.diag([D_ACROSS, D_ACROSS, D_ALONG]) * J
    M = mpmath.matrix(f.nv, f.nv)
    for k, entry in enumerate(f("mass_matrix", **x)):
        M[k // f.nv, k % f.nv] = entry
    bias = mpmath.matrix(held("bias_torques", **x))
    wanted = mpmath.lu_solve(M + h * D + h**2 * K, -bias - h * (K * mpmath.matrix(x["v"])))
    result = held("implicit_acceleration", h=h, **x)
    assert max(abs(a - b) for a, b in zip(result, wanted, strict=True)) <= CLOSE * 1000


def test_stiffness_between_bodies_is_taken_along_the_line() -> None:
    """On one line: (M + (h d + h² k) e e^T) a = e (…), e = (-1, 1), solved by hand."""
    two = Model("two", (Body("a", inertia(2)), Body("b", inertia(3))),
                (Joint("ja", Kind.PRISMATIC, "world", "a"),
                 Joint("jb", Kind.PRISMATIC, "world", "b", at(0, 0, 5))))
    f = Evaluated(scene(two, applied("spring_damper", "s", bodies=("a", "b"), k=700, d=90,
                                     length=4)), MULTIPRECISE)
    h, q, v = mpf("0.3"), [mpf("0.2"), mpf("0.5")], [mpf(3), mpf(-1)]
    longer, rate, c = 5 + q[1] - q[0] - 4, v[1] - v[0], h * 90 + h**2 * 700
    M = mpmath.matrix([[2 + c, -c], [-c, 3 + c]])
    pull = 700 * longer + 90 * rate + h * 700 * rate
    wanted = mpmath.lu_solve(M, mpmath.matrix([pull, -pull]))
    result = f("implicit_acceleration", h=h, q=q, v=v)
    assert max(abs(a - b) for a, b in zip(result, wanted, strict=True)) <= CLOSE


@pytest.mark.parametrize("speed", [(0, 0, 0), (3, -1, 2), (mpf(10)**-9, 0, 0)])
def test_drag_falls_with_no_more_than_its_damping(speed: tuple) -> None:
    """An implicit step without other forces shortens v and never reverses it.  The slope along v
    that it takes is rho area |v|: a = -(500 |v| v) / (m + h 1000 |v|)."""
    f = Evaluated(scene(chain((Kind.FREE, Z, HERE, inertia(1, moments=(1, 1, 1, 0, 0, 0)))),
                        applied("drag", "b0", rho=1000, area=1)), MULTIPRECISE)
    a = f("implicit_acceleration", h=mpf(100), q=numbers(0, 0, 0, 0, 0, 0, 1), v=[*speed, 0, 0, 0])
    size = mpmath.norm(speed)
    for v, x in zip(speed, a, strict=False):
        assert 0 <= (v + 100 * x) * v <= v * v
        assert abs(x + 500 * size * v / (1 + 100 * 1000 * size)) <= CLOSE * abs(v)
