"""Errors that the command line prints as one line: what came, and what was wanted."""


class ReportedError(Exception):
    """An error in the input, in files or of the machine: not a defect of the program."""
