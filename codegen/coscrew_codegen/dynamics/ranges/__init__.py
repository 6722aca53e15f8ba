"""Ranges of a scene's numbers, and how far roundings can move results."""
