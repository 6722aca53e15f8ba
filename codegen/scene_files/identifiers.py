"""Names of scenes: they begin the names of C functions and are Python packages."""

import keyword
import re

_C = """alignas alignof asm atomic auto bool break case catch char class compl concept const
consteval constexpr constinit continue decltype default delete do double dynamic_cast else
enum explicit export extern false float for friend goto if inline int long main mutable
namespace new noexcept nullptr operator private protected public register requires restrict
return short signed sizeof static struct switch template this thread_local throw true try
typedef typeid typename typeof union unsigned using virtual void volatile wchar_t while""".split()
_PACKAGES = ("coscrew", "coscrew_codegen", "numpy", "scipy")  # that scenes' own packages import
_TAKEN = frozenset((*_C, *_PACKAGES, *keyword.kwlist, *keyword.softkwlist))
_LONGEST = 40


def refused(name: str) -> str | None:
    """Why a name will not do; None if it will."""
    if not re.fullmatch(r"[A-Za-z][A-Za-z0-9_]*", name):
        return "is no identifier: a letter, then letters, digits and _"
    if len(name) > _LONGEST:
        return f"is longer than {_LONGEST} characters"
    return "is a word of C or Python, or a package" if name in _TAKEN else None


def identifier(stem: str) -> str:
    """A file's stem, or another text, made an identifier: "6-joint arm" gives scene_6_joint_arm."""
    name = re.sub(r"[^A-Za-z0-9]+", "_", stem).strip("_")[:_LONGEST - len("scene_")]
    return name if name and refused(name) is None else f"scene_{name}".rstrip("_")
