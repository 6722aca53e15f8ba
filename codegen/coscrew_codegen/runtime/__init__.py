"""Timing of native code and Python calls; the cache of compiled and derived files."""
