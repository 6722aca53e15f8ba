"""Gradients of whole runs equal differences in 50 digits, of runs call by call; runs in parts at
limits, too."""

import importlib.util
from collections.abc import Callable
from pathlib import Path

import mpmath
import numpy as np
import pytest
from mpmath import mpf

from coscrew_codegen import load_scene, run_adjoint
from coscrew_codegen.dynamics import derive
from coscrew_codegen.reports.cost.step_interpreter import StepRun, functions_on
from coscrew_codegen.runtime.load import Kernels
from coscrew_codegen.simulation import SimulateError
from coscrew_codegen.simulation import run_adjoint as module
from tests.support.scenes.evaluation import evaluator, without_errors

ROOT = Path(__file__).parents[2]
SIZE = mpf(10)**-18
NUMBERS = without_errors("double")
Cost = Callable[[list[mpf], list[mpf]], mpf]


def throw() -> object:
    """The example, as a module."""
    spec = importlib.util.spec_from_file_location("throw", ROOT / "examples/throw.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


class Exact:
    """Runs of a scene's step in 50 digits."""

    def __init__(self, kernels: Kernels, step: str):
        self.functions = derive(kernels.scene, (step, "integrated"))
        self.step = self.functions.steps[0]
        self.called = functions_on(self.functions, self.step, NUMBERS.arithmetic)
        self.p = {x: mpf(value) for x, value in self.functions.parameters}

    def end(self, start: tuple[list[mpf], list[mpf]], h: float, n: int, **p: mpf
            ) -> tuple[list[mpf], list[mpf]]:
        run = StepRun(self.functions, self.step, self.called, mpf, {**self.p, **p})
        return next(run.states(start, h, [n]))

    def along(self, q: list[mpf], phi: list[mpf]) -> list[mpf]:
        program = self.functions.named("integrated").program
        return list(evaluator(program, NUMBERS)([q, phi]))


def gradient(exact: Exact, cost: Cost, start: tuple[np.ndarray, np.ndarray], h: float, n: int
             ) -> tuple[list[mpf], list[mpf], list[mpf]]:
    """Central differences of a cost of the end by q along velocities, by v, and by parameters."""
    q, v = ([mpf(x) for x in part] for part in start)
    nv = len(v)

    def difference(made: Callable[[mpf], tuple[list[mpf], list[mpf]]]) -> mpf:
        return (cost(*made(SIZE)) - cost(*made(-SIZE))) / (2 * SIZE)

    def unit(i: int, size: mpf) -> list[mpf]:
        return [size * int(i == k) for k in range(nv)]

    by_q = [difference(lambda s, i=i: exact.end((exact.along(q, unit(i, s)), v), h, n))
            for i in range(nv)]
    by_v = [difference(lambda s, i=i: exact.end(
        (q, [x + d for x, d in zip(v, unit(i, s), strict=True)]), h, n)) for i in range(nv)]
    by_p = [difference(lambda s, x=x: exact.end((q, v), h, n, **{x: exact.p[x] + s}))
            for x in exact.p]
    return by_q, by_v, by_p


def close(own: np.ndarray, wanted: list[mpf], size: float) -> None:
    """To so many units in the last place of the largest."""
    wanted = np.array([float(x) for x in wanted])
    assert np.abs(own - wanted).max(initial=0) <= size * 2.0**-53 * np.abs(wanted).max(initial=1)


def test_gradient_of_a_throw(tmp_path: Path) -> None:
    """The miss of a dart with feathers, by all 12 numbers of its start and by its drag."""
    example, n, h = throw(), 20, 2e-2
    kernels = example.load(tmp_path)
    start = kernels.neutral_q, example.THROW + np.array([0, 0.5, 0, 1, 0.5, 0])
    target = example.TARGET

    def cost(q: list[mpf], v: list[mpf]) -> mpf:
        return mpmath.fsum((x - mpf(y))**2 for x, y in zip(q[:3], target, strict=True))

    def weights(k: int, q: np.ndarray, v: np.ndarray) -> object:
        away = 2 * np.array([*(q[:3] - target), 0, 0, 0, 0])
        return (away @ kernels.double.chart(q), np.zeros(6)) if k == n else None

    run = run_adjoint(kernels, n, weights, step=h, v0=start[1])
    with mpmath.workdps(50):
        wanted = gradient(Exact(kernels, "step_leapfrog"), cost, start, h, n)
        for own, exact in zip((run.g_q, run.g_v, run.g_p), wanted, strict=True):
            close(own, exact, 1000)


def test_the_dart_hits(capsys: pytest.CaptureFixture[str]) -> None:
    """Within a hundredth of a millimetre."""
    assert throw().main() < 1e-5
    assert "after" in capsys.readouterr().out


LIMITED = """
runtime = ["limit.hinge.k"]
[bodies]
door = { mass = 2, com = [0, 0.1, -0.25], inertia = [0.04, 0.04, 0.002] }
[joints]
hinge = { type = "revolute", child = "door", axis = [0, 1, 0] }
[effects.gravity]
[effects.limit.hinge]
lower = -0.5
upper = 0.5
k = 1e4
alpha = 0.3
[run]
step = 0.01
"""


@pytest.fixture(scope="module")
def door(tmp_path_factory: pytest.TempPathFactory) -> Kernels:
    path = tmp_path_factory.mktemp("door") / "door.toml"
    path.write_text(LIMITED)
    return load_scene(path)


def test_through_steps_in_parts(door: Kernels) -> None:
    """A bounce, whose steps are split."""
    n, start = 30, (np.array([0.3]), np.array([2.0]))

    def cost(q: list[mpf], v: list[mpf]) -> mpf:
        return q[0] + v[0] / 2

    run = run_adjoint(door, n, lambda k, q, v: ([1], [0.5]) if k == n else None,
                      q0=start[0], v0=start[1])
    with mpmath.workdps(50):
        exact = Exact(door, "step_leapfrog")
        assert exact.end(tuple([mpf(x) for x in y] for y in start), 0.01, n)[1][0] < 0  # it bounced
        for own, wanted in zip((run.g_q, run.g_v, run.g_p),
                               gradient(exact, cost, start, 0.01, n), strict=True):
            close(own, wanted, 1e5)


def test_by_torques_of_each_step(door: Kernels) -> None:
    """The sum over steps is the derivative by a torque that is constant."""
    n, tau = 25, 0.1 * np.ones((25, 1))

    def end(more: float) -> float:
        run = run_adjoint(door, n, lambda k, q, v: None, tau=tau + more)
        return float(run.q[0])

    run = run_adjoint(door, n, lambda k, q, v: ([1], [0]) if k == n else None, tau=tau)
    assert run.g_tau.shape == (n, 1) and (run.g_tau > 0).all()
    assert abs(run.g_tau.sum() - (end(1e-5) - end(-1e-5)) / 2e-5) <= 1e-8 * run.g_tau.sum()


def test_every_cost_on_the_way_counts(door: Kernels) -> None:
    """Weights of each state add up, for numbers of steps around the squares."""
    for n in (1, 2, 4, 5, 9, 10):
        seen = []
        whole = run_adjoint(door, n, lambda k, q, v: (seen.append(k), ([1], [2]))[1])
        assert seen == [*range(n, -1, -1)]
        parts = [run_adjoint(door, k, lambda j, q, v, k=k: ([1], [2]) if j == k else None).g_q
                 for k in range(1, n + 1)]
        assert abs(whole.g_q - 1 - sum(parts)) <= 1e-12 * abs(whole.g_q)


def test_states_in_memory(door: Kernels, monkeypatch: pytest.MonkeyPatch) -> None:
    """At most two for each of √n."""
    most, onward = [], module._Adjoint._onward
    monkeypatch.setattr(module._Adjoint, "_onward", lambda self, first, count, state: (
        most.append(count), onward(self, first, count, state))[1])
    run_adjoint(door, 100, lambda k, q, v: None)
    assert max(most) == 10 and len(most) == 9 + 10


@pytest.mark.parametrize("changed, problem", [
    ({"n": 0}, "0 steps of 0.01 s: wanted one or more, of positive length"),
    ({"step": -1.0}, "5 steps of -1.0 s: wanted one or more, of positive length"),
    ({"tau": np.zeros((4, 1))}, "tau: got shape (4, 1); wanted (5, 1), the torques of each step"),
    ({"integrator": "radau"}, "radau: SciPy takes its steps; wanted an integrator whose steps are "
                              "functions of the scene"),
    ({"precision": "half"}, "precision: 'half'; wanted one of double, single")])
def test_settings_are_checked(door: Kernels, changed: dict[str, object], problem: str) -> None:
    with pytest.raises(SimulateError) as refused:
        run_adjoint(door, **{"n": 5, "weights": lambda k, q, v: None, **changed})
    assert str(refused.value) == problem
