"""Radau's method of order 5, of SciPy."""

from coscrew_codegen.integrator import Adaptive, Integrator

INTEGRATOR = Integrator("radau", 5, "SciPy's, by tolerances: reference runs of stiff motions",
                        Adaptive("Radau", implicit=True))
