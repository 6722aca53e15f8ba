"""Measurements, and the documents made from them and from the tables."""
