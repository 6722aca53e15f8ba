"""Every integrator moves the states of effects: against closed forms, and against another solver on
the same laws, written here once more."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
import scipy.integrate

from coscrew_codegen import again, load_scene, run
from coscrew_codegen.scene.integrators import EMITTED, NAMES
from coscrew_codegen.simulation.plan import plan
from coscrew_codegen.simulation.solvers.adaptive import adaptive
from coscrew_codegen.simulation.system import system

MASS, K, D, LEVEL, SPRING = 1.0, 4e4, 100.0, 4.0, 100.0
SLIDER = f"""
[bodies]
block = {{ mass = {MASS}, inertia = [0.1, 0.1, 0.1] }}
[joints]
slide = {{ type = "prismatic", child = "block", axis = [1, 0, 0] }}
[effects.stiction.slide]
tau_c = {LEVEL}
k = {K}
d = {D}
[effects.spring.slide]
k = {SPRING}
[run]
rtol = 1e-11
atol = 1e-13
"""
START = "[start.q]\nslide = 0.3\n"
BALL = """
[bodies]
ball = { mass = 1, inertia = [0.004, 0.004, 0.004] }
[joints]
free = { type = "free", child = "ball" }
[effects.gravity]
[effects.contact.ball]
shape = "sphere"
radius = 0.1
mu = 0.5
[run]
rtol = 1e-11
atol = 1e-13
"""
ADAPTIVE = ("dop853", "radau")
Made = Callable[[str], Path]


@pytest.fixture
def made(tmp_path: Path) -> Made:
    def written(text: str) -> Path:
        path = tmp_path / "thing.toml"
        path.write_text(text)
        return path
    return written


def by_another_solver(times: np.ndarray, q: float) -> np.ndarray:
    """q of the slider at these times.  Bristles hold, z' = v, or slip at z = ±LEVEL/K; the solver
    begins anew where they begin to do either, and where the force reaches its limit."""
    bound = LEVEL / K

    def rates(_t: float, y: np.ndarray, slips: int) -> list[float]:
        x, v, z = y
        pull = K * (slips * bound if slips else z) + D * v
        return [v, (-SPRING * x - np.clip(pull, -LEVEL, LEVEL)) / MASS, 0.0 if slips else v]

    def yields(_t: float, y: np.ndarray, slips: int) -> float:
        return bound - abs(y[2]) if not slips else slips * y[1]

    def limited(_t: float, y: np.ndarray, slips: int) -> float:
        return LEVEL - abs(K * y[2] + D * y[1]) if not slips else 1.0

    yields.terminal = limited.terminal = True  # type: ignore[attr-defined]
    yields.direction = -1  # type: ignore[attr-defined]
    t, y, slips, results = 0.0, np.array([q, 0.0, 0.0]), 0, []
    while t < times[-1]:
        run = scipy.integrate.solve_ivp(
            rates, (t, times[-1]), y, "DOP853", dense_output=True, events=(yields, limited),
            args=(slips,), rtol=1e-12, atol=1e-14)
        results += [float(run.sol(x)[0]) for x in times if t <= x < run.t[-1] or
                    x == run.t[-1] == times[-1]]
        t, y = run.t[-1], run.y[:, -1]
        if len(run.t_events[0]):
            slips = 0 if slips else int(np.sign(y[2]))
            y[2] = np.sign(y[2]) * bound
        elif run.status == 1:  # past the limit
            y = y + 1e-12 * np.array(rates(t, y, slips))
    return np.array(results)


@pytest.mark.parametrize("integrator, step, within", [
    ("dop853", None, 1e-9), ("radau", None, 1e-9), ("leapfrog", 2e-5, 1e-6), ("rk4", 2e-5, 1e-6),
    ("semi-implicit-euler", 2e-5, 1e-4), ("linear-implicit-euler", 2e-5, 1e-2)])
def test_a_block_sticks_and_slips_as_by_another_solver(made: Made, integrator: str,
                                                       step: float | None, within: float) -> None:
    """Two swings, with changes between slip and hold."""
    result = run(made(SLIDER + START), until=1, every=0.05, integrator=integrator, step=step,
                 precision="double")
    assert np.abs(result.q[:, 0] - by_another_solver(result.t, 0.3)).max() < within


def held(t: np.ndarray, q: float) -> np.ndarray:
    """The damped oscillation of a block on bristles and spring that do not slip: z = x - q."""
    k, omega0 = K + SPRING, K * q / (K + SPRING)
    rate = D / (2 * MASS)
    omega = np.sqrt(k / MASS - rate**2)
    away = q - omega0
    return omega0 + away * np.exp(-rate * t) * (
        np.cos(omega * t) + rate / omega * np.sin(omega * t))


@pytest.mark.parametrize("integrator, order", [(x.name, x.order) for x in EMITTED])
def test_orders_are_kept_with_states(made: Made, integrator: str, order: int) -> None:
    """A block on bristles that hold is a damped oscillator."""
    q, kernels = 0.01, load_scene(made(SLIDER + "[start.q]\nslide = 0.01\n"),
                                  functions=["step_" + integrator.replace("-", "_")])
    errors = []
    for step in (4e-4, 2e-4):
        result = run(kernels, until=0.04, every=0.02, integrator=integrator, step=step)
        errors.append(abs(result.q[-1, 0] - held(result.t[-1], q)))
    assert np.log2(errors[0] / errors[1]) == pytest.approx(order, abs=0.35)


@pytest.mark.parametrize("integrator", ADAPTIVE)
def test_solvers_are_true_to_the_oscillation_of_bristles(made: Made, integrator: str) -> None:
    result = run(made(SLIDER + "[start.q]\nslide = 0.01\n"), until=0.2, every=0.01,
                 integrator=integrator)
    assert np.abs(result.q[:, 0] - held(result.t, 0.01)).max() < 1e-11


def ball(z: float, v: str = "") -> str:
    speeds = f"[start.v]\nfree = {v}\n" if v else ""
    return f"{BALL}[start.q]\nfree = [0, 0, {z}, 0, 0, 0, 1]\n{speeds}"


@pytest.mark.parametrize("integrator", ADAPTIVE)
def test_a_step_ends_where_a_ball_lands(made: Made, integrator: str) -> None:
    """At √(2 h/g), and at the end of the elastic bounce, when it rises as fast as it fell."""
    path = made(ball(0.6).replace("mu = 0.5", "mu = 0\nalpha = 0"))
    its = system(load_scene(path, functions=["forward_dynamics", "state_rates", "law_switches"]),
                 "double")
    planned, reached = plan(its, 0.5, None, integrator, 0.5), []
    for _ in adaptive(its, planned, np.array([0.0, 0.5]), *its.start(),
                      watch=lambda t, q, v: reached.append((t, q[2], v[2]))):
        pass
    landing = np.sqrt(2 * 0.5 / 9.81)
    times = np.array([t for t, _, _ in reached])
    assert np.abs(times - landing).min() < 1e-9
    after = [(z, v) for t, z, v in reached if t > landing + 1e-4 and abs(z - 0.1) < 1e-9]
    assert len(after) == 1
    assert after[0][1] == pytest.approx(9.81 * landing, rel=1e-8)


@pytest.mark.parametrize("integrator", ADAPTIVE)
def test_a_sliding_ball_ends_rolling_at_five_sevenths_by_solvers(made: Made, integrator: str
                                                                 ) -> None:
    start = ball(0.099, "[3, 0, 0, 0, 0, 0]")
    result = run(made(start.replace("1e-11", "1e-9")), until=2, every=1, integrator=integrator)
    speed = np.hypot(*np.abs([result.v[-1, 0], result.v[-1, 2]]))
    assert abs(speed / (5 / 7 * 3) - 1) < 1e-7


@pytest.mark.parametrize("integrator", NAMES)
def test_runs_repeat_and_go_on_to_the_bit(made: Made, tmp_path: Path, integrator: str) -> None:
    path = made(SLIDER + START)
    whole = run(path, until=0.1, step=5e-5, integrator=integrator)
    whole.write(tmp_path / "whole.csv")
    assert again(path, tmp_path / "whole.csv").q.tobytes() == whole.q.tobytes()
    if integrator in ADAPTIVE:
        return
    run(path, until=0.05, step=5e-5, integrator=integrator).write(tmp_path / "first.csv")
    onward = run(path, start=tmp_path / "first.csv", until=0.1, step=5e-5,
                 integrator=integrator)
    assert onward.q.tobytes() == whole.q[-len(onward.t):].tobytes()


@pytest.mark.parametrize("integrator", [x.name for x in EMITTED])
def test_batches_have_the_bits_of_one_state_by_every_step(made: Made, integrator: str) -> None:
    kernels = load_scene(made(SLIDER + START),
                         functions=["step_" + integrator.replace("-", "_")])
    q0 = np.linspace(0.01, 0.3, 5)[:, None] * [1, 1e-4]
    many = run(kernels, until=0.02, step=5e-5, q0=q0, integrator=integrator)
    for n in range(5):
        one = run(kernels, until=0.02, step=5e-5, q0=q0[n], integrator=integrator)
        assert one.q.tobytes() == many.q[n].tobytes()
