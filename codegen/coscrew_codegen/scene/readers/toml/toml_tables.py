"""TOML files as tables; values are read with their types, exactly, or refused by key."""

import re
import tomllib
from collections.abc import Collection, Iterable, Mapping
from fractions import Fraction
from pathlib import Path
from typing import NoReturn, overload

from coscrew_codegen.scene.names import did_you_mean, or_mean
from coscrew_codegen.scene.readers.contents import read_text
from coscrew_codegen.scene.readers.decimals import LARGEST, bounded, decimal
from coscrew_codegen.scene.readers.scene_error import SceneError, shown
from coscrew_codegen.scene.readers.toml.keys import TABLE_WITH

SIZE = 2**20  # bytes
_MESSAGE = 300  # characters of a message of tomllib
_DOTS = re.compile(r"""(?<![\w"'-])(?:[\w"'-]++[ \t]*+\.[ \t]*+){30}""")
"""Keys with 30 dots: tomllib takes quadratic time for them."""


class Decimals(str):
    """The digits of a TOML float, to be read exactly."""

    __slots__ = ()


class TomlTable:
    """A table of a file, and its key."""

    def __init__(self, file: Path, where: str, values: Mapping[str, object]) -> None:
        self.file, self.where, self.values = file, where, values

    def __contains__(self, key: str) -> bool:
        return key in self.values

    def only(self, *keys: str) -> None:
        """Refuse keys other than these."""
        for key in self.values:
            if key in keys:
                continue
            if key in TABLE_WITH:
                self.refuse(key, f"unknown key; [{TABLE_WITH[key]}] has it")
            self.refuse(key, f"unknown key; {did_you_mean(key, keys)}" if keys
                        else "unknown key; wanted none")

    def refuse(self, key: str, problem: str) -> NoReturn:
        """Raise SceneError about a key ("": about the table)."""
        raise SceneError(self.file, self.key(key), problem)

    def key(self, key: str) -> str:
        """The full key in TOML."""
        parts = [self.where, key if re.fullmatch(r"[\w-]{0,60}", key) else shown(key)]
        return ".".join(part for part in parts if part)

    def missing(self, key: str, wanted: str) -> NoReturn:
        """Raise SceneError for a missing key."""
        self.refuse(key, f"missing; wanted {wanted}")

    def table(self, key: str) -> "TomlTable":
        """The table under a key; an empty one if there is none."""
        value = self.values.get(key, {})
        if not isinstance(value, dict):
            self.refuse(key, f"{described(value)}; wanted a table")
        return TomlTable(self.file, self.key(key), value)

    def tables(self, key: str) -> Iterable[tuple[str, "TomlTable"]]:
        """The tables in the table under a key, by name."""
        outer = self.table(key)
        return [(name, outer.table(name)) for name in outer.values]

    def text(self, key: str, default: str | None = None) -> str:
        """The text under a key."""
        if key not in self.values and default is not None:
            return default
        return self.as_text(key, self.value(key, "text"))

    def choice(self, key: str, choices: tuple[str, ...], default: str | None = None) -> str:
        """The text under a key, one of these."""
        return self.as_choice(key, self.text(key, default), choices)

    def as_choice(self, key: str, value: object, choices: tuple[str, ...]) -> str:
        """A value as one of these texts."""
        text = self.as_text(key, value)
        if text not in choices:
            self.refuse(key, f"{shown(text)}; wanted one of {', '.join(choices)}"
                             f"{or_mean(text, choices)}")
        return text

    def texts(self, key: str, default: tuple[str, ...] | None = None) -> tuple[str, ...]:
        """The list of texts under a key, without duplicates."""
        if key not in self.values and default is not None:
            return default
        return self.as_texts(key, self.value(key, "a list of texts"))

    def number(self, key: str, default: Fraction | None = None) -> Fraction:
        """The number under a key."""
        if key not in self.values and default is not None:
            return default
        return self.as_number(key, self.value(key, "a number"))

    def positive(self, key: str, default: Fraction | None = None) -> Fraction:
        """The number under a key, above zero."""
        number = self.number(key, default)
        if number <= 0:
            self.refuse(key, f"{float(number):g}; wanted a positive number")
        return number

    @overload
    def nonnegative(self, key: str, default: Fraction) -> Fraction: ...

    @overload
    def nonnegative(self, key: str) -> Fraction | None: ...

    def nonnegative(self, key: str, default: Fraction | None = None) -> Fraction | None:
        """The number under a key, zero or above; the default if there is none."""
        if key not in self.values:
            return default
        number = self.number(key)
        if number < 0:
            self.refuse(key, f"{float(number):g}; wanted 0 or more")
        return number

    def numbers(self, key: str, counts: tuple[int, ...],
                default: tuple[Fraction, ...] | None = None) -> tuple[Fraction, ...]:
        """The list of numbers under a key, as many as one of `counts`."""
        if key not in self.values and default is not None:
            return default
        wanted = f"a list of {' or '.join(map(str, counts))} numbers"
        return self.as_numbers(key, self.value(key, wanted), counts)

    def value(self, key: str, wanted: str) -> object:
        """The value under a key."""
        if key not in self.values:
            self.missing(key, wanted)
        return self.values[key]

    def as_text(self, key: str, value: object) -> str:
        """A value as text."""
        if not isinstance(value, str) or isinstance(value, Decimals):
            self.refuse(key, f"{described(value)}; wanted text")
        return value

    def as_texts(self, key: str, value: object) -> tuple[str, ...]:
        """A value as texts, without duplicates."""
        if not isinstance(value, list):
            self.refuse(key, f"{described(value)}; wanted a list of texts")
        texts = tuple(self.as_text(key, item) for item in value)
        if len(set(texts)) < len(texts):
            twice = next(text for i, text in enumerate(texts) if text in texts[:i])
            self.refuse(key, f"{shown(twice)} occurs twice")
        return texts

    def as_number(self, key: str, value: object) -> Fraction:  # noqa: RET503  refuse() raises
        """A value as an exact number; texts are formulas without t, such as "pi/2", not "2"."""
        try:
            if isinstance(value, Decimals):
                return decimal(value.replace("_", ""))
            if isinstance(value, int) and not isinstance(value, bool):
                return bounded(Fraction(value), "the number")
            if isinstance(value, str):
                from coscrew_codegen.scene.constants import constant
                return constant(value)
        except ValueError as error:
            self.refuse(key, str(error))
        self.refuse(key, f"{described(value)}; wanted a number")

    def as_numbers(self, key: str, value: object, counts: tuple[int, ...]) -> tuple[Fraction, ...]:
        """A value as a list of numbers."""
        wanted = f"a list of {' or '.join(map(str, counts))} numbers"
        if not isinstance(value, list):
            self.refuse(key, f"{described(value)}; wanted {wanted}")
        if len(value) not in counts:
            self.refuse(key, f"a list of {len(value)}; wanted {wanted}")
        return tuple(self.as_number(key, item) for item in value)

    def known(self, key: str, name: str, what: str, names: Collection[str]) -> str:
        """The name, if it is one of `names`; `what` describes them: joint, body."""
        if name not in names:
            self.refuse(key, f"no {what} {shown(name)}; {did_you_mean(name, names)}")
        return name


