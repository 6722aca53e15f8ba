"""Tests of the command line: its files, output and errors."""
