"""Closed loops of runs: their starts, and how far they open."""
