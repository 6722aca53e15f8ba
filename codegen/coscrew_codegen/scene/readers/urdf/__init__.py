"""Models in URDF."""
