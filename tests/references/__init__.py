"""Reference figures of motions, computed without any of the generator's code.

Each module here computes one motion: in closed form, as a Taylor series or with mpmath to 50 digits
where it says so, else by SciPy's DOP853 to tolerances of 1e-13 from equations written by hand, or with
Pinocchio's dynamics.  `python -m tests.references.pendulum` prints tests/references/pendulum.csv.
"""
