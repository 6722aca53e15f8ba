"""What was emitted, held against its definition."""
