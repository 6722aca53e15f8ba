"""Contacts of bodies: their law, the parts of bodies that touch, heights of the ground."""
