"""Makes the header that the C of all scenes includes: guards of flags, products that are rounded
once, elementary functions.

It depends on no scene, so that a program vendors it once, and it is generated once: files of scenes
bring a copy.  A fingerprint of its text stands in it and in the files that include it: those of
another version refuse to compile.
"""

import re
from collections.abc import Collection
from hashlib import sha256

from coscrew_codegen.backends.c import c_elementary
from coscrew_codegen.backends.c.c_lanes import SEVERAL
from coscrew_codegen.backends.library import Library
from coscrew_codegen.backends.render import render
from coscrew_codegen.backends.scene.scene_c_runtime import PATH
from coscrew_codegen.backends.target import Files, Target
from coscrew_codegen.program.elementary import ELEMENTARY, ERRORS, Elementary
from coscrew_codegen.program.values.formats import DOUBLE, PRECISIONS, Precision

BANNER = ("Made by `coscrew generate SCENE`, the same for every scene; "
          "changes are overwritten.")
_NO_FINGERPRINT = "0x00000000"
_COMMENT = re.compile(r"/\*.*?\*/", re.DOTALL)


def files(library: Library) -> Files:
    """c/coscrew_runtime.h, with the whole library."""
    return {PATH: text()} if library.whole else {}


def text() -> str:
    """The header."""
    made = _without_fingerprint()
    return made.replace(_NO_FINGERPRINT, fingerprint_of(made))


def fingerprint_of(text: str) -> str:
    """The code of this text as a number: 32 bits of a hash of its words, without comments."""
    words = " ".join(_COMMENT.sub(" ", text).split())
    return f"0x{sha256(words.encode()).hexdigest()[:8]}"


def _without_fingerprint() -> str:
    return render("scene/runtime.h", banner=BANNER, fingerprint=_NO_FINGERPRINT,
                  products=PRECISIONS,
                  sections=[{"precision": p, "condition": "DBL_MANT_DIG == 53" * (p == DOUBLE),
                             "functions": _written(p, ELEMENTARY),
                             "exact": [f"ksl_product_{x}{p.suffix}" for x in ("error", "rest")],
                             "errors": _written(p, ERRORS)} for p in PRECISIONS])


def _written(precision: Precision, functions: Collection[Elementary]
             ) -> list[c_elementary.ElementaryText]:
    """Returns the definitions of these functions, for one and for several arguments."""
    names = {x.name for x in functions}
    alone = {name for name, of in c_elementary.ALONE.items() if of in names}
    several = {x for name in names for x in SEVERAL.get(name, ())}
    return c_elementary.written(precision, names | alone | several, nested=True)


TARGET = Target("header of scenes in C", ("c",), library=files)
