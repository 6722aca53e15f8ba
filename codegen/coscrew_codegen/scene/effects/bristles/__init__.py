"""Effects with bristles, whose dry friction holds, and the ground that contacts stand on."""
