"""Emitted C: compiled, called, read."""
