"""Exact results, or to many digits, and the errors that are allowed."""
