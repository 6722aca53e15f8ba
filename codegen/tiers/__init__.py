"""Accuracy tiers: one function Kernel → Program each."""
