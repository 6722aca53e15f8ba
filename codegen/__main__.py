"""`coscrew`, and `python -m coscrew_codegen`: how every command ends.

Imports what it runs only while it can tell an interrupt: that takes most of a second."""

import os
import sys

INTERRUPTED, CLOSED = 130, 141
"""What shells say of programs that SIGINT and SIGPIPE end."""


def main(arguments: list[str] | None = None) -> int:
    """Run the command line; returns the exit status: the command's, or 2 for an error, 130 for an
    interrupt, 141 where who reads standard output stops doing so, as `head` does."""
    try:
        try:
            from coscrew_codegen.command_line import run

            return run(arguments)
        finally:
            sys.stdout.flush()
    except KeyboardInterrupt:
        print("coscrew: interrupted", file=sys.stderr)
        return INTERRUPTED
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())  # or else Python flushes
        return CLOSED


if __name__ == "__main__":
    sys.exit(main())
