"""Figures, tables and a page of a scene's costs."""
