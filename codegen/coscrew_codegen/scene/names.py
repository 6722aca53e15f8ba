"""Reads lists of names, and finds the known name that a mistyped one resembles."""

import json
import re
from collections.abc import Iterable, Mapping, Set

from coscrew_codegen.scene.joints import KINDS

LIKE = 0.55  # difflib's ratio from which names are similar: omega is not max, nor half both (0.5)
MANY = 20  # names that a message can still list
_SHORT = 3  # letters below which being contained in a name is no similarity: "d" in "heaviside"

_SYNONYMS = tuple((kind.name, *kind.synonyms) for kind in KINDS)
"""Other tools' words for the same joint."""


def listed(argument: str, given: object, example: str, error: type[Exception] = TypeError
           ) -> tuple[str, ...]:
    """Returns the names in a list; raises `error` for anything else, also for a single text, as
    "energy" for ["energy"], and for a collection without order, as a set."""
    names = None if isinstance(given, str | Set | Mapping) or not isinstance(given, Iterable) \
        else tuple(given)
    if names is None or not all(isinstance(name, str) for name in names):
        raise error(f'{argument}: wanted a list of names, as ["{example}"]; got {given!r}')
    return names


def nearest(name: str, known: Iterable[str]) -> str | None:
    """The most similar known name: a synonym, one that contains it or is contained in it, or one
    with nearly the same letters in either case; None if there is none."""
    names, low = sorted(known), name[:100].lower()
    same = {word for words in _SYNONYMS if low in words for word in words}
    best = max(names, key=lambda other: (other.lower() in same, _likeness(low, other.lower())),
               default=None)
    if best is None or best.lower() not in same and _likeness(low, best.lower()) < LIKE:
        return None
    return best


def _likeness(a: str, b: str) -> float:
    """Similarity from 0 to 1; at least LIKE if one name contains the other."""
    from difflib import SequenceMatcher

    ratio = SequenceMatcher(None, a, b).ratio()
    held = min(len(a), len(b)) >= _SHORT and (a in b or b in a)
    return (1 + ratio) / 2 if held else ratio


def did_you_mean(name: str, known: Iterable[str]) -> str:
    """"did you mean 'elbow'?"; if no known name is similar, the known names, unless there are too
    many to list."""
    names = sorted(known)
    near = nearest(name, names)
    if near is not None:
        return f"did you mean {near!r}?"
    if not names:
        return "there are none"
    if len(names) > MANY:
        return f"none of the {len(names)} there are is like it"
    return f"wanted {'one of ' if len(names) > 1 else ''}{', '.join(names)}"


def toml_key(name: str) -> str:
    """The name as a key in TOML, in quotation marks if it needs them."""
    return name if re.fullmatch(r"[A-Za-z0-9_-]+", name) else json.dumps(name, ensure_ascii=False)


def or_mean(name: str, known: Iterable[str]) -> str:
    """"; did you mean 'elbow'?" for the end of a message that lists the known names; "" if none is
    similar."""
    near = nearest(name, known)
    return f"; did you mean {near!r}?" if near is not None else ""
