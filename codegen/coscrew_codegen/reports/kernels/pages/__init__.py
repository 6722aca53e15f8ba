"""A report of kernels as a page, Markdown and figures."""
