"""The header that the C of all scenes includes, read from the generated headers;
`scene_runtime_header.py` makes it."""

import re
from collections.abc import Iterable
from functools import cache

from coscrew_codegen.backends.render import generated

PATH = "c/coscrew_runtime.h"
"""Its place among generated headers."""
NAME = PATH.rpartition("/")[2]
_FINGERPRINT = re.compile(r"^#define COSCREW_RUNTIME (0x[0-9a-f]{8})$", re.MULTILINE)
_ERROR = re.compile(r"\bksl_product_(error|rest)f?\(|\bksl_\w+_error(_[0-9]+)?f?\(")


def files() -> dict[str, str]:
    """The header, by its path."""
    return {NAME: generated(PATH)}


@cache
def fingerprint() -> str:
    """The number by which the header and the files that include it know each other."""
    (number,) = _FINGERPRINT.findall(generated(PATH))
    return str(number)


def with_errors(bodies: Iterable[str]) -> bool:
    """Returns whether these texts call functions that are there for the accurate tiers alone."""
    return any(map(_ERROR.search, bodies))
