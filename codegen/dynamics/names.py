"""What a mistyped name was meant to be."""

from collections.abc import Iterable
from difflib import get_close_matches


def did_you_mean(name: str, known: Iterable[str]) -> str:
    """"did you mean 'elbow'?": the nearest of the known names; "" where there is none."""
    names = sorted(known)
    lowered = {}
    for other in reversed(names):
        lowered[other.lower()] = other
    near = get_close_matches(name[:100].lower(), sorted(lowered), n=1, cutoff=0.0)
    return f"did you mean {lowered[near[0]]!r}?" if near else ""
