"""Comparisons with other programs: Pinocchio, MuJoCo, SciPy, KSL."""
