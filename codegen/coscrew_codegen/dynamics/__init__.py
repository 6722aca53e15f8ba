"""Derives the functions of a scene's dynamics by calling the library's operations."""

from coscrew_codegen.dynamics.derive_functions import derive

__all__ = ["derive"]
