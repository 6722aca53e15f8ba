"""A scene's functions as C, and text that all languages share."""
