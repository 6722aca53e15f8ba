"""Scenes that tests share, and functions that run them."""
