"""Closed loops: their closures as rows of a tree's velocities, and the multipliers of the rows."""
