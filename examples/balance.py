"""Balances a double pendulum on a cart by a linear-quadratic regulator, from a step's derivatives.

The model of the regulator is exactly the step that the run takes, A and B by the state and by the
force on the cart; SciPy solves the Riccati equation."""

import tempfile
from pathlib import Path

import numpy as np
from scipy.linalg import solve_discrete_are

from coscrew_codegen import load_scene

CART = """
[bodies]
cart = { mass = 1 }
lower = { mass = 0.1, com = [0, 0, 0.25], inertia = [0.002, 0.002, 1e-5] }
upper = { mass = 0.1, com = [0, 0, 0.25], inertia = [0.002, 0.002, 1e-5] }
[joints]
rail = { type = "prismatic", child = "cart", axis = [1, 0, 0], damping = 0.1 }
hip = { type = "revolute", parent = "cart", child = "lower", axis = [0, 1, 0] }
knee = { type = "revolute", parent = "lower", child = "upper", axis = [0, 1, 0], \
origin = { xyz = [0, 0, 0.5] } }
[effects.gravity]
[effects.viscous]
d = { rail = "model" }
"""
STEP, COUNT, MOST = 1e-3, 6000, 30.0  # s, steps, N


def load(folder):
    (folder / "cart.toml").write_text(CART)
    return load_scene(folder / "cart.toml", functions=[
        "default", "step_leapfrog_tau", "step_leapfrog_tau_derivatives"]).double


def gains(functions):
    """K of the feedback -K (q, v) that minimises Σ |q|² + |v|² / 10 + force² / 100."""
    still = np.zeros(3)
    _, _, A, B = functions.step_leapfrog_tau_derivatives(STEP, still, still, still)
    B = B[:, :1]  # the cart's force
    P = solve_discrete_are(A, B, np.diag([1, 1, 1, 0.1, 0.1, 0.1]), np.array([[0.01]]))
    return np.linalg.solve(0.01 + B.T @ P @ B, B.T @ P @ A)[0]


def balanced(functions, q):
    """q and v after COUNT steps under feedback, from rest."""
    K, v = gains(functions), np.zeros(3)
    for _ in range(COUNT):
        force = np.clip(-K @ np.concatenate((q, v)), -MOST, MOST)
        q, v = functions.step_leapfrog_tau(STEP, q, v, np.array([force, 0, 0]))
    return q, v


def main():
    with tempfile.TemporaryDirectory() as folder:
        functions = load(Path(folder))
        q, v = balanced(functions, np.array([0.0, 0.15, -0.1]))
        print(f"after {STEP * COUNT:g} s it stands within {np.abs(q).max():.0e} of upright")
        return q, v


if __name__ == "__main__":
    main()
