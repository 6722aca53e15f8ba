"""A scene's costs as figures, tables and a page."""
