"""Accuracy tiers, bounds of errors, and the choice of precisions."""
