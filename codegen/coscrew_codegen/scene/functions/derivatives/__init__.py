"""Derivatives of the other functions: families with a member for each of them."""
