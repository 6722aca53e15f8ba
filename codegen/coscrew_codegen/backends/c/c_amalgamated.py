"""All C headers of a tier in one file: c/coscrew.h and, if selected, c/coscrew_accurate.h, …"""

from functools import cache

from coscrew_codegen.accuracy.tiers import PLAIN, Tier
from coscrew_codegen.backends.c.c_elementary import HEADER
from coscrew_codegen.backends.c.c_headers import headers, umbrellas
from coscrew_codegen.backends.library import Library
from coscrew_codegen.backends.render import LICENSE, render
from coscrew_codegen.backends.target import Files, Target

_SHARED = ("ksl_rounding", "ksl_types")  # plain headers that every tier needs


def files(library: Library) -> Files:
    """The plain tier's file, and those of the tiers that are selected."""
    return {f"c/{file_name(tier)}": text(library, tier) for tier in (PLAIN, *library.amalgamated)}


def file_name(tier: Tier) -> str:
    """coscrew.h, coscrew_accurate.h."""
    return "_".join(filter(None, ("coscrew", tier.mark))) + ".h"


@cache  # also used by the extension target
def text(library: Library, tier: Tier) -> str:
    """The headers of a tier in one text, without their includes of each other."""
    plain = headers(library, PLAIN)
    own = headers(library, tier)
    called = any(f'#include "{HEADER}.h"' in content for content in own.values())
    shared = (*_SHARED, *([HEADER] if called else []))
    made = {name: plain[name] for name in shared} | dict(own)
    head = 1 + len(LICENSE)
    sections = ["\n".join(line for line in content.splitlines()[head:]
                          if not line.startswith('#include "')) + "\n"
                for name, content in made.items() if name not in umbrellas()]
    banner = library.banner_with(f"--amalgamate {tier.name}") if tier.marked else library.banner
    return render("c/coscrew.h", banner=banner, sections=sections,
                  title=f"All headers of {tier.name} kernels")


TARGET = Target("amalgamated C headers", ("c",), library=files)
