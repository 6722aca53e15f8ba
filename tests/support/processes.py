"""Programs that tests interrupt."""

import signal
import subprocess
from collections.abc import Iterator, Sequence
from contextlib import contextmanager


@contextmanager
def interruptible(words: Sequence[object], stdout: int | None = None, stderr: int | None = None,
                  group: bool = False) -> Iterator[subprocess.Popen[str]]:
    """The running program.  It reacts to SIGINT even if the tests run in the background and ignore
    it, and is ended with the test; with `group` it leads a group of processes, as in a terminal."""
    process = subprocess.Popen([str(x) for x in words], text=True, preexec_fn=_heed, stdout=stdout,
                               stderr=stderr, start_new_session=group)
    try:
        yield process
    finally:
        process.kill()
        process.wait()


def _heed() -> None:
    signal.signal(signal.SIGINT, signal.SIG_DFL)
