"""Throws a dart through a wind tunnel at a target, by the gradient of the whole flight.

The flight is a run of 500 steps; its adjoint gives the derivatives of the miss by all six initial
velocities for the price of a few runs, and SciPy's BFGS does the rest."""

import tempfile
from pathlib import Path

import numpy as np
from scipy.optimize import minimize

from coscrew_codegen import load_scene, run_adjoint

DART = """
base = "free"
runtime = ["drag.dart.area"]
[bodies]
dart = { mass = 0.03, com = [0, 0, 0], inertia = [1e-5, 4e-5, 4e-5] }
[effects.gravity]
[effects.drag.dart]
rho = 1.2
area = 0.001
point = [-0.1, 0, 0]  # the feathers: they turn the dart into the wind
"""
STEP, COUNT = 1e-3, 500
TARGET = np.array([6, 0.5, 0.2])  # m
THROW = np.array([12.0, 0, 3, 0, 0, 0])  # first guess: v in m/s, w in rad/s


def load(folder):
    (folder / "dart.toml").write_text(DART)
    return load_scene(folder / "dart.toml", functions=["default", "chart"])


def miss(kernels, throw):
    """The squared distance from the target after the flight in m², and its gradient."""
    functions = kernels.double

    def weights(k, q, v):
        away = 2 * np.array([*(q[:3] - TARGET), 0, 0, 0, 0])
        return (away @ functions.chart(q), np.zeros(6)) if k == COUNT else None

    run = run_adjoint(kernels, COUNT, weights, step=STEP, v0=throw)
    return np.sum((run.q[:3] - TARGET)**2), run.g_v


def main():
    with tempfile.TemporaryDirectory() as folder:
        kernels = load(Path(folder))
        result = minimize(lambda throw: miss(kernels, throw), THROW, jac=True, tol=1e-12)
        print(f"off by {1e3 * np.sqrt(miss(kernels, THROW)[0]):.0f} mm at first, by less than "
              f"{np.ceil(1e6 * np.sqrt(result.fun)):.0f} um after {result.nfev} flights")
        return np.sqrt(result.fun)


if __name__ == "__main__":
    main()
