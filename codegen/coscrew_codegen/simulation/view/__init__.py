"""Pages that play runs back in 3D."""
