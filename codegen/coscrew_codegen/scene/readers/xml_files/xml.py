"""XML files as trees of elements that know their lines.

Parsed by expat through defusedxml: a document type, which is where entity bombs and references to
other files live, is refused; so are deep nesting and huge files.
"""

import io
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from xml.sax import SAXException, SAXParseException
from xml.sax.handler import ContentHandler
from xml.sax.xmlreader import AttributesImpl, InputSource

from defusedxml import DefusedXmlException
from defusedxml.sax import make_parser

from coscrew_codegen.scene.readers.contents import read_bytes
from coscrew_codegen.scene.readers.foreign import of_root
from coscrew_codegen.scene.readers.scene_error import SceneError, shown
from coscrew_codegen.scene.readers.xml_files.xml_text import problem_at, text_of

DEPTH = 100  # elements in each other
SIZE = 64 * 2**20  # bytes


@dataclass(frozen=True)
class Element:
    """An element; `texts`: the pieces of text directly in it that are not blank."""

    tag: str
    attributes: Mapping[str, str]
    line: int
    children: list["Element"] = field(default_factory=list)
    texts: list["Text"] = field(default_factory=list)

    def all(self, tag: str) -> tuple["Element", ...]:
        """The children with this tag."""
        return tuple(child for child in self.children if child.tag == tag)

    def every(self, tag: str) -> Iterator["Element"]:
        """The elements with this tag below it, at any depth."""
        for child in self.children:
            yield from (child,) if child.tag == tag else ()
            yield from child.every(tag)


@dataclass(frozen=True)
class Text:
    """A text between tags, without the blanks around it, and the line in which it begins."""

    text: str
    line: int


def read_xml(path: Path, ignored: frozenset[str], wanted: str = "a URDF",
             contents: bytes | None = None) -> Element:
    """The root element of a file, or of `contents` in its place, without elements below it whose
    tags are `ignored`; messages say what kind of file was `wanted`.

    Raises SceneError, naming the line, if the file cannot be read or is not well-formed XML."""
    text, skipped = text_of(path, read_bytes(path, SIZE) if contents is None else contents,
                            wanted)
    parser = make_parser()
    parser.forbid_dtd = True

    def line() -> int:
        return skipped + int(parser.getLineNumber())

    handler = _Handler(path, ignored, line)
    parser.setContentHandler(handler)
    try:
        parser.parse(_source(text))
    except SAXParseException as error:
        at, column = error.getLineNumber() or 1, error.getColumnNumber() or 0
        raise SceneError(path, f"line {skipped + at}", problem_at(text, at, column)
                         or _in_words(error.getMessage())) from None
    except DefusedXmlException:
        raise SceneError(path, f"line {line()}", _document_type(text)) from None
    except (SAXException, LookupError, ValueError) as error:
        if isinstance(error, SceneError):
            raise
        raise SceneError(path, f"line {line()}",
                         f"{shown(error)}; wanted well-formed XML") from None
    return handler.root.children[0]


def _source(text: str) -> InputSource:
    """The text in UTF-8, whatever its declaration says."""
    source = InputSource()
    source.setByteStream(io.BytesIO(text.encode()))
    source.setEncoding("utf-8")
    return source


def _in_words(message: str) -> str:
    if message.startswith("undefined entity"):
        return f"{message}; wanted the character itself, or &amp; for &"
    if "declaration not at start" in message:
        return "<?xml … ?> stands after something else; wanted it at the beginning, or not at all"
    return f"{message}; wanted well-formed XML"


def _document_type(text: str) -> str:
    if text[:100].lower().startswith("<!doctype html"):
        return of_root("html")
    return "holds a document type (<!DOCTYPE) or entities; wanted XML without them"


class _Handler(ContentHandler):
    """Builds elements; `root` is the parent of the file's root element."""

    def __init__(self, file: Path, ignored: frozenset[str], at: Callable[[], int]) -> None:
        super().__init__()
        self._file, self._ignored, self._at = file, ignored, at
        self.root = Element("", {}, 0)
        self._open = [self.root]
        self._depth = self._ignoring_from = 0  # depth of the current ignored element, or 0

    def startElement(self, name: str, attrs: "AttributesImpl[str]") -> None:
        self._depth += 1
        line = self._at()
        if self._depth > DEPTH:
            raise SceneError(self._file, f"line {line}, <{name[:60]}>",
                             f"elements are nested deeper than {DEPTH}")
        if self._ignoring_from:
            return
        if name in self._ignored and self._depth > 1:
            self._ignoring_from = self._depth
            return
        element = Element(name, dict(attrs.items()), line)
        self._open[-1].children.append(element)
        self._open.append(element)

    def characters(self, content: str) -> None:
        if (text := content.strip()) and not self._ignoring_from:
            rest = content[len(content) - len(content.lstrip()):]  # ends in the current line
            self._open[-1].texts.append(Text(text, self._at() - rest.count("\n")))

    def endElement(self, name: str) -> None:
        if not self._ignoring_from:
            self._open.pop()
        elif self._ignoring_from == self._depth:
            self._ignoring_from = 0
        self._depth -= 1
