"""The truth in SymPy, the table of operations, and the way from both to Programs."""
