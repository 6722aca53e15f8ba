"""Choice of the instructions of a function that are carried in pairs, for an accuracy that is asked
for."""
