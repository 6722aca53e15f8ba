"""Shapes of the generated files: loops and holes, no arithmetic, no type logic."""
