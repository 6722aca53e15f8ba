"""Motions of the default integrator against laws and closed forms: floating bases keep their
momentum and energy, damped and stiffly controlled joints follow their closed forms, bounces have
their restitution."""

import math
from dataclasses import replace
from fractions import Fraction
from functools import cache
from itertools import pairwise

import mpmath
import numpy as np
import pytest

from coscrew_codegen.runtime.load import Kernels
from coscrew_codegen.scene.mechanism.model import HERE
from coscrew_codegen.scene.scene import Run, Scene
from coscrew_codegen.simulation.plan import Plan, Trajectory
from coscrew_codegen.simulation.run import integrate
from coscrew_codegen.simulation.system import system
from tests.references import figures
from tests.support.scenes import mechanisms as m
from tests.support.scenes.generated_scenes import imported
from tests.support.scenes.kinds import Kind
from tests.support.scenes.selecting import OneByOne, checked

OLD = "semi-implicit-euler"
NEW = "leapfrog"
U = {"double": 2.0**-53, "single": 2.0**-24}
PD = {"kind": "pd", "kp": 400, "kd": 40}


def ran(kernels: Kernels, until: float, step: float = 1e-3, integrator: str = NEW,
        precision: str = "double") -> Trajectory:
    """The run, sampled a hundred times."""
    result = integrate(system(kernels, precision),
                       Plan(until, until / 100, integrator, step, 1e-11, 1e-11))
    assert not result.stopped
    return result


@cache
def kernels(name: str) -> Kernels:
    return checked(FREE[name](), NEW, OLD, others=("body_poses", "body_twists"))


def offset() -> Scene:
    """A body whose frame is far from its centre of mass."""
    body = m.inertia(1, ("0.1", "0.2", "-0.05"), ("0.02", "0.03", "0.025", 0, 0, 0))
    return m.scene(m.chain((Kind.FREE, m.Z, HERE, body), name="offset"),
                   start_v={"j0": (0.1, 0, 0, 1, 9, 3)})


def nut() -> Scene:
    """The wing nut of the examples."""
    body = m.inertia("0.05", moments=("1e-4", "2e-4", "2.5e-4", 0, 0, 0))
    return m.scene(m.chain((Kind.FREE, m.Z, HERE, body), name="nut"),
                   start_v={"j0": (0.02, 0, 0, 0.1, 10, 0)})


def tree(*effects: m.Applied) -> Scene:
    """A tumbling body with appendages on a spherical and a revolute joint."""
    model = m.chain(
        (Kind.FREE, m.Z, HERE,
         m.inertia(2, ("0.1", "0.2", "-0.05"), ("0.02", "0.03", "0.025", 0, 0, 0))),
        (Kind.SPHERICAL, m.Z, m.at("0.2", "0.1", 0),
         m.inertia("0.5", (0, "0.1", "-0.2"), ("0.004", "0.003", "0.0025", 0, 0, 0))),
        (Kind.REVOLUTE, m.Y, m.at(0, "0.1", "-0.3"),
         m.inertia("0.3", ("0.1", 0, "-0.2"), ("0.002", "0.003", "0.0015", 0, 0, 0))),
        name="tree")
    return m.scene(model, *effects,
                   start_v={"j0": (0.1, 0, 0, 1, 2, 3), "j1": (3, -2, 4), "j2": (-5,)})


def falling() -> Scene:
    """The tree in gravity, with friction, a motor and an end of its range."""
    return m.scene(tree().model, m.gravity(1, 2, -9),
                   m.applied("viscous", "j2", d=Fraction(1, 100)),
                   m.applied("actuator", "j2", kind="pd", kp=2, kd=Fraction(1, 10),
                             target=m.Formula("sin(9*t)")),
                   m.applied("limit", "j2", lower=Fraction(-2), upper=Fraction(1), k=10**4),
                   m.applied("armature", "j2", inertia=Fraction(1, 50)),
                   m.applied("spring_damper", "", bodies=("b0", "b2"), first=m.numbers(1, 0, 0),
                             k=20, d=Fraction(1, 10), length=1),
                   start_v=tree().start_v)


