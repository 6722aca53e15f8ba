"""Evaluation of elementary functions: reduction of angles, polynomials, pairs."""
