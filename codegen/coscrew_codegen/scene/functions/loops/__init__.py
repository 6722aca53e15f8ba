"""Functions of closed loops."""
