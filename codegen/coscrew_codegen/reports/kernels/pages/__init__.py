"""Page, Markdown and figures of a report of kernels."""
