"""Ranges of a scene's numbers, and bounds of rounding errors for all states."""
