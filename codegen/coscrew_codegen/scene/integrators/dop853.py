"""SciPy's DOP853: Dormand and Prince's method of order 8."""

from coscrew_codegen.scene.integrator import Adaptive, Integrator

INTEGRATOR = Integrator("dop853", 8, "SciPy's, by tolerances: reference runs of smooth motions",
                        Adaptive("DOP853"))
