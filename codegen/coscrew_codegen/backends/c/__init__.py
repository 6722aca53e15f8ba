"""C headers of the library, and the printers that all C shares."""
