"""Up to where promises of accuracy hold, as docs/accuracy.md states."""

LARGEST_CONDITION = {"double": 1e13, "single": 1e5}
"""Of a component: below it the accurate tier is within one unit of the last digit in double
precision, and gives the nearest number, except near ties, in single precision."""
LARGEST_ANGLE = {"double": 1e13, "single": 1e5}
"""Of rotation vectors, in rad: up to it bounds are stated."""
