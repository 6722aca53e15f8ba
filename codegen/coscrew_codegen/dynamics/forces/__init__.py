"""Effects acting on a motion: forces, potentials, derivatives of both."""
