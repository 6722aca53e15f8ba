"""The Python packages: kernels and scenes in pure NumPy."""