FREE = {"offset": offset, "nut": nut, "tree": tree, "falling": falling}


def momenta(name: str, run: Trajectory) -> tuple[np.ndarray, np.ndarray]:
    """Momentum and angular momentum about the centre of mass, relative to the largest, from Σ m r'
    and Σ (r - c) × m r' + I ω of poses and twists, less the impulse of gravity.  (n, 3), (n, 3)."""
    its = kernels(name).double
    poses, twists = its.body_poses(run.q.astype(float)), its.body_twists(
        run.q.astype(float), run.v.astype(float))
    p, L, places, mass = 0.0, 0.0, 0.0, 0.0
    parts = []
    for n, body in enumerate(kernels(name).scene.model.bodies):
        R, t = poses[:, n, :, :3], poses[:, n, :, 3]
        own, com = float(body.inertia.mass), np.array(list(map(float, body.inertia.com)))
        I = np.diag(list(map(float, body.inertia.moments[:3])))
        w = twists[:, n, 3:]
        v = np.einsum("nij,nj->ni", R, twists[:, n, :3] + np.cross(w, com))
        parts.append((own, t + R @ com, v, np.einsum("nij,jk,nk->ni", R, I, w)))
        mass, p, places = mass + own, p + own * v, places + own * (t + R @ com)
    for own, r, v, spin in parts:
        L = L + np.cross(r - places / mass, own * v) + spin
    g = np.array((1, 2, -9)) if name == "falling" else np.zeros(3)
    p = p - mass * g * run.t[:, None]
    return p, L


@pytest.mark.parametrize("precision", ("double", "single"))
@pytest.mark.parametrize("name", FREE)
def test_floating_bases_keep_their_momentum_to_rounding(name, precision):
    """Over 1e5 steps; 2e4 with friction, a motor and a limit inside.  The former default does not
    keep it."""
    until = 20.0 if name == "falling" else 100.0
    run = ran(kernels(name), until, precision=precision)
    p, L = momenta(name, run)
    size = np.max(np.abs(p)) + (27 * until if name == "falling" else 0)
    assert np.max(np.abs(p - p[0])) < 100 * U[precision] * size
    size = np.max(np.abs(L)) + size * np.max(np.abs(run.q[:, :3]))  # moments about the origin
    assert np.max(np.abs(L - L[0])) < 100 * U[precision] * size
    if name != "falling":
        old = ran(kernels(name), 2.0, integrator=OLD, precision=precision)
        assert max(np.max(np.abs(x - x[0])) / np.max(np.abs(x)) for x in momenta(name, old)) > 1e-3


@pytest.mark.parametrize("name", ("offset", "nut", "tree"))
def test_floating_bases_keep_their_energy_within_a_thousandth(name):
    """Over 1e5 steps of 1e-3 s, in both precisions."""
    for precision in U:
        run = ran(kernels(name), 100.0, precision=precision)
        e = np.sum(kernels(name).double.energy(run.q.astype(float), run.v.astype(float)), -1)
        assert np.max(np.abs(e / e[0] - 1)) < 1e-3


def test_steps_from_c_alone_keep_momentum_except_for_roundings():
    """1e5 calls of the step are made, each with q and v alone."""
    its = kernels("tree").double
    q, v = system(kernels("tree"), "double").start()
    c = its.free_momentum(q, v)
    q, v = its.step_leapfrog.repeated(100_000, 0.0, 1e-3, np.zeros(0), q, v)
    then = c + np.concatenate((np.zeros(6), c[0, :3] * 100.0 / 2.8))  # of 2.8 kg, after 100 s
    size = U["double"] * np.max(np.abs(then))
    assert np.max(np.abs(its.free_momentum(q, v) - then)) < 1e5 * 2 * size
    q, v = its.with_free_momentum(100.0, q, v, c)
    assert np.max(np.abs(its.free_momentum(q, v) - then)) < 20 * size


