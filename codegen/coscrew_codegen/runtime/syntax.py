"""The meaning of a source text: its syntax tree, and the modules and templates that it names.

Comments, docstrings and positions have no meaning, except docstrings that code reads."""

import ast
import re
from dataclasses import dataclass

from coscrew_codegen.runtime.cache import hashed

_READERS = {"__doc__", "getdoc", "getsource", "getsourcelines", "getcomments"}
"""Names of attributes and functions by which code reads docstrings or comments of other code."""
ANY = "*"
"""Any characters, in names that are computed."""
_NAME = re.compile(r"[\w.*-]+(?:/[\w.*-]+)*/?")
_INCLUDED = re.compile(r"{%-?\s*(?:include|import|extends|from)\s+([^\s%]+)")


@dataclass(frozen=True)
class SourceMeaning:
    """The meaning of a module or template."""

    digest: str  # hash of the syntax tree; of the bytes of a template
    documented: str  # the same with docstrings; of the bytes if code may read these
    imports: tuple[str, ...] = ()  # absolute names of modules, some of objects in modules
    texts: tuple[str, ...] = ()  # strings that may name modules or templates, with ANY
    discovers: bool = False  # whether it imports all modules beside it and below
    reads_docstrings: bool = False  # of other modules


def of_module(content: bytes, package: str) -> SourceMeaning:
    """The meaning of a module in this package."""
    try:
        tree = ast.parse(content)
    except (SyntaxError, ValueError):  # no module: importing it fails
        return of_bytes(content)
    nodes = list(ast.walk(tree))
    names = {x.id for x in nodes if isinstance(x, ast.Name)}
    imported = {name for node in nodes for name in _imported(node, package)}
    read = {x.attr for x in nodes if isinstance(x, ast.Attribute) and isinstance(x.ctx, ast.Load)}
    read |= {name.rpartition(".")[2] for name in imported} | names - {"__doc__"}
    texts = {text for node in nodes for text in _texts(node)}
    documented = _hashed(content)
    for node in nodes:
        if node is not tree or "__doc__" not in names:
            _strip(node)
    return SourceMeaning(_hashed(ast.dump(tree).encode()), documented, tuple(sorted(imported)),
                         tuple(sorted(texts)), "__path__" in names, not _READERS.isdisjoint(read))


def of_template(content: bytes) -> SourceMeaning:
    """The meaning of a template: its bytes."""
    names = {name.strip("\"'") if name[0] in "\"'" else ANY
             for name in _INCLUDED.findall(content.decode("utf-8", errors="replace"))}
    return SourceMeaning(_hashed(content), _hashed(content), texts=tuple(sorted(names)))


def of_bytes(content: bytes) -> SourceMeaning:
    """The meaning of a file that is not understood."""
    return SourceMeaning(_hashed(content), _hashed(content))


def _hashed(content: bytes) -> str:
    return hashed(content, 32)


def _imported(node: ast.AST, package: str) -> list[str]:
    """The absolute names that a statement imports."""
    if isinstance(node, ast.Import):
        return [alias.name for alias in node.names]
    if not isinstance(node, ast.ImportFrom):
        return []
    outer = package.split(".")[:len(package.split(".")) - node.level + 1] if node.level else []
    base = [*outer, *([node.module] if node.module else [])]
    return [".".join((*base, *([] if alias.name == "*" else [alias.name]))) for alias in node.names]


def _texts(node: ast.AST) -> list[str]:
    """The strings of a node that may name modules or templates; ANY if it renders a template whose
    name is computed."""
    if isinstance(node, ast.Call) and node.args and _called(node.func) == "render":
        first = node.args[0]
        return [] if isinstance(first, ast.Constant) or _text(first) else [ANY]
    text = _text(node)
    return [text] if text else []


def _called(function: ast.expr) -> str:
    return function.id if isinstance(function, ast.Name) else getattr(function, "attr", "")


def _text(node: ast.AST) -> str:
    """The string of a node if it may name a module or template, with ANY for what is filled in
    behind a folder's name."""
    text = ""
    if isinstance(node, ast.JoinedStr):
        text = "".join(str(x.value) if isinstance(x, ast.Constant) else ANY for x in node.values)
    elif isinstance(node, ast.Constant) and isinstance(node.value, str):
        text = node.value
    named = _NAME.fullmatch(text) and ("." in text or "/" in text)
    return text if named and (ANY not in text or "/" in text.partition(ANY)[0]) else ""


def _strip(node: ast.AST) -> None:
    """Remove docstrings and other statements that are only a string."""
    for field in ("body", "orelse", "finalbody"):
        statements = getattr(node, field, None)
        if isinstance(statements, list):
            kept = [x for x in statements if not (
                isinstance(x, ast.Expr) and isinstance(x.value, ast.Constant)
                and isinstance(x.value.value, str))]
            setattr(node, field, kept)
