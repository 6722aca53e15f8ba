"""Controllers made of a step's derivatives hold what they promise."""

from pathlib import Path

import numpy as np
import pytest
from scipy.optimize import minimize

from coscrew_codegen import load_scene
from coscrew_codegen.runtime.callables import Functions
from tests.support.example_programs import example


def test_the_regulator_balances_two_links_on_a_cart(capsys: pytest.CaptureFixture[str]) -> None:
    """From 0.15 rad and -0.1 rad, with a force on the cart alone."""
    q, v = example("balance").main()
    assert np.abs(q).max() < 1e-5 and np.abs(v).max() < 1e-5
    assert "upright" in capsys.readouterr().out


def test_the_model_of_the_regulator_is_the_step(tmp_path: Path) -> None:
    """A and B are differences of the compiled step; upright the free step is unstable, and with
    feedback it is stable."""
    its = example("balance")
    functions, zero = its.load(tmp_path), np.zeros(3)
    q, v, A, B = functions.step_leapfrog_tau_derivatives(its.STEP, zero, zero, zero)
    assert not q.any() and not v.any()
    small = 1e-5 * np.eye(3)
    columns = [np.concatenate(functions.step_leapfrog_tau(its.STEP, *x)) for sign in (1, -1)
               for x in (*((sign * e, zero, zero) for e in small),
                         *((zero, sign * e, zero) for e in small),
                         *((zero, zero, sign * e) for e in small))]
    differences = (np.array(columns[:9]) - np.array(columns[9:])).T / 2e-5
    assert np.abs(differences - np.hstack((A, B))).max() < 1e-9
    free, held = (np.abs(np.linalg.eigvals(x)).max()
                  for x in (A, A - B[:, :1] @ its.gains(functions)[None]))
    assert free > 1.001 and held < 0.9999


LIMITS = np.array([150, 150, 150, 28, 28, 28])
AIM = np.array([1.6, -0.3, 0.4, -0.1, 0.3, 1, *[0] * 6])
STEPS, LONG, SHORT, EFFORT = 15, 0.02, 1e-3, 1e-4
BY_STATE = np.array([*[10] * 6, *[0.1] * 6])


def cost(plan: np.ndarray, x: np.ndarray, functions: Functions[np.float64]
         ) -> tuple[float, np.ndarray]:
    """The cost that predictive.c minimises, and its gradient, by recursion from the plan's end."""
    zero, states, slopes = np.zeros(6), [x], []
    hold = functions.inverse_dynamics(AIM[:6], zero, zero)
    plan = plan.reshape(STEPS, 6)
    for u in plan:
        q, v, A, B = functions.step_leapfrog_tau_derivatives(LONG, states[-1][:6], states[-1][6:],
                                                             u)
        states.append(np.concatenate((q, v)))
        slopes.append((A, B))
    weights = [*[BY_STATE] * STEPS, 20 * BY_STATE]
    total = sum(w @ (y - AIM)**2 / 2 for y, w in zip(states, weights, strict=True))
    gradient, p = np.zeros((STEPS, 6)), weights[-1] * (states[-1] - AIM)
    for k in reversed(range(STEPS)):
        A, B = slopes[k]
        gradient[k] = B.T @ p + EFFORT * (plan[k] - hold)
        p = A.T @ p + weights[k] * (states[k] - AIM)
    return total + EFFORT * ((plan - hold)**2).sum() / 2, gradient.ravel()


def test_predictive_control_is_optimal_within_limits_and_fast(tmp_path: Path) -> None:
    """The motion is that of the arm's step; the arm arrives; torques reach their limits and are
    those that SciPy finds from the same states; and control takes less than its millisecond."""
    log = example("predictive").run(tmp_path)
    functions = load_scene(tmp_path / "arm.toml").double
    q, v, torques = log[0, 1:7], np.zeros(6), log[:, 7:13]
    for tick in range(301):
        assert np.abs(q - log[tick, 1:7]).max() < 1e-6
        if tick in (100, 300):
            best = minimize(cost, np.tile(torques[-1], STEPS), (np.concatenate((q, v)), functions),
                            "L-BFGS-B", jac=True, bounds=[(-x, x) for x in LIMITS] * STEPS,
                            options={"maxiter": 3000, "ftol": 1e-15, "maxfun": 9000})
            assert np.abs((best.x[:6] - torques[tick]) / LIMITS).max() < 0.01, tick
        q, v = functions.step_leapfrog_tau(SHORT, q, v, torques[tick])
    assert np.abs(log[-1, 1:7] - AIM[:6]).max() < 0.01
    assert (np.abs(torques) <= LIMITS).all() and (np.abs(torques) == LIMITS).any(axis=0).sum() >= 3
    assert np.median(log[:, 13]) < 1000
