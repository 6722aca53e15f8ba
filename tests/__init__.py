"""Tests that compare emitted functions with their definitions, in folders by subject."""
