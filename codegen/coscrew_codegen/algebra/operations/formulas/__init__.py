"""Formulas that several families of operations share."""
