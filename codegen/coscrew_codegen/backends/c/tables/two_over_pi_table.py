"""The table of the digits of 2/π, and the function that reads it."""

from collections.abc import Mapping

from coscrew_codegen.backends.c.c_statements import WIDTH, listed
from coscrew_codegen.backends.render import render
from coscrew_codegen.program import Constant
from coscrew_codegen.program.two_over_pi import EXTRA, chunks
from coscrew_codegen.program.values.formats import Precision


def in_c(precision: Precision) -> str:
    """The function ksl_two_over_pi, for a header that includes math.h, stdint.h and string.h."""
    return render("c/two_over_pi", **holes(precision, precision.suffix))


def holes(precision: Precision, suffix: str = "") -> Mapping[str, object]:
    """Returns the templates' data; literals end in the suffix."""
    some = chunks(precision.digits)
    literals = [precision.literal(Constant(x, x)) + suffix for x in some.values]
    return {"precision": precision, "bits": some.bits, "scale": some.scale, "extra": EXTRA,
            "count": len(literals), "values": listed("    ", literals, "", WIDTH),
            "least": 2**some.offset, "offset": some.offset + precision.bias,
            "mask": hex(2**(8 * precision.bytes - precision.digits) - 1)}
