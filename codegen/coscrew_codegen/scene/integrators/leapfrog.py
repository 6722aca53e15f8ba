"""Drift, kick, drift: the default."""

from fractions import Fraction

from coscrew_codegen.scene.integrator import Composition, Drift, Integrator, Kick

INTEGRATOR = Integrator(
    "leapfrog", 2,
    "the default: keeps energy, and the momentum of floating bases; any dampers, stiff motors, "
    "limits that bounce",
    Composition((Drift(Fraction(1, 2)), Kick("midpoint_acceleration"), Drift(Fraction(1, 2))),
                splits=True, keeps_momentum=True, moves_states=True),
    "q_m = q ⊕ h/2 v; v' = v + h a(t + h/2, q_m, (v + v')/2); q' = q_m ⊕ h/2 v': drift, kick, "
    "drift, the kick in two passes, implicit in damping and stiffness of the effects; of "
    "second order.  Steps in which limits close are split, floating bases keep their "
    "momentum")
