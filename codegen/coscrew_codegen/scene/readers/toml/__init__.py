"""Scenes in TOML."""