def read_toml(path: Path) -> TomlTable:
    """The outermost table of a file.  Raises SceneError if it cannot be read or is not TOML."""
    try:
        text = read_text(path, SIZE, "a TOML file")
        if match := _DOTS.search(text):
            line = text.count("\n", 0, match.start()) + 1
            raise SceneError(path, f"line {line}", "a key of more than 30 parts; wanted fewer")
        return TomlTable(path, "", tomllib.loads(text, parse_float=Decimals))
    except SceneError:
        raise
    except RecursionError:
        raise SceneError(path, "", "lists or tables are nested too deeply") from None
    except ValueError as error:
        raise SceneError(path, "", f"{_whole(str(error))}; wanted a TOML file") from None


def _whole(message: str) -> str:
    """tomllib's message as one line; cut in the middle if too long, since its end is the place."""
    line = "".join(c if c.isprintable() else repr(c)[1:-1] for c in message)
    return line if len(line) <= _MESSAGE else f"{line[:_MESSAGE - 100]}…{line[-100:]}"


def described(value: object) -> str:
    """A value with its type in TOML's words."""
    if isinstance(value, bool):
        return f"the boolean {str(value).lower()}"
    if isinstance(value, int) and abs(value) > LARGEST:  # Python refuses to write the longest out
        return "a number out of range"
    if isinstance(value, Decimals | int):
        return f"the number {shown(str(value))[1:-1]}"
    if isinstance(value, str):
        return f"the text {shown(value)}"
    if isinstance(value, list):
        return f"a list of {len(value)}"
    return "a table" if isinstance(value, dict) else f"the time {shown(str(value))[1:-1]}"
