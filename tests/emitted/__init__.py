"""What is emitted: its meaning, its bits under every compiler and flag, its calls."""
