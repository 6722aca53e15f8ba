"""Arithmetic that is recorded: numbers whose sums and products become a Program's instructions."""
