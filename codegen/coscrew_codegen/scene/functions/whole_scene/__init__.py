"""Functions of the whole scene, and of its effects."""
