"""Tables of scene files that say more of the model and of its functions: loops, ranges, accuracy."""
