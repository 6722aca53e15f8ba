"""Motions against values that share no code with the generator: closed forms, published figures,
Taylor series, other programs.  support/scenes/runs.py derives the errors that runs may have."""

from fractions import Fraction
from functools import cache
from pathlib import Path

import mpmath
import numpy as np
import pytest
from mpmath import mp, mpf

from coscrew_codegen.runtime.load import Kernels
from coscrew_codegen.scene.scene import Run, Scene
from coscrew_codegen.simulation.system import system
from tests.references import figures as committed
from tests.references import heavy_top, pendulum, rigid_body
from tests.references.figures import Figure
from tests.support.scenes import mechanisms, runs
from tests.support.scenes.kinds import Kind
from tests.support.scenes.selecting import checked

pytestmark = pytest.mark.usefixtures("users_compiler")

SCENES = Path(__file__).parents[2] / "examples/scenes"

# Problem A01 of the library of multibody benchmarks; Brüls and Cardona's heavy top
PUBLISHED = {
    "pendulum": ("position.bob.0,10,-0.275087462576117", "position.bob.1,10,-0.961419205099125"),
    "heavy_top": ("q.j0.3,0.2,-.70828", "q.j0.0,0.2,.43878", "q.j0.1,0.2,.54573",
                  "q.j0.2,0.2,.0894", "position.tip.0,2,-.15041682", "position.tip.1,2,-.72416559",
                  "position.tip.2,2,-.67302227"),
}
PERIOD = "2.36784194757623745"
MOTIONS = ("pendulum", "wingnut", "euler_top", "heavy_top", "stick_slip", "arm6", "quadruped",
           "reach")
SMOOTH = MOTIONS[:4]
DIGITS = {"double": 1e-7, "single": 0.2}
"""Largest ratio of a bound to the size of its quantity, so that comparisons are meaningful."""


def coarse(name: str, precision: str) -> float:
    """The longer of the two steps.  Single precision has few steps, since rounding errors dominate
    there."""
    return kernels(name).scene.run.step * {"double": 1, "single": 4}[precision]


def published(name: str) -> tuple[Figure, ...]:
    return tuple(Figure(*line.split(",")) for line in PUBLISHED[name])


def last_place(x: Figure) -> float:
    """Half a unit in the last digit of a figure as printed."""
    return 0.5 * 10.0**-len(x.value.partition(".")[2])


@cache
def kernels(name: str) -> Kernels:
    """The kernels of an example scene, or of one of the tops."""
    tops = {"euler_top": _euler_top, "heavy_top": _heavy_top}
    return checked(tops[name]() if name in tops else SCENES / f"{name}.toml", "rk4", "dop853",
                   others=("energy", "momentum", "body_poses"))


def _euler_top() -> Scene:
    moments, start = rigid_body.TOP
    return mechanisms.scene(mechanisms.ball(moments=(*moments, 0, 0, 0)),
                            start_v={"j0": tuple(map(float, start))}, run=Run(10, "rk4", 2e-3))


def _heavy_top() -> Scene:
    ball = mechanisms.ball(heavy_top.MASS, (0, heavy_top.LENGTH, 0),
                           (*heavy_top.ABOUT_CENTRE, 0, 0, 0))
    tip = mechanisms.Body("tip")
    held = mechanisms.Joint("held", Kind.FIXED, "b0", "tip",
                            mechanisms.at(0, heavy_top.LENGTH, 0))
    model = mechanisms.Model("heavy_top", (*ball.bodies, tip), (*ball.joints, held))
    return mechanisms.scene(model, mechanisms.gravity(0, 0, "-" + heavy_top.GRAVITY),
                            start_v={"j0": tuple(map(float, heavy_top.START))},
                            run=Run(2, "rk4", 1e-4))


def figures(name: str) -> tuple[Figure, ...]:
    """The committed figures of a motion, quantities named as its scene names them."""
    if name in ("wingnut", "euler_top"):
        ours = ("base", "nut") if name == "wingnut" else ("j0", "b0")
        return tuple(x for x in committed.read("rigid_body") if x.quantity.split(".")[1] in ours)
    return tuple(x._replace(quantity=f"position.tip{x.quantity[1:]}")
                 if x.quantity.startswith("n.") else x for x in committed.read(name))


# the references themselves

