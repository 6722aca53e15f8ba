"""A scene's functions as CUDA."""
