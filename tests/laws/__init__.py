"""Laws of spatial algebra, exactly; and how near the kernels come to the truth."""
