"""Output to terminals and pipes of any encoding: characters they lack are spelled in ASCII."""

import codecs
import io
import sys
import time
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
"""ASCII spellings of the characters used in messages and tables."""

_SUPERSCRIPTS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻", "0123456789+-")


def any_encoding(stream: TextIO | None) -> None:
    """Makes the stream accept every character: characters that its encoding lacks are spelled in
    ASCII (x^2 for x²) or replaced by ?."""
    if isinstance(stream, io.TextIOWrapper):
        codecs.register_error("coscrew", _spelled)
        stream.reconfigure(errors="coscrew")


def _spelled(error: UnicodeError) -> tuple[str, int]:
    if not isinstance(error, UnicodeEncodeError):
        raise error
    return "".join(map(_ascii, error.object[error.start:error.end])), error.end


def _ascii(character: str) -> str:
    """A character in ASCII: ^2 for ², e for é; ? if there is no spelling."""
    if character in _SPELLED:
        return _SPELLED[character]
    raised = character.translate(_SUPERSCRIPTS)
    if raised != character:
        return f"^{raised}"
    plain = unicodedata.normalize("NFKD", character).encode("ascii", "ignore").decode()
    return plain or "?"


_QUIET = 2.0  # s after which work is long enough for lines of progress


class Tenths:
    """Progress where standard error is no terminal: a line whenever another tenth of the work is
    done, of work that takes more than some seconds."""

    def __init__(self) -> None:
        self._began, self._shown = time.monotonic(), 0
        self._silent = sys.stderr is None or sys.stderr.isatty()

    def __call__(self, share: float, words: Callable[[], str]) -> None:
        """Tell that this share of the work is done: "coscrew: 30 %: " and the words."""
        tenth = int(10 * share)
        if self._silent or not self._shown < tenth < 10:
            return
        if time.monotonic() - self._began >= _QUIET:
            self._shown = tenth
            print(f"coscrew: {10 * tenth} %: {words()}", file=sys.stderr, flush=True)


@contextmanager
def status_line() -> Iterator[Callable[[str], None] | None]:
    """While the block runs, a line on standard error: yields a function that changes it, or None if
    standard error is not a terminal.  The line is erased at the end."""
    if sys.stderr is None or not sys.stderr.isatty():
        yield None
        return

    def show(words: str) -> None:
        sys.stderr.write(f"\r\x1b[K{words}")
        sys.stderr.flush()

    try:
        yield show
    finally:
        show("")


@contextmanager
def doing(what: str) -> Iterator[Callable[[str], None]]:
    """While the block runs, show a line such as "deriving …" on standard error if it is a terminal.

    Yields a function that changes the line; the line is erased at the end."""
    with status_line() as show:
        def tell(words: str) -> None:
            if show:
                show(f"{words} …")

        tell(what)
        yield tell
