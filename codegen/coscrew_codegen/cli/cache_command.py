"""`coscrew cache`: shows the cache of scenes and of the library, or empties it."""

import argparse
import sys

from coscrew_codegen.runtime import cache


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add `cache` to the command line."""
    parser = commands.add_parser(
        "cache", help="show or empty the cache of scenes and of the library",
        description="Show the cache of scenes that were derived and compiled, and of families of "
        "operations that were derived: folder, entries, bytes, limit.  The limit is "
        f"${cache.LIMIT}, {cache.DEFAULT_LIMIT} if that is not set; when it is exceeded, the least "
        "recently used entries are removed.")
    parser.add_argument("--clear", action="store_true", help="empty the cache")
    parser.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Show or empty the cache; returns the exit status."""
    most = cache.limit()
    if options.clear:
        gone = cache.evict(-1)
        print(f"{len(gone)} entries, {shown(sum(x.size for x in gone))}, are gone")
        if left := len(cache.entries()):
            print(f"coscrew: {left} entries of {cache.wanted_folder()} cannot be removed",
                  file=sys.stderr)
        return 1 if left else 0
    entries = cache.entries()
    print(f"folder   {cache.wanted_folder()}\n"
          f"entries  {len(entries)}\n"
          f"size     {shown(sum(x.size for x in entries))}\n"
          f"limit    {shown(most)} (${cache.LIMIT})")
    return 0


def shown(size: int) -> str:
    """A number of bytes as text: 12.3 MB."""
    for unit, factor in (("GB", 10**9), ("MB", 10**6), ("KB", 10**3)):
        if size >= factor:
            return f"{size / factor:.3g} {unit}"
    return f"{size} bytes"
