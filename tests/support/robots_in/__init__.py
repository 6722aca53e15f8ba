"""Robots of packages beside the programs that read them, too."""
