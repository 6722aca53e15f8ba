"""Checkers of certificates, as their files are."""

import ast
from collections.abc import Callable, Sequence
from functools import cache
from pathlib import Path

FOLDER = Path(__file__).parents[3] / "templates/certificate"
BOUNDS, FIXED = FOLDER / "check_bounds.py", FOLDER / "check_fixed.py"


@cache
def checker(path: Path) -> Callable[[Sequence[str]], None]:
    """The checker's function, without its last line, which reads standard input."""
    names: dict[str, Callable[[Sequence[str]], None]] = {}
    exec(path.read_text(encoding="utf-8").rpartition("\nprint(")[0], names)
    return names["check"]


def refuses(its: Sequence[str], path: Path = BOUNDS) -> bool:
    """Returns whether a checker refuses the certificate."""
    try:
        checker(path)(its)
    except (AssertionError, ValueError, KeyError, IndexError, ArithmeticError, TypeError):
        return True
    return False


def is_short(path: Path, most: int) -> bool:
    """Returns whether a checker imports fractions alone, and has so many lines of code at most."""
    text = path.read_text(encoding="utf-8")
    imports = [ast.unparse(x) for x in ast.walk(ast.parse(text))
               if isinstance(x, ast.Import | ast.ImportFrom)]
    code = [x for x in text.splitlines() if x.strip() and not x.startswith(('"""', "from "))]
    return imports == ["from fractions import Fraction as F"] and len(code) <= most and \
        max(map(len, text.splitlines())) <= 100
