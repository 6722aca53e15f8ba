"""Effects that exert forces on bodies, or move fluid with them."""
