"""Proofs of the errors of elementary functions, and their coefficients."""
