"""What a scene is: its model, its effects with their parameters, its run; their checks."""
