"""Scenes: the model, effects with their parameters, the run; and their checks."""
