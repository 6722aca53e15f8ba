"""`coscrew`, and `python -m coscrew_codegen`: how every command begins and ends.

The command is imported inside the block that catches an interrupt, since importing takes most of a
second, and only after the packages that it needs have been signals; help needs none of them."""

import gc
import os
import signal
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from io import UnsupportedOperation

from coscrew_codegen.runtime.console import any_encoding
from coscrew_codegen.runtime.extras import COMMANDS, lacking

RARELY = 100_000
"""New objects between two searches for cycles: modules and scenes are many objects with hardly any
cycle, and Python's 700 cost a twentieth of a command's time."""

INTERRUPTED, CLOSED, TERMINATED = 130, 141, 143
"""Exit statuses of programs ended by SIGINT, SIGPIPE and SIGTERM, as shells report them."""


def main(arguments: list[str] | None = None) -> int:
    """Run the command line; returns the exit status: the command's, or 2 for an error, 130 for an
    interrupt, 143 for SIGTERM, which ends commands as an interrupt does: they keep their results so
    far, and say so; 141 if the reader of standard output closes it early, as `head` does."""
    with _terminable() as signals:
        status = _ended(arguments)
    return TERMINATED if signals and status == INTERRUPTED else status


@contextmanager
def _terminable() -> Iterator[list[int]]:
    """While the block runs, SIGTERM raises KeyboardInterrupt; yields the list of such signals."""
    signals: list[int] = []

    def interrupt(number: int, _: object) -> None:
        signals.append(number)
        raise KeyboardInterrupt

    main_thread = threading.current_thread() is threading.main_thread()
    if not main_thread or signal.getsignal(signal.SIGTERM) is not signal.SIG_DFL:
        yield signals  # whoever handles it decides
        return
    signal.signal(signal.SIGTERM, interrupt)
    try:
        yield signals
    finally:
        signal.signal(signal.SIGTERM, signal.SIG_DFL)


def _ended(arguments: list[str] | None) -> int:
    gc.set_threshold(RARELY)
    words = sys.argv[1:] if arguments is None else arguments
    any_encoding(sys.stdout)
    any_encoding(sys.stderr)
    try:
        try:
            return _run(words)
        finally:
            sys.stdout.flush()
    except KeyboardInterrupt:
        print("coscrew: interrupted", file=sys.stderr)
        return INTERRUPTED
    except BrokenPipeError:
        _give_up_output()
        return CLOSED
    except OSError as error:
        where = f"{error.filename}" if error.filename else "cannot write"  # standard output
        print(f"coscrew: {where}: {error.strerror or error}", file=sys.stderr)
        _give_up_output()
        return 2


def _give_up_output() -> None:
    """Redirect standard output to null: Python would try to write the rest when it exits."""
    with suppress(UnsupportedOperation):  # standard output may have been replaced by no real file
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _run(words: list[str]) -> int:
    if words[:1] == ["--version"]:
        from coscrew_codegen.backends.version import VERSION

        print(f"coscrew {VERSION}")
        return 0
    command = words[0] if words and words[0] in COMMANDS else ""
    sentence = lacking(command, COMMANDS[command]) if command else None
    if sentence and not {"-h", "--help"} & set(words):
        print(f"coscrew: {sentence}", file=sys.stderr)
        return 2
    from coscrew_codegen.cli.command_line import run

    return run(words)


if __name__ == "__main__":
    sys.exit(main())
