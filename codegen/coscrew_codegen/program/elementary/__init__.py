"""Elementary functions as Programs: the same bits on every machine, in every language.

A function is stated in a format (`program/values/formats.py`), since its degrees and splits depend
on it.  Its coefficients and errors are data beside the derivations and proofs that tests repeat."""

from coscrew_codegen.program.elementary.elementary_function import Elementary
from coscrew_codegen.program.plugins import discover

__all__ = ["ELEMENTARY", "ERRORS", "Elementary"]

ELEMENTARY: tuple[Elementary, ...] = discover(__name__, __path__, "FUNCTION", Elementary)
"""All elementary functions, in the order of their names."""

ERRORS: tuple[Elementary, ...] = discover(__name__, __path__, "ERROR", Elementary)
"""Error functions: from an elementary function's arguments and results to the true results less
these.  The `error` of such a function is relative: |result + error - true| / |true|."""
