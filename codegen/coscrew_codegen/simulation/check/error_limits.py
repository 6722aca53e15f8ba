"""Allowed errors of runs, relative to the sizes of the parts in error."""

ALLOWED = 0.025
"""Largest error of a part relative to its size: halfway, in logarithms, from 1 %, which is right
for most uses, to 5 %, which is not."""
STRICTLY = 1e-3
"""Largest error of a part with --strict."""
AGREED = 0.2
"""Fraction of the allowed error by which two motions with small steps may differ and still agree.
"""
ENERGY = 1e-3
"""Largest defect of energy with the smallest steps, relative to the energies moved: beyond it, the
power of an effect is not that of its force."""
KEPT = 0.05
"""Largest change of an energy that should be constant, relative to the largest kinetic energy; and
largest error of momentum, relative to the largest velocities."""
FROZEN = 0.05
"""Largest part of a coordinate's way that may be lost to rounding."""
