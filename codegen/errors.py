"""Errors that the command line tells in one line: what came, and what was wanted."""


class Told(Exception):
    """An error of input, of files or of the machine; no defect of the program."""
