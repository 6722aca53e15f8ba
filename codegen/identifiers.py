"""Names of joints and bodies as identifiers of C and Python."""

import re
from collections.abc import Sequence


def identifiers(names: Sequence[str]) -> tuple[str, ...]:
    """One identifier per name, in order, all different; other characters become underscores.

    No identifier is another one followed by f: in C that suffix means single precision."""
    found: dict[str, None] = {}
    for name in names:
        stem = re.sub(r"_{2,}", "_", re.sub(r"[^A-Za-z0-9_]", "_", name)).strip("_") or "x"
        stem = f"x{stem}" if stem[0].isdigit() else stem
        identifier, count = stem, 1
        while {identifier, f"{identifier}f"} & found.keys() or (
                identifier.endswith("f") and identifier[:-1] in found):
            count += 1
            identifier = f"{stem}_{count}"
        found[identifier] = None
    return tuple(found)
