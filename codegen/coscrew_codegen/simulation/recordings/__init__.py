"""Recorded quantities: computed, written, read, plotted, played back."""
