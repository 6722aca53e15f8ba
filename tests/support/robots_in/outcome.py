"""The outcome of a file: it agrees with another program, differs, or is refused, and by whom."""

from dataclasses import dataclass

AGREES, DIFFERS, STILL, REFUSED, NOT_COMPARED = (
    "agrees", "differs", "nothing moves", "refused", "not compared")
STATUSES = (AGREES, DIFFERS, STILL, NOT_COMPARED, REFUSED)


class NotCompared(Exception):
    """The other program has no result for a file; the message is its reason."""


@dataclass(frozen=True)
class Outcome:
    """A file's status, and the figures of its reading and its comparison."""

    package: str
    file: str
    format: str
    status: str
    reason: str = ""  # the message of a refusal, or what differs
    without: tuple[str, ...] = ()  # groups of elements that were left out
    model: str = ""  # a hash of the masses and joints, by which copies are one model
    reading: float = 0.0  # processor time in s
    error: float = 0.0  # the largest difference, relative to the largest number
    velocities: int = 0
