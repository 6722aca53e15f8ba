"""Checks of a run: energy, step, rounding, what to change."""
