"""The linearly implicit Euler method: damping and stiffness act at the step's end."""

from coscrew_codegen.scene.integrator import Composition, Drift, Integrator, Kick

INTEGRATOR = Integrator(
    "linear-implicit-euler", 1,
    "never unstable by damping or stiffness, but does not resolve bounces (what falls on a stiff "
    "limit stays there) and vibrations; rotating floating bases gain momentum",
    Composition((Kick("implicit_acceleration"), Drift()), damps_bounces=True),
    "v' = v + h a(t, q, v); q' = q ⊕ h v': one step of the linearly implicit Euler method, of "
    "first order, with a from dynamics in which damping and stiffness of joints act at the "
    "step's end")
