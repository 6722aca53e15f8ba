"""Identifiers of C and Python for joints, bodies and scenes.

A scene's name is that of its header and its package, and begins the names of its functions in C."""

import keyword
import re
import sys
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


_C = """alignas alignof asm atomic auto bool break case catch char class compl concept const
consteval constexpr constinit continue decltype default delete do double dynamic_cast else
enum explicit export extern false float for friend goto if inline int long main mutable
namespace new noexcept nullptr operator private protected public register requires restrict
return short signed sizeof static struct switch template this thread_local throw true try
typedef typeid typename typeof union unsigned using virtual void volatile wchar_t while""".split()
_PACKAGES = ("coscrew", "coscrew_codegen", "numpy", "scipy")  # that scenes' own packages import
_HEADERS = frozenset("""assert complex ctype errno fenv float inttypes iso646 limits locale math
setjmp signal stdalign stdarg stdatomic stdbit stdbool stdckdint stddef stdint stdio stdlib
stdmchar stdnoreturn string tgmath threads time uchar wchar wctype alloca dirent dlfcn elf
endian fcntl features getopt glob grp libgen libintl libio link malloc memory monetary netdb
nl_types poll pthread pwd regex sched semaphore spawn stdc_predef strings syscall syslog termios
ucontext unistd utime wait values xlocale availabilitymacros corecrt crtdefs intrin io process
sal vadefs vcruntime windows""".split())
"""Headers of C and of systems: with a scene's folder on the include path, a scene's math.h would
replace <math.h>.  In lower case: on some systems Math.h is the same file."""
_ONCE = frozenset("""annotationlib asynchat asyncore audioop binhex cgi cgitb chunk compression
crypt distutils formatter imghdr imp lib2to3 mailcap msilib nis nntplib ossaudiodev parser pipes
smtpd sndhdr spwd string sunau symbol telnetlib uu xdrlib""".split())
"""Modules of some versions of Python only; refused with all, so that a name is valid with all."""
_TAKEN = frozenset((*_C, *_PACKAGES, *keyword.kwlist, *keyword.softkwlist, *_ONCE,
                    *sys.stdlib_module_names))
_LONGEST = 40


def refused(name: str) -> str | None:
    """Why the name of a scene is refused; None if it is valid."""
    if not re.fullmatch(r"[A-Za-z][A-Za-z0-9_]*", name):
        return "is no identifier: a letter, then letters, digits and _"
    if len(name) > _LONGEST:
        return f"is longer than {_LONGEST} characters"
    if name in _TAKEN or name.lower() in _HEADERS:
        return "is a word of C or Python, or one of their headers or modules"
    if re.match("(ksl|coscrew)(_|$)", name.lower()):
        return "begins as the names of the library's headers and macros do"
    return None


def scene_identifier(stem: str) -> str:
    """A text turned into a valid name of a scene: "6-joint arm" gives scene_6_joint_arm."""
    name = re.sub(r"[^A-Za-z0-9]+", "_", stem).strip("_")[:_LONGEST - len("scene_")]
    return name if name and refused(name) is None else f"scene_{name}".rstrip("_")
