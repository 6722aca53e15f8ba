"""Effects that exert torques and forces at joints."""
