"""Splits long Programs into parts, and finds what repeats in them."""
