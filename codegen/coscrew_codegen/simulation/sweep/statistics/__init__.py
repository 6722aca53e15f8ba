"""Distributions over the members of a sweep, as tables and figures."""
