"""Controllers made of a step's derivatives hold what they promise."""

import importlib.util
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

ROOT = Path(__file__).parents[2]


def example(name: str) -> ModuleType:
    spec = importlib.util.spec_from_file_location(name, ROOT / f"examples/{name}.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


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
