"""Constant tables in C: of scenes, and of the digits of 2/π."""
