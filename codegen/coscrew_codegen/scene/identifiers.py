"""Names of joints and bodies as identifiers of C and Python."""

import re
from collections import Counter
from collections.abc import Sequence
from itertools import count


def identifiers(names: Sequence[str]) -> tuple[str, ...]:
    """One identifier per name, in order, all different; other characters become underscores.

    No identifier is another one followed by f: in C that suffix means single precision."""
    result: dict[str, None] = {}
    for name in names:
        stem = _stem(name)
        identifier, number = stem, 1
        while {identifier, f"{identifier}f"} & result.keys() or (
                identifier.endswith("f") and identifier[:-1] in result):
            number += 1
            identifier = f"{stem}_{number}"
        result[identifier] = None
    return tuple(result)


def numbered(names: Sequence[str]) -> tuple[str, ...]:
    """One identifier in capitals per name, in order, all different: Elbow is ELBOW. Names with the
    same identifier are all numbered, in their order: Hip and hip are HIP_1 and HIP_2."""
    stems = [capitals(name) for name in names]
    counts = Counter(stems)
    taken = {stem for stem, n in counts.items() if n == 1}
    numbers = {stem: count(1) for stem in counts}
    results = []
    for stem in stems:
        if counts[stem] > 1:
            stem = next(x for n in numbers[stem] if (x := f"{stem}_{n}") not in taken)
            taken.add(stem)
        results.append(stem)
    return tuple(results)


def capitals(name: str) -> str:
    """The name as an identifier in capitals."""
    return _stem(name.upper()).upper()


def _stem(name: str) -> str:
    """The name with underscores for other characters; x if nothing is left of it."""
    stem = re.sub(r"_{2,}", "_", re.sub(r"[^A-Za-z0-9_]", "_", name)).strip("_") or "x"
    return f"x{stem}" if stem[0].isdigit() else stem
