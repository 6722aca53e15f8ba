"""Parses options that take names: --functions a b, --functions a,b, or repeated."""

import argparse
import re
from collections.abc import Sequence

_COMMA = re.compile(r",(?![^\[\]]*\])")  # not within [a,b] of a pattern


class Names(argparse.Action):
    """Adds the names of each word, between commas, to those given before."""

    def __call__(self, parser: argparse.ArgumentParser, namespace: argparse.Namespace,
                 values: str | Sequence[object] | None, option_string: str | None = None) -> None:
        """Called by argparse.  Raises ArgumentError for an empty name."""
        words = [values] if isinstance(values, str) else list(values or ())
        names = [name.strip() for word in words for name in _COMMA.split(str(word))]
        if not all(names):
            raise argparse.ArgumentError(self, f"an empty name in {' '.join(map(str, words))!r}; "
                                               "wanted names, as a b, or a,b")
        before = getattr(namespace, self.dest)
        setattr(namespace, self.dest, [*(before if before is not self.default else ()), *names])
