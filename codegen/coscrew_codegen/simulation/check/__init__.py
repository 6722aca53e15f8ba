"""Checks of a run: energy, step, rounding, and advice."""
