"""Laws of spatial algebra, exactly; and the errors of kernels."""
