"""Functions of given points of bodies."""
