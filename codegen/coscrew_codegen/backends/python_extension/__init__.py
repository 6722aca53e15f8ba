"""C between Python and the kernels."""
