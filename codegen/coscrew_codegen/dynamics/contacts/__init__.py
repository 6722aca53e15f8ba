"""Contacts of bodies in steps: the parts that bounces need, values."""