def test_a_state_is_no_batch_of_one_after_many_states():
    """Nor where an input has several axes of its own, as c has."""
    its = kernels("tree").double
    q, v = system(kernels("tree"), "double").start()
    c = its.free_momentum(q, v)
    for n in (1, 100_000):  # the latter in lanes, which are compiled then
        many = its.with_free_momentum(np.zeros(n), q, np.tile(v, (n, 1)), c)
        assert [x.shape for x in many] == [(n, len(q)), (n, len(v))]
        assert [x.shape for x in its.with_free_momentum(0.0, q, v, c)] == [q.shape, v.shape]


def test_a_tumbling_nut_turns_as_jacobis_functions_say():
    """At least to second order; speeds at the reversals, to third."""
    wanted = [(float(x.at), int(x.quantity[-1]), float(x.value)) for x in figures.read("rigid_body")
              if x.quantity.startswith("v.base.") and float(x.at) <= 3]
    assert len(wanted) >= 3
    errors = []
    for h in (4e-3, 2e-3, 1e-3):
        times = sorted({at for at, _, _ in wanted})
        run = integrate(system(kernels("nut"), "double"),
                        Plan(times[-1], times[-1], NEW, h, 1, 1, tuple(times[:-1])))
        errors.append(max(abs(run.v[np.argmin(np.abs(run.t - at)), i] - value)
                          for at, i, value in wanted))
    assert all(a / b > 3.8 for a, b in pairwise(errors)) and errors[-1] < 2e-3


def test_a_spring_turns_in_phase_space_and_keeps_its_energy():
    """A step is the rotation by 2 atan(h ω/2) of (q, v/ω), so that 1e5 steps lose nothing."""
    its = OneByOne(m.scene(m.slider(1), m.applied("spring", "j0", k=10**4)), "double")
    for h in (1e-3, 1e-2, 0.1):
        q, v = its.step_leapfrog.repeated(100_000, 0.0, h, np.zeros(0), np.ones(1), np.zeros(1))
        assert its.energy(q, v).sum() == pytest.approx(5000, rel=1e5 * 10 * U["double"])
        angle = 200_000 * mpmath.atan(mpmath.mpf(h) * 50)
        assert abs(q[0] - float(mpmath.cos(angle))) < 1e5 * 10 * U["double"]
        assert abs(v[0] / 100 + float(mpmath.sin(angle))) < 1e5 * 10 * U["double"]


@pytest.mark.parametrize("z", (1e-3, 0.5, 1.0, 7.0, 400.0, 1e6))
def test_a_damped_speed_shrinks_as_promised_at_any_step(z):
    """Each step divides it by 1 + z + z²/2, z = h d/J: it never changes sign and never grows."""
    scene = m.scene(m.rotor(), m.applied("viscous", "j0", d=Fraction(z) * 1000))
    for precision, u in U.items():
        h = {"double": 1e-3, "single": np.float32(1e-3)}[precision]
        _, v = OneByOne(scene, precision).step_leapfrog(h, np.zeros(1), np.ones(1))
        real = mpmath.mpf(float(h)) * mpmath.mpf(z) * 1000
        right = float(1 / (1 + real + real**2 / 2))
        assert abs(v[0] - right) <= 4 * u * (1 + z * right)  # 1 - h a, from two numbers near 1


