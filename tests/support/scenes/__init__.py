"""Scenes that tests share, and what runs them."""
