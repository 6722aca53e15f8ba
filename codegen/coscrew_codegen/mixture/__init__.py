"""Which instructions of a function are carried in pairs for an accuracy that is asked for."""
