"""Notices about gaps of a scene: numbers without use, idle effects, bodies that fall."""
