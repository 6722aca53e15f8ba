"""Motions of closed loops: published figures, equations of one freedom, trees that move alike."""

import math
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
import scipy.integrate

from coscrew_codegen import load_scene
from coscrew_codegen.runtime.load import Kernels
from coscrew_codegen.simulation.system import System, system
from tests.support.scenes import closed_loops

PUBLISHED = {"beta": 15.81077119629904, "theta": -15.75637105984298, "gamma": 0.04082224013073101,
             "delta": 0.5244099658805304, "epsilon": 1.048080741042263}
"""Angles of Andrews' mechanism at 0.03 s, in the test set for solvers of initial value problems."""
Loaded = Callable[..., Kernels]


@pytest.fixture(scope="module")
def loaded(tmp_path_factory: pytest.TempPathFactory) -> Loaded:
    """Scenes of texts, each compiled once."""
    folder, known = tmp_path_factory.mktemp("loops"), dict[str, Kernels]()

    def loaded(text: str, *functions: str) -> Kernels:
        key = f"{functions} {text}"
        if key not in known:
            path = folder / f"scene{len(known)}.toml"
            path.write_text(text, encoding="utf-8")
            known[key] = load_scene(path, functions=["default", *functions])
        return known[key]

    return loaded


def moved(its: System, h: float, steps: int, integrator: str = "leapfrog"
          ) -> tuple[np.ndarray, np.ndarray]:
    """q and v after so many steps from the scene's start."""
    return its.stepper(f"step_{integrator}")(steps, 0.0, h, *its.start())


def closure(its: System, q: np.ndarray) -> float:
    """The largest gap, in m or rad."""
    return float(abs(its.outputs("closure", q=q)[0]).max())


# published motions


def test_andrews_mechanism_moves_as_published(loaded: Loaded) -> None:
    its = system(loaded(closed_loops.andrews(), "step_rk4"), "double")
    errors = []
    for steps in (1500, 3000, 6000):
        q, _ = moved(its, 0.03 / steps, steps)
        errors.append(abs(q[0] - PUBLISHED["beta"]))
        assert closure(its, q) < 1e-14
    assert errors[1] < 1e-4
    for coarse, fine in zip(errors, errors[1:], strict=False):
        assert 1.9 < math.log2(coarse / fine) < 2.1
    q, _ = moved(its, 0.03 / 3000, 3000, "rk4")
    named = dict(zip((c.joint for c in its.functions.coordinates), q, strict=True))
    for name in ("beta", "theta", "gamma", "delta", "epsilon"):
        assert named[name] == pytest.approx(PUBLISHED[name], abs=4e-9), name


def linked_angle(t: float) -> float:
    """The angle from the vertical of the posts of the linked four-bars, by their one equation."""
    solved = scipy.integrate.solve_ivp(
        lambda _, y: (y[1], 3.5 * 9.81 / 3 * math.sin(y[0])), (0, t), (0.0, 1.0), "DOP853",
        rtol=1e-13, atol=1e-13)
    return float(solved.y[0, -1])


@pytest.mark.parametrize("kind", ["point", "hinge"])
def test_linked_four_bars_pass_their_dead_points(loaded: Loaded, kind: str) -> None:
    """At dead points one of the rows repeats others; a hinge's rows across the plane always do."""
    its = system(loaded(closed_loops.linked_four_bars(kind), "step_rk4"), "double")
    angle = math.pi / 2 - linked_angle(10)
    assert angle < -30  # ten turns, which pass dead points 20 times
    q, _ = moved(its, 1e-3, 10_000)
    assert math.hypot(math.cos(q[0]) - math.cos(angle), math.sin(q[0]) - math.sin(angle)) < 1e-6
    assert closure(its, q) < 1e-13
    q, _ = moved(its, 1e-3, 10_000, "rk4")
    assert abs(q[0] - angle) < 1e-10


@pytest.mark.parametrize("integrator", ["leapfrog", "rk4"])
def test_in_single_they_lose_half_their_digits(loaded: Loaded, integrator: str) -> None:
    """Near a dead point rounding turns the posts by its root; they pass in the right direction."""
    its = system(loaded(closed_loops.linked_four_bars(), "step_rk4"), "single")
    q, v = moved(its, 1e-3, 10_000, integrator)
    assert abs(q[0] - (math.pi / 2 - linked_angle(10))) < 5e-3
    start = sum(its.energies(0, *its.start()))
    assert abs(sum(its.energies(0, q, v)) - start) < 3e-5 * start


# what is kept


def test_a_crank_rocker_stays_closed_and_keeps_its_energy(loaded: Loaded) -> None:
    its = system(loaded(closed_loops.crank_rocker()), "double")
    q, v = its.start()
    step, kept = its.stepper("step_leapfrog"), sum(its.energies(0, q, v))
    for _ in range(100):
        q, v = step(1000, 0.0, 1e-3, q, v)
        assert abs(sum(its.energies(0, q, v)) - kept) < 1e-3 * kept
    q, v = step(900_000, 0.0, 1e-3, q, v)
    assert closure(its, q) < 1e-10


def test_in_single_a_crank_stays_closed_as_far_as_its_angle_is_resolved(loaded: Loaded) -> None:
    its = system(loaded(closed_loops.crank_rocker()), "single")
    q, _ = moved(its, 1e-3, 100_000)
    assert abs(q[0]) > 100  # rad
    assert closure(its, q) < float(np.finfo(np.float32).eps) * abs(q).max()