@pytest.mark.parametrize("name", ("rotor", "arm"))
def test_stiff_motors_on_light_links_are_followed(name):
    """kp 400, kd 40, 1e-4 kg m²: q = e^(-10 t), late by half a step after the jump; the former
    default fails here.  Two such links, the lower one under gravity, end where their motors hold
    them."""
    link = (Kind.REVOLUTE, m.Y, HERE, m.inertia("1e-4", moments=("1e-4", "1e-4", "1e-4", 0, 0, 0)))
    model = m.chain(*[link] * (1 if name == "rotor" else 2), name=name)
    scene = m.scene(model, *(m.applied("actuator", j.name, **PD, target=Fraction(0))
                             for j in model.joints), start_q={"j0": (1.0,)})
    its = checked(scene, NEW, OLD, precisions=("double",))
    for h, until in ((1e-3, 0.1), (5e-4, 0.1)):
        q = ran(its, until, h).q[-1]
        assert abs(q[0] - math.exp(-10 * until)) < 10 * h / 2 * math.exp(-1) * 1.1
    assert np.max(np.abs(ran(its, 2.0).v[-1])) < 1e-6
    q, v = its.double.step_semi_implicit_euler.repeated(1000, 0.0, 1e-3, np.zeros(0), np.ones(
        its.NQ), np.zeros(its.NV))
    assert not np.all(np.abs(v) < 1)


def smooth() -> dict[str, Scene]:
    """Motions without jumps in which stiff or damped effects dominate."""
    light = m.rotor("1e-4")
    hung = m.chain(*[(Kind.REVOLUTE, m.Y, m.at(0, 0, -n), m.inertia(1, (0, 0, -1)))
                     for n in range(2)], name="hung")
    return {
        "motor": m.scene(light, m.applied("actuator", "j0", **PD, target=m.Formula("sin(6*t)"),
                                          target_v=m.Formula("6*cos(6*t)")),
                         start_v={"j0": (6.0,)}),
        "drag": m.scene(m.free_body(), m.gravity(), m.applied(
            "drag", "b0", kind="stokes", b=5, point=m.numbers(0, 0, "0.1")),
            start_v={"j0": (0.1, 0.3, 0, 1, 2, 3)}),
        "mimic": m.scene(m.geared("1.5", 0, (1, 2)), m.applied("mimic", joints="all"),
                         m.applied("spring", "j1", k=100), m.applied("viscous", "j1", d=2),
                         start_v={"j0": (3.0,)}),
        "pair": m.scene(hung, m.gravity(), m.applied(
            "spring_damper", "", bodies=("world", "b1"), first=m.numbers(1, 0, 0),
            second=m.numbers(0, 0, -1), k=500, d=20, length=1)),
        "coulomb": m.scene(m.rotor(), m.applied("coulomb", "j0", tau_c=1, eps=Fraction(1, 20)),
                           m.applied("spring", "j0", k=50), start_v={"j0": (1.0,)})}


@pytest.mark.parametrize("name", smooth())
def test_errors_are_of_second_order(name):
    """Beside Radau's method with tolerances of 1e-11."""
    its = checked(smooth()[name], NEW, "radau", precisions=("double",))
    right = ran(its, 0.8, integrator="radau").q[-1]
    errors = [np.max(np.abs(ran(its, 0.8, h).q[-1] - right)) for h in (2e-3, 1e-3, 5e-4)]
    assert [math.log2(a / b) for a, b in pairwise(errors)] == pytest.approx([2, 2], abs=0.35)
    assert errors[1] < 1e-3


@cache
def bouncing(k: str) -> Kernels:
    """A kilogram over a stop at q = 0."""
    return checked(m.scene(m.slider(1, m.Z), m.gravity(), m.applied(
        "limit", "j0", lower=Fraction(0), k=Fraction(k), alpha=Fraction(1, 10))), NEW,
        others=("parts",))


def restitution(v: float, alpha: float = 0.1) -> float:
    """e of c v - ln(1 + c v) = -c e v - ln(1 - c e v), c = 1.5 alpha: m v dv = -k δ^1.5 (1 + c v)
    dδ, integrated over both halves of the contact."""
    x = mpmath.mpf(3) / 2 * alpha * v
    lost = x - mpmath.log(1 + x)
    return float(mpmath.findroot(lambda y: -y - mpmath.log(1 - y) - lost, x * 0.75) / x)


