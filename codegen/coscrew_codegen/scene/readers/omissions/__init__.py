"""Notices of what a scene lacks: numbers that nothing uses, idle effects, bodies that fall."""
