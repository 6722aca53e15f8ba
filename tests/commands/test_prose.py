"""Documentation, docstrings, comments and messages avoid the words that the glossary replaces."""

import re
from pathlib import Path

ROOT = Path(__file__).parents[2]
GLOSSARY = ROOT / "docs/glossary.md"
ROWS = GLOSSARY.read_text(encoding="utf-8").rpartition("| say | not |\n|---|---|\n")[2].splitlines()
PHRASES = [phrase.strip() for row in ROWS for phrase in row.split("|")[2].split(",")]
REPLACED = re.compile(rf"\b({'|'.join(map(re.escape, PHRASES))})\b", re.IGNORECASE)


def texts() -> list[Path]:
    """Sources, tests, templates and guides; not the glossary and this file, which name the phrases.
    """
    results = [*ROOT.glob("*.md"), *ROOT.glob("docs/*.md")]
    for folder in ("codegen", "templates", "tests"):
        results += [x for x in (ROOT / folder).rglob("*")
                    if x.suffix in (".py", ".jinja", ".js", ".css", ".c", ".h")]
    return [x for x in sorted(results) if x not in (GLOSSARY, Path(__file__))]


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
