"""Fixed point: Programs of 32-bit integers, with formats and error bounds proved for a box."""