@pytest.mark.parametrize("precision", ("double", "single"))
@pytest.mark.parametrize("k, within", (("1e7", 0.01), ("1e9", 0.01), ("1e11", 0.01)))
def test_a_bounce_keeps_its_restitution(k, within, precision):
    """0.758 after a fall from 0.5 m, with steps of 1e-3 s, wherever in a step the contact begins.
    """
    assert restitution(math.sqrt(2 * 9.81 * 0.5)) == pytest.approx(0.758, abs=3e-3)
    its = getattr(bouncing(k), precision)
    for n in range(20):
        z = 0.5 + n * 1.7e-4
        steps = int(math.sqrt(2 * z / 9.81) / 1e-3) + 12
        q, v = its.step_leapfrog.repeated(steps, 0.0, 1e-3, np.zeros(0), np.array([z]), np.zeros(1))
        fall = math.sqrt(2 * 9.81 * z)
        assert v[0] > 0
        up = math.sqrt(float(v[0])**2 + 2 * 9.81 * float(q[0]))
        assert up / fall == pytest.approx(restitution(fall), rel=within)


def test_several_limits_at_once_feed_no_energy_in():
    """Two sliders, one on the other, each fall onto an end of its range: energy falls, and they
    come to rest."""
    model = m.chain((Kind.PRISMATIC, m.Z, HERE, m.inertia(1)),
                    (Kind.PRISMATIC, m.Z, HERE, m.inertia("0.01")), name="stacked")
    its = checked(m.scene(model, m.gravity(), *(m.applied(
        "limit", f"j{n}", lower=Fraction(0), k=10**8, alpha=Fraction(1, 5)) for n in range(2)),
        start_q={"j0": (0.1,), "j1": (0.02,)}), NEW, precisions=("double",))
    run = integrate(system(its, "double"), Plan(3.0, 1e-3, NEW, 1e-3, 1, 1))
    e = np.sum(its.double.energy(run.q, run.v), -1)
    assert np.max(np.diff(e)) < 5e-3 * e[0] and np.max(e) <= e[0] * 1.001
    assert 0 < e[-1] < 0.05 * e[0]


def test_a_limit_too_stiff_for_its_step_says_so():
    its = system(bouncing("1e17"), "double")
    fallen = replace(its, scene=replace(its.scene, start_q={"j0": (0.5,)}))
    run = integrate(fallen, Plan(1.0, 0.01, NEW, 1e-3, 1, 1))
    assert "not finite at t = 0.3" in run.stopped and "joint j0" in run.stopped
    assert "a limit closes that is too stiff" in run.stopped and "smaller step" in run.stopped


@pytest.mark.parametrize("precision", U)
def test_steps_of_many_states_are_the_same_bits_in_numpy_and_c(precision, tmp_path):
    """States before, during and after contact each take their own number of parts."""
    its, draw = bouncing("1e9"), np.random.default_rng(9)
    package = getattr(imported(its.functions, tmp_path), precision)
    kind = np.dtype(f"f{8 if precision == 'double' else 4}")
    q = np.concatenate((draw.uniform(-1e-3, 3e-3, 200), [0, 1, np.nan])).astype(kind)[:, None]
    v = np.concatenate((draw.uniform(-4, 1, 200), [-1e-3, 0, 1])).astype(kind)[:, None]
    h = kind.type(1e-3)
    result, wanted = (x.step_leapfrog(h, q, v) for x in (package, getattr(its, precision)))
    assert len(set(np.asarray(its.double.parts(1e-3, q[:-1], v[:-1])[0]).tolist())) >= 4
    for x, y in zip(result, wanted, strict=True):
        assert np.where(x == x, x, 0).tobytes() == np.where(y == y, y, 0).tobytes()
        assert np.array_equal(np.isnan(x), np.isnan(y)) and np.isnan(x).sum() == 1
    for state in (0, 7, 201):  # one alone: no leading axis
        alone = package.step_leapfrog(h, q[state], v[state])
        assert [x.tobytes() for x in alone] == [x[state].tobytes() for x in wanted]


def test_the_default_of_scenes_is_the_default_of_the_list():
    assert Run().integrator == NEW
