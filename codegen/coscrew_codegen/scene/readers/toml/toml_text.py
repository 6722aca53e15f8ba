"""Writes values as TOML: what `toml_tables` reads gives the same values."""

import json
from collections.abc import Mapping

from coscrew_codegen.scene.names import toml_key
from coscrew_codegen.scene.readers.toml.toml_tables import Decimals


def toml_value(value: object) -> str:
    """A number, a text, a flag, a list or an inline table.  Raises TypeError for anything else."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, Decimals | int):
        return str(value)
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(value, list | tuple):
        return f"[{', '.join(map(toml_value, value))}]"
    if isinstance(value, Mapping):
        inside = ", ".join(toml_pairs(value))
        return f"{{ {inside} }}" if inside else "{}"
    raise TypeError(f"{value!r} is no value of TOML")


def toml_pairs(table: Mapping[str, object]) -> list[str]:
    """The keys with their values: k = 30.0."""
    return [f"{toml_key(key)} = {toml_value(value)}" for key, value in table.items()]


def joined(words: list[str]) -> str:
    """a; a and b; a, b and c."""
    return " and ".join((", ".join(words[:-1]), words[-1])) if len(words) > 1 else "".join(words)
