"""What a scene is: its model, its effects with their values, its run; their checks."""
