"""Accuracy that suffices: requests, and the cheapest tier and precision that meets each."""
