"""From scenes to the functions of their dynamics, recorded with the library's own operations."""

from coscrew_codegen.mechanics.functions import derive

__all__ = ["derive"]
