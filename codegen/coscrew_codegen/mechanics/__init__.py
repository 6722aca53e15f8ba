"""Derives the functions of a scene's dynamics by calling the library's operations."""

from coscrew_codegen.mechanics.functions import derive

__all__ = ["derive"]
