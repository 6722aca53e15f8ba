"""Records arithmetic: sums and products of its numbers become a Program's instructions."""