def test_rows_that_repeat_others_change_no_motion(loaded: Loaded) -> None:
    once, thrice, hinge = (system(loaded(closed_loops.crank_rocker(*x)), "double") for x in (
        ("point", 1), ("point", 3), ("hinge", 1)))
    q, v = moved(once, 1e-3, 2000)
    for other in (thrice, hinge):
        q2, v2 = moved(other, 1e-3, 2000)
        assert np.allclose(q, q2, rtol=0, atol=1e-9)
        assert np.allclose(v, v2, rtol=0, atol=1e-8)


def test_closures_that_repeat_each_other_share_their_forces(loaded: Loaded) -> None:
    its = system(loaded(closed_loops.crank_rocker("point", 2), "closing_*"), "double")
    q, v = its.start()
    first, second = (its.call(f"closing_knee{n}", t=0.0, q=q, v=v, tau=np.zeros(3))
                     for n in range(2))
    assert np.allclose(first, second, rtol=1e-5)  # roundoff/ε
    assert abs(first).max() > 1


def test_a_floating_loop_keeps_its_momentum(loaded: Loaded) -> None:
    its = system(loaded(closed_loops.floating_loop()), "double")
    q, v = its.start()
    assert its.has("free_momentum")
    before = its.call("momentum", q=q, v=v)
    q, v = moved(its, 1e-3, 10_000)
    assert np.allclose(its.call("momentum", q=q, v=v), before, rtol=0, atol=1e-11)
    assert closure(its, q) < 1e-12


def test_projection_alone_keeps_momentum(loaded: Loaded) -> None:
    """Its impulses act between the bodies of the loop."""
    its = system(loaded(closed_loops.floating_loop()), "double")
    q, v = its.start()
    v = v + np.linspace(-1, 1, len(v))
    _, onto = its.outputs("with_closed_loops", q=q, v=v)
    assert abs(onto - v).max() > 0.1
    assert np.allclose(its.call("momentum", q=q, v=onto), its.call("momentum", q=q, v=v),
                       rtol=0, atol=1e-13)


# closures against other mechanisms


def test_a_rod_pulls_a_body_round_a_circle(loaded: Loaded) -> None:
    """f = -m v²/r towards the centre, and the angle is v t/r."""
    its = system(loaded(closed_loops.rope(), "closing_rod"), "double")
    q, v = its.start()
    f = its.call("closing_rod", t=0.0, q=q, v=v, tau=np.zeros(6))
    assert np.allclose(f, [-3 * 5**2 / 2, 0, 0, 0, 0, 0], atol=1e-12)
    q, v = moved(its, 1e-3, 1000)
    assert math.hypot(*q[:3]) == pytest.approx(2, abs=1e-13)
    assert math.atan2(q[1], q[0]) == pytest.approx(2.5, abs=2e-6)
    assert np.allclose(q[3:], [0, 0, 0, 1], atol=1e-14)


def test_a_cut_beam_that_is_welded_moves_as_a_whole_one(loaded: Loaded) -> None:
    cut, whole = (system(loaded(closed_loops.beam(x), "step_rk4"), "double") for x in (True, False))
    (q, v), (q2, v2) = (moved(x, 1e-3, 1000, "rk4") for x in (cut, whole))
    assert np.allclose(q[:2], q2, rtol=0, atol=1e-9)
    assert np.allclose(v[:2], v2, rtol=0, atol=1e-8)
    assert abs(v2).max() > 1


# integrators


@pytest.mark.parametrize("name", ["dop853", "radau"])
def test_solvers_of_scipy_stay_on_closures(tmp_path: Path, name: str) -> None:
    from coscrew_codegen.simulation.api import run

    path = tmp_path / "bars.toml"
    path.write_text(closed_loops.linked_four_bars(), encoding="utf-8")
    result = run(path, integrator=name, until=2.0, every=0.013)
    assert result.q[-1][0] == pytest.approx(math.pi / 2 - linked_angle(2), abs=1e-7)
    phi, E = result.system.outputs("closure", q=result.q)
    assert abs(phi).max() < 1e-13
    assert abs(np.einsum("nij,nj->ni", E, result.v)).max() < 1e-11


@pytest.mark.parametrize("name", ["semi_implicit_euler", "linear_implicit_euler"])
def test_methods_of_order_1_stay_on_closures(loaded: Loaded, name: str) -> None:
    its = system(loaded(closed_loops.linked_four_bars(), f"step_{name}"), "double")
    angle, errors = math.pi / 2 - linked_angle(1), []
    for steps in (1000, 2000, 4000):
        q, _ = moved(its, 1 / steps, steps, name)
        errors.append(abs(q[0] - angle))
        assert closure(its, q) < 1e-12
    assert math.log2(errors[1] / errors[2]) > 0.9
    assert errors[-1] < 1e-2


@pytest.mark.parametrize("integrator", ["leapfrog", "rk4"])
def test_a_step_of_zero_moves_nothing(loaded: Loaded, integrator: str) -> None:
    its = system(loaded(closed_loops.andrews(), "step_rk4"), "double")
    q, v = moved(its, 1e-5, 100)
    for end, start in zip(its.stepper(f"step_{integrator}")(1, 0.0, 0.0, q, v), (q, v),
                          strict=True):
        assert abs(end - start).max() < 1e-10 * abs(start).max()