@pytest.mark.parametrize("module", (pendulum, rigid_body, heavy_top), ids=lambda x: x.__name__[17:])
def test_committed_figures_are_what_their_command_prints(module):
    assert tuple(module.figures()) == committed.read(module.__name__.rpartition(".")[2])


@pytest.mark.parametrize("name, count", (
    ("stick_slip", 2), ("arm6", 1), ("quadruped", 1), ("reach", 2)))
def test_the_peers_figures_are_found_again(name, count):
    """The first figures of their runs, recomputed, also with other tolerances: they differ by no
    more than these tolerances cause."""
    if name not in ("stick_slip", "reach"):
        pytest.importorskip("pinocchio", reason="no wheel for this platform")
    module = __import__(f"tests.references.{name}", fromlist=[name])
    times = module.TIMES[:count]
    tight, loose = (np.array([float(x.value) for x in module.figures(times, tolerance)])
                    for tolerance in (1e-13, 1e-10))
    kept = np.array([float(x.value) for x in committed.read(name)[:len(tight)]])
    assert np.max(np.abs(tight - kept)) <= np.max(np.abs(tight - loose)) < 1e-5


@pytest.mark.parametrize("name", PUBLISHED)
def test_references_are_the_published_figures(name):
    known = {(x.quantity, float(x.at)): x.value for x in figures(name)}
    for x in published(name):
        assert abs(float(known[x.quantity, float(x.at)]) - float(x.value)) <= last_place(x), x


def test_the_reference_pendulum_keeps_its_energy_and_period():
    mp.dps = 50
    its = pendulum.Pendulum()
    assert mpmath.nstr(its.period, 18) == PERIOD
    for t in map(mpf, pendulum.TIMES):
        theta, rate = its.at(t)
        assert abs(rate**2 / 2 - its.g * mp.cos(theta)) < mpf(10)**-45


@pytest.mark.parametrize("case", (rigid_body.NUT, rigid_body.TOP), ids=("nut", "top"))
def test_the_reference_bodies_obey_eulers_equations(case):
    """I ω' = I ω × ω, R' = R ω~, R(0) = 1, by differences of 60 digits."""
    mp.dps = 60
    body, h = rigid_body.solution(*case), mpf(10)**-15
    assert all(abs(x - mpf(y)) < mpf(10)**-28 for x, y in zip(body.omega(mpf(0)), case[1],
                                                               strict=True))
    assert mp.norm(rigid_body.attitude(body, mpf(0)) - mp.eye(3)) < mpf(10)**-28
    for t in (mpf("0.3"), mpf("4")):
        w, I = body.omega(t), body.I
        rate = [(x - y) / (2 * h)
                for x, y in zip(body.omega(t + h), body.omega(t - h), strict=True)]
        for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
            assert abs(I[i] * rate[i] - (I[j] - I[k]) * w[j] * w[k]) < mpf(10)**-25 * max(I)
        R = rigid_body.attitude(body, t)
        turn = R.T * (rigid_body.attitude(body, t + h) - rigid_body.attitude(body, t - h)) / (2 * h)
        for i, (j, k) in enumerate(((2, 1), (0, 2), (1, 0))):
            assert abs(turn[j, k] - w[i]) < mpf(10)**-25


def test_the_reference_top_keeps_energy_momentum_and_spin():
    known = {(x.quantity, x.at): mpf(x.value) for x in committed.read("heavy_top")}
    J = [mpf(x) for x in heavy_top.ABOUT_CENTRE]
    J = [J[0] + mpf(heavy_top.MASS), J[1], J[2] + mpf(heavy_top.MASS)]
    weight = mpf(heavy_top.MASS) * mpf(heavy_top.GRAVITY)
    start = [mpf(x) for x in heavy_top.START]
    for t in heavy_top.TIMES:
        w, q = [known[f"v.j0.{i}", t] for i in range(3)], [known[f"q.j0.{i}", t] for i in range(4)]
        energy = sum(i * x**2 for i, x in zip(J, w, strict=True)) / 2 + weight * known["n.2", t]
        begun = sum(i * x**2 for i, x in zip(J, start, strict=True)) / 2
        assert abs(energy - begun) < mpf(10)**-22
        x, y, z, s = q
        up = [2 * (x * z - s * y), 2 * (y * z + s * x),
              s**2 - x**2 - y**2 + z**2]  # e_z in the body
        about = sum(i * x * n for i, x, n in zip(J, w, up, strict=True))
        assert abs(about - J[2] * start[2]) < mpf(10)**-24
        assert abs(w[1] - 150) < mpf(10)**-26


