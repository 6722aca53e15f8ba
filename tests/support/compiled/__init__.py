"""Compiles, calls and parses emitted C."""
