"""The commands: one module each, and the line that chooses among them."""
