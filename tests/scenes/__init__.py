"""Scenes: their files, effects, functions and motions."""
