"""The semi-implicit Euler method: a kick, then a drift with the new velocities."""

from coscrew_codegen.scene.integrator import Composition, Drift, Integrator, Kick

INTEGRATOR = Integrator(
    "semi-implicit-euler", 1,
    "the cheapest step; for rough motions without stiff effects; rotating floating bases gain "
    "momentum",
    Composition((Kick(), Drift())),
    "v' = v + h a(t, q, v); q' = q ⊕ h v': one step of the semi-implicit Euler method, of "
    "first order, with a of forward_dynamics at tau = 0")
