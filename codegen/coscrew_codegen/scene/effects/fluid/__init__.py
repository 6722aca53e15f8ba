"""Effects of the fluid around bodies."""
