"""Writes scenes in fixed point: C and Python on integers."""
