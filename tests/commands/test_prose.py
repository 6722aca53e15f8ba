"""Documentation, docstrings, comments and messages avoid the words that the glossary replaces;
docstrings begin with a verb or a noun, and names say what they hold."""

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
GLOSSARY = ROOT / "docs/glossary.md"
ROWS = GLOSSARY.read_text(encoding="utf-8").rpartition("| say | not |\n|---|---|\n")[2].splitlines()
PHRASES = [phrase.strip() for row in ROWS for phrase in row.split("|")[2].split(",")]
COMPILED = tuple(ROOT / "templates/runtime/gufunc" / x for x in ("elements.h", "vectors.h"))
"""Reworded with the next change of their code: a new comment compiles all extensions again."""
REPLACED = re.compile(rf"\b({'|'.join(map(re.escape, PHRASES))})\b", re.IGNORECASE)


def texts() -> list[Path]:
    """Sources, tests, templates and guides; not the glossary and this file, which name the phrases.
    """
    results = [*ROOT.glob("*.md"), *ROOT.glob("docs/*.md")]
    for folder in ("codegen", "templates", "tests"):
        results += [x for x in (ROOT / folder).rglob("*")
                    if x.suffix in (".py", ".jinja", ".js", ".css", ".c", ".h")]
    results += (ROOT / "web").glob("src/*.js")
    return [x for x in sorted(results) if x not in (GLOSSARY, *COMPILED, Path(__file__))
            and not x.name.endswith(".min.js")]


def replaced(text: str) -> list[str]:
    """The replaced phrases in a text; line breaks in prose and underscores in names are blanks."""
    return REPLACED.findall(re.sub(r"\s*\n\s*(#|\*|//)?\s*|_", " ", text))


def test_one_idea_has_one_word():
    results = {x.relative_to(ROOT).as_posix(): words for x in texts()
               if (words := replaced(x.read_text(encoding="utf-8")))}
    assert not results, f"docs/glossary.md says what to write instead: {results}"


def test_a_replaced_phrase_is_found():
    assert replaced("exact, but\n    # for rounding") == ["but for"]
    assert replaced("def test_no_name_bears_another") == ["bears"]
    assert replaced("buttons for a list, at least one") == []
    assert len(PHRASES) > 5


OPENINGS = ("And", "As", "Also", "But", "For", "How", "If", "Just", "Not", "Of", "So", "That",
            "The same", "Those", "What", "When", "Where", "Whether", "Which")
"""Words with which no docstring begins: its first word is a verb, or the noun that it defines."""
PARTICIPLES = ("asked", "found", "said", "told")
"""Words that name nothing: a result, a request, a message and a report have names of their own."""


@pytest.fixture(scope="module")
def modules() -> dict[str, ast.Module]:
    """The syntax trees of the generator, the tests and the examples, by path."""
    paths = (x for folder in ("codegen", "tests", "examples")
             for x in sorted((ROOT / folder).rglob("*.py")))
    return {x.relative_to(ROOT).as_posix(): ast.parse(x.read_text(encoding="utf-8"))
            for x in paths}


def opened(tree: ast.Module) -> list[str]:
    """The docstrings that begin with one of OPENINGS."""
    documented = (x for x in ast.walk(tree)
                  if isinstance(x, ast.Module | ast.ClassDef | ast.FunctionDef))
    return [text.partition("\n")[0] for x in documented if (text := ast.get_docstring(x))
            and re.match(rf"({'|'.join(OPENINGS)})\b", text)]


def identifiers(tree: ast.Module) -> Iterator[str]:
    """The names that a module gives: to functions, classes, arguments, variables, imports."""
    for x in ast.walk(tree):
        if isinstance(x, ast.FunctionDef | ast.ClassDef):
            yield x.name
        elif isinstance(x, ast.arg):
            yield x.arg
        elif isinstance(x, ast.Name) and isinstance(x.ctx, ast.Store):
            yield x.id
        elif isinstance(x, ast.Attribute) and isinstance(x.ctx, ast.Store):
            yield x.attr
        elif isinstance(x, ast.alias):
            yield x.asname or x.name


def test_docstrings_begin_with_a_verb_or_the_noun_they_define(modules):
    wrong = {path: lines for path, tree in modules.items() if (lines := opened(tree))}
    assert not wrong, wrong


def test_names_are_no_participles(modules):
    wrong = {path: names for path, tree in modules.items()
             if (names := sorted(set(identifiers(tree)) & set(PARTICIPLES)))}
    assert not wrong, f"wanted names of what they hold: {wrong}"


def test_an_opening_and_a_participle_are_noticed():
    tree = ast.parse('''
def f(found):
    """What it returns."""
    for told, (said, other) in found: pass
    with other as asked: pass
class C:
    """Whetherness of a class."""
''')
    assert opened(tree) == ["What it returns."]
    assert set(PARTICIPLES) <= set(identifiers(tree))
