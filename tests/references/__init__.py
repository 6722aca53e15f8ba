"""Reference figures of motions, computed without any of the generator's code.

Each module here computes one motion to 50 digits, in closed form or as a Taylor series; or, where
its docstring says so, with SciPy's DOP853 at tolerances of 1e-13, from equations written by hand or
from Pinocchio's dynamics.

`python -m tests.references.pendulum` prints tests/references/pendulum.csv.
"""
