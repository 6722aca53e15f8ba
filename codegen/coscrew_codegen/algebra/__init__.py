"""Defines operations in SymPy, lists them in a table, and turns them into Programs."""
