"""Precision tuning: chooses the instructions of a function that are carried in pairs, for a
requested accuracy."""
