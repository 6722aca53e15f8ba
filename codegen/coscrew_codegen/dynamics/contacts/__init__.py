"""Contacts of bodies in steps: rows of an implicit step, the parts that bounces need, values."""
