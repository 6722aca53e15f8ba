"""Scenes by family, their motions by an integrator of high order that shares nothing with the
generator, and what coscrew says of its own motions of them."""
