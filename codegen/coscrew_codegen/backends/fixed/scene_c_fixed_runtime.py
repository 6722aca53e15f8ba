"""The header that the fixed tier of all scenes includes: products and shifts of integers, sine and
cosine."""

import re
from functools import cache
from hashlib import sha256

from coscrew_codegen.backends.fixed import c_integers
from coscrew_codegen.backends.render import render
from coscrew_codegen.program.fixed import fixed_sine
from coscrew_codegen.program.fixed.fixed_value import OF_ANGLES
from coscrew_codegen.program.values.digits import two_digits_up

NAME = "coscrew_fixed.h"
_BANNER = ("Made by `coscrew generate SCENE` in the fixed tier, the same for every scene; "
           "changes are overwritten.")
_COMMENT = re.compile(r"/\*.*?\*/", re.DOTALL)


def files() -> dict[str, str]:
    """The header, by its path."""
    return {NAME: _text(fingerprint())}


@cache
def fingerprint() -> str:
    """The header's code as a number: 32 bits of a hash of its words, without comments."""
    words = " ".join(_COMMENT.sub(" ", _text("0")).split())
    return f"0x{sha256(words.encode()).hexdigest()[:8]}"


@cache
def _text(fingerprint: str) -> str:
    kernel = c_integers.body(fixed_sine.kernel(), lambda x: "r", ("int32_t s", "int32_t c"), {}, 90)
    alone, turned = (fixed_sine.error(OF_ANGLES, x) or 0 for x in (0.5, 2.0))
    return render("scene/coscrew_fixed.h", banner=_BANNER, fingerprint=fingerprint, kernel=kernel,
                  least=fixed_sine.LEAST_BITS, most=OF_ANGLES, half_pi=fixed_sine.HALF_PI,
                  two_over_pi=fixed_sine.TWO_OVER_PI, error=two_digits_up(alone),
                  of_quarter=two_digits_up(turned - alone),
                  approximation=" and ".join(two_digits_up(float(x))
                                             for x in fixed_sine.APPROXIMATION))
