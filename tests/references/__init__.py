"""Reference figures of motions, computed without any of the generator's code.

Each module here computes one motion: in closed form or as a Taylor series to 50 digits, or, where
stated, by SciPy's DOP853 with tolerances of 1e-13, from equations written by hand or with
Pinocchio's dynamics.  `python -m tests.references.pendulum` prints tests/references/pendulum.csv.
"""
