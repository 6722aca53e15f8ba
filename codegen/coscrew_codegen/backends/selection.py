"""Selection of the part of the library to generate: families, precisions, languages."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from difflib import get_close_matches

from coscrew_codegen.accuracy.tiers import MARKED, TIERS, Tier
from coscrew_codegen.algebra.operations import FAMILIES, OPERATIONS, Operation
from coscrew_codegen.backends import languages
from coscrew_codegen.backends.library import Keep, Library, made_by
from coscrew_codegen.program.reported_error import ReportedError
from coscrew_codegen.program.values.formats import CHOICES, PRECISIONS, Precision

LANGUAGES = languages()


class SelectionError(ReportedError, ValueError):
    """An unknown name; the message gives the nearest known one."""


@dataclass(frozen=True)
class Selection:
    """Parts of the library to generate; by default everything."""

    families: tuple[str, ...] = FAMILIES
    precisions: tuple[Precision, ...] = PRECISIONS
    languages: tuple[str, ...] = LANGUAGES
    amalgamated: tuple[Tier, ...] = ()
    many: bool = False

    @property
    def operations(self) -> tuple[Operation, ...]:
        """The selected operations, in the table's order."""
        return tuple(op for op in OPERATIONS if op.family in self.families)

    def library(self, keep: Keep) -> Library:
        """Returns the selected part of the library, for targets."""
        return Library(self.operations, self.families, self.precisions, self.languages,
                       self.base, keep, self.amalgamated, self.many, self.whole)

    @property
    def whole(self) -> bool:
        """True if no part is left out."""
        return replace(self, amalgamated=(), many=False) == Selection()

    @property
    def command(self) -> str:
        """The command that generates exactly this."""
        words = [self.base]
        if self.amalgamated:
            words.append(f"--amalgamate {' '.join(tier.name for tier in self.amalgamated)}")
        if self.many:
            words.append("--many")
        return " ".join(words)

    @property
    def base(self) -> str:
        """The command that generates the selected files, without additional ones."""
        words = ["coscrew generate"]
        if self.families != FAMILIES:
            words.append(f"--family {' '.join(self.families)}")
        if self.precisions != PRECISIONS:
            words.append(f"--precision {self.precisions[0].name}")
        if self.languages != LANGUAGES:
            words.append(f"--language {self.languages[0]}")
        return " ".join(words)

    @property
    def banner(self) -> str:
        """The first line of every generated file, as a comment's text."""
        return made_by(self.base)


def select(families: list[str], precision: str, language: str | None,
           amalgamated: Sequence[str] = (), many: bool = False) -> Selection:
    """The Selection of these names.  Raises SelectionError for an unknown one, and for C besides
    another language alone."""
    _known("family", families, FAMILIES)
    _known("tier", amalgamated, tuple(tier.name for tier in TIERS))
    _known("precision", [precision], CHOICES)
    if language is not None:
        _known("language", [language], LANGUAGES)
    for option, given in (("--amalgamate", amalgamated), ("--many", many)):
        if given and language not in (None, "c"):
            raise SelectionError(f"{option} writes C, and --language {language} leaves it out; "
                                 "wanted --language c, or neither")
    return Selection(
        tuple(f for f in FAMILIES if not families or f in families),
        tuple(p for p in PRECISIONS if precision in (p.name, "both")),
        tuple(name for name in LANGUAGES if language in (None, name)),
        tuple(tier for tier in MARKED if tier.name in amalgamated), many)


def operations_named(names: list[str]) -> tuple[Operation, ...]:
    """The operations of these names, in the table's order; all if there are no names.  Raises
    SelectionError for an unknown one."""
    if unknown := _unknown("operation", names, [operation.name for operation in OPERATIONS]):
        raise SelectionError(unknown)
    return tuple(op for op in OPERATIONS if not names or op.name in names)


def _known(kind: str, given: Sequence[str], names: tuple[str, ...]) -> None:
    if unknown := _unknown(kind, given, names):
        raise SelectionError(f"{unknown}  There are {', '.join(names)}.")


def _unknown(kind: str, given: Sequence[str], names: Sequence[str]) -> str:
    """"unknown family 'vec4x': did you mean 'vec4'?", for each name that is unknown."""
    return "  ".join(f"unknown {kind} {name!r}: did you mean "
                     f"{get_close_matches(name, names, n=1, cutoff=0.0)[0]!r}?"
                     for name in given if name not in names)
