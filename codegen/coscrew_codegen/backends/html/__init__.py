"""Data and plots as self-contained pages have them."""
