"""The text of an XML file: decoded by its byte order mark, by its declaration, or as UTF-8."""

import codecs
import re
from pathlib import Path

from coscrew_codegen.scene.readers.scene_error import SceneError, shown

_MARKS = ((codecs.BOM_UTF32_LE, "utf-32"), (codecs.BOM_UTF32_BE, "utf-32"),
          (b"<\0\0\0", "utf-32-le"), (b"\0\0\0<", "utf-32-be"),
          (codecs.BOM_UTF8, "utf-8-sig"), (codecs.BOM_UTF16_LE, "utf-16"),
          (codecs.BOM_UTF16_BE, "utf-16"), (b"<\0", "utf-16-le"), (b"\0<", "utf-16-be"))
"""First bytes of files, with the encoding of each; they override the declaration, which is wrong in
files that a shell's `>` wrote."""
_DECLARED = re.compile(rb"""\s*<\?xml[^>]{0,200}?\bencoding\s*=\s*["']([\w.:-]{1,40})["']""")
_ASCII = bytes(range(32, 92)) + rb"\x41 \u0041" + bytes(range(93, 127))
"""Printable characters, and escapes, which some of Python's encodings would change."""
_BARE = re.compile(r"&(?!(?:[A-Za-z_:][\w:.-]*|#[0-9]+|#x[0-9A-Fa-f]+);)")


def text_of(path: Path, contents: bytes, wanted: str = "a URDF") -> tuple[str, int]:
    """The text from its declaration or first element on, and the number of empty lines before.

    Raises SceneError for bytes that are no text in their encoding, and for text before the XML."""
    text = _decoded(path, contents)
    start = len(text) - len(text.lstrip(" \t\r\n\ufeff"))
    if start == len(text):
        raise SceneError(path, "line 1", f"is empty; wanted {wanted}")
    if not text[start:].startswith("<"):
        _refuse_beginning(path, text[start:], 1 + _lines(text[:start]), wanted)
    return text[start:], _lines(text[:start])


def problem_at(text: str, line: int, column: int) -> str:
    """The fault in the characters at a place where XML is not well-formed; "" if unknown."""
    lines = re.split("\r\n|\r|\n", text)
    here = lines[line - 1] if 0 < line <= len(lines) else ""
    bare = _BARE.search(here)
    if bare and bare.start() <= column:
        return "a bare &; wanted &amp;"
    character = here[column:column + 1]
    if character and not character.isprintable() and character != "\t":
        return f"the character U+{ord(character):04X} is not allowed here; delete it"
    if character == "<" and here[:column].count('"') % 2:
        return "a < in an attribute; wanted &lt;, or the quotation mark that is missing before it"
    return ""


def _decoded(path: Path, contents: bytes) -> str:
    for mark, encoding in _MARKS:
        if contents.startswith(mark):
            return _read(path, contents, encoding, f"{encoding}, as the file's first bytes say")
    declared = _DECLARED.match(contents)
    if declared is None:
        return _read(path, contents, "utf-8", 'UTF-8, and the file declares no other encoding; '
                     'wanted UTF-8, or the encoding in the first line, as '
                     '<?xml version="1.0" encoding="GBK"?>')
    name = declared[1].decode("ascii", "replace")
    if not _is_known(name):
        raise SceneError(path, "line 1", f"the encoding {shown(name)} is unknown, or not that of "
                         "this file; wanted UTF-8")
    return _read(path, contents, name, f"{name}, which the file declares; wanted the encoding in "
                 "which it is written")


def _is_known(name: str) -> bool:
    """Returns whether Python has an encoding of this name that contains ASCII."""
    try:
        return _ASCII.decode(name) == _ASCII.decode("ascii")
    except (LookupError, ValueError):
        return False


def _read(path: Path, contents: bytes, encoding: str, as_what: str) -> str:
    try:
        return contents.decode(encoding)
    except UnicodeDecodeError as error:
        line = 1 + contents.count(b"\n", 0, error.start)
        raise SceneError(path, f"line {line}", f"the byte 0x{contents[error.start]:02x} is not "
                         f"{as_what}") from None


def _refuse_beginning(path: Path, text: str, line: int, wanted: str) -> None:
    first = text.splitlines()[0]
    if "<" not in text:
        raise SceneError(path, f"line {line}", f"{shown(first)} is no XML; wanted {wanted}")
    raise SceneError(path, f"line {line}", f"text stands before the XML, {shown(first)}; wanted "
                     "<?xml or the root first: delete what precedes it")


def _lines(text: str) -> int:
    return len(re.findall("\r\n|\r|\n", text))
