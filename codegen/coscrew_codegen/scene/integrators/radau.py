"""SciPy's Radau method of order 5."""

from coscrew_codegen.scene.integrator import Adaptive, Integrator

INTEGRATOR = Integrator("radau", 5, "SciPy's, by tolerances: reference runs of stiff motions",
                        Adaptive("Radau", implicit=True))