# runs against them

@pytest.mark.parametrize("precision", ("double", "single"))
@pytest.mark.parametrize("name", MOTIONS)
def test_motions_are_the_references(name, precision):
    _compare(runs.compared(kernels(name), figures(name), precision, "rk4", coarse(name, precision)),
             figures(name), precision)


@pytest.mark.parametrize("name", SMOOTH)
def test_motions_of_dop853_are_the_references(name):
    _compare(runs.compared(kernels(name), figures(name), "double", "dop853", 1e-10), figures(name),
             "double")


def _compare(results: tuple[runs.Compared, ...], wanted: tuple[Figure, ...], precision: str
             ) -> None:
    for x in results:
        print(f"{x.quantity}: {x.error:.2g} of {x.integration:.2g} + {x.rounding:.2g}")
        size = max(abs(float(y.value)) for y in wanted if y.quantity.split(".")[0] == x.quantity)
        assert x.error <= x.bound <= DIGITS[precision] * size, x


@pytest.mark.parametrize("name", PUBLISHED)
def test_motions_have_the_published_figures(name):
    """In double precision, to as many digits as are printed, or to 1e-10."""
    its, wanted = kernels(name), published(name)
    result, _ = runs.values(system(its, "double"), wanted, "rk4", its.scene.run.step / 2)
    for came, x in zip(result, wanted, strict=True):
        assert abs(came - float(x.value)) <= max(last_place(x), 1e-10), (x, came)


def test_the_period_is_the_published_one():
    """The pendulum is back where it was released, with a speed of at most v' δt, δt the error of
    the period."""
    back = (Figure("v.pivot", PERIOD, "0"),)
    (v,), _ = runs.values(system(kernels("pendulum"), "double"), back, "rk4", 5e-4)
    assert abs(v) <= 9.81 * 1e-12


@pytest.mark.parametrize("precision", ("double", "single"))
@pytest.mark.parametrize("name", ("wingnut", "euler_top"))
def test_free_bodies_keep_energy_and_angular_momentum(name, precision):
    moments, start = rigid_body.NUT if name == "wingnut" else rigid_body.TOP
    I, w = [Fraction(x) for x in moments], [Fraction(x) for x in start]
    speed = Fraction(rigid_body.NUT_VELOCITY) if name == "wingnut" else 0
    energy = sum(i * x**2 for i, x in zip(I, w, strict=True)) / 2 + Fraction("0.05") * speed**2 / 2
    wanted = [Figure("energy", t, repr(float(energy))) for t in rigid_body.TIMES]
    wanted += [Figure(f"momentum.{3 + i}", t, repr(float(I[i] * w[i])))
               for t in rigid_body.TIMES for i in range(3)]
    _compare(runs.compared(kernels(name), wanted, precision, "rk4", coarse(name, precision)),
             wanted, precision)


def test_a_leaping_quadruped_flies_like_a_stone():
    """Whatever its motors do, p(t) = p(0) + m g t, and the angular momentum about the centre of
    mass is constant."""
    its = system(kernels("quadruped"), "double")
    times = (0.0, 0.125, 0.25, 0.5)
    requested = [Figure(f"momentum.{i}", str(t), "0") for t in times for i in range(6)]
    step = its.scene.run.step
    (coarse, _), (fine, run) = (runs.values(its, requested, "rk4", h) for h in (step, step / 2))
    rounding = 2 * run.steps * runs.ROUNDOFF["double"] * np.max(np.abs(fine))
    bound = np.max(np.abs(coarse - fine)) + rounding
    p, L = fine.reshape(-1, 6)[:, :3], fine.reshape(-1, 6)[:, 3:]
    mass, g, t = 9 + 4 * (0.7 + 0.95 + 0.2), np.array([0, 0, -9.81]), np.array(times)[:, None]
    assert np.max(np.abs(p - p[0] - mass * g * t)) <= bound < 1e-7
    # L' = c × m g, with the centre of mass at c(t) = c(0) + p(0) t / m + g t²/2: along x and y
    falling = np.cross(p[0] * t**2 / 2, g)
    slope = (L[1] - L[0] - falling[1]) / times[1]  # c(0) × m g, which the rest must agree with
    assert np.max(np.abs(L - L[0] - falling - slope * t)) <= 8 * bound
