"""Times of loops, and medians with their confidence intervals."""
