"""What was emitted, held against its definition; by folder, what a test is about."""
