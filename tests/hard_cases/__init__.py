"""Inputs whose errors come closest to their bounds, and what finds them."""
