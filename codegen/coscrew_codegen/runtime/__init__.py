"""Compiles, caches and loads: from Programs to functions that Python calls."""
