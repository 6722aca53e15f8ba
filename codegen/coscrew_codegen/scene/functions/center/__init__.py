"""Functions of the centre of mass and of the momentum about it."""
