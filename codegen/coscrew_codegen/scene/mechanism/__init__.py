"""Bodies and joints: the model, its tree, its inertias, and their checks."""
