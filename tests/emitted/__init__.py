"""Tests of emitted text: its meaning, its bits under every compiler and flag, its calls."""
