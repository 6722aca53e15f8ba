"""The same figures from other programs: Pinocchio, MuJoCo, SciPy, KSL."""
