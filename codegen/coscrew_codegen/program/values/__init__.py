"""Numbers and arguments: quantities, formats, parameters, digits."""
