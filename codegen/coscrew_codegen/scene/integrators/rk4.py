"""The classical Runge–Kutta method."""

from coscrew_codegen.scene.integrator import Integrator, tableau

INTEGRATOR = Integrator(
    "rk4", 4, "exact figures of smooth motions, fast spin; unstable where effects are stiff",
    tableau("1/2",
            "0   1/2",
            "0   0   1",
            "1/6 1/3 1/3 1/6"),
    "(q, v)' after h: one step of the classical Runge–Kutta method, of fourth order, with a of "
    "forward_dynamics at tau = 0; q moves by q ⊕ φ")
