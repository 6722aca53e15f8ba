"""Targets that follow the points of tables."""
