"""Functions of bodies and joints."""
