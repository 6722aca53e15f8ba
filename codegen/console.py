"""Text for terminals and pipes of any encoding: what theirs cannot say is written another way."""

import codecs
import sys
import unicodedata
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TextIO

_SPELLED = {"·": "*", "×": "x", "−": "-", "–": "-", "—": "-", "…": "...", "≤": "<=", "≥": ">=",
            "≈": "~", "≠": "!=", "±": "+-", "→": "->", "⊕": "(+)", "√": "sqrt", "½": "1/2",
            "°": " deg", "‖": "||", "∞": "inf", "∂": "d", "′": "'", "’": "'", "‘": "'", "“": '"',
            "”": '"', "█": "#", "α": "alpha", "β": "beta", "γ": "gamma", "δ": "delta",
            "ε": "epsilon", "θ": "theta", "λ": "lambda", "μ": "mu", "µ": "u", "π": "pi",
            "ρ": "rho", "σ": "sigma", "τ": "tau", "φ": "phi", "ω": "omega", "Δ": "Delta",
            "Σ": "Sigma", "Ω": "Ohm"}
"""Characters that messages and tables hold, in ASCII."""

_SUPERSCRIPTS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻", "0123456789+-")


def any_encoding(stream: TextIO | None) -> None:
    """Make writing to the stream never fail for a character: what its encoding lacks is spelled in
    ASCII, as x^2 for x², or written as ?."""
    if hasattr(stream, "reconfigure"):
        codecs.register_error("coscrew", _spelled)
        stream.reconfigure(errors="coscrew")


def _spelled(error: UnicodeError) -> tuple[str, int]:
    if not isinstance(error, UnicodeEncodeError):
        raise error
    return "".join(map(_ascii, error.object[error.start:error.end])), error.end


def _ascii(character: str) -> str:
    """ASCII characters for one: ^2 for ², e for é; ? where there are none."""
    if character in _SPELLED:
        return _SPELLED[character]
    raised = character.translate(_SUPERSCRIPTS)
    if raised != character:
        return f"^{raised}"
    plain = unicodedata.normalize("NFKD", character).encode("ascii", "ignore").decode()
    return plain or "?"


@contextmanager
def doing(what: str) -> Iterator[Callable[[str], None]]:
    """Says on standard error what goes on, "deriving …", while it does, if that is a terminal: a
    line that is gone afterwards.  Gives what says something else instead."""
    told = sys.stderr is not None and sys.stderr.isatty()

    def tell(words: str) -> None:
        if told:
            sys.stderr.write(f"\r\x1b[K{words} …")
            sys.stderr.flush()

    tell(what)
    try:
        yield tell
    finally:
        if told:
            sys.stderr.write("\r\x1b[K")
            sys.stderr.flush()
