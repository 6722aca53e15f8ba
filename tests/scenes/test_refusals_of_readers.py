"""Every refusal of the readers of scenes and models has a test of its words."""

import ast
from collections.abc import Iterator
from pathlib import Path

import coscrew_codegen.scene

SCENE = Path(coscrew_codegen.scene.__file__).parent
TESTS = Path(__file__).parents[1]
REFUSING = {"refuse", "_refuse", "missing", "SceneError", "ModelError", "ValueError", "TypeError"}
"""Functions and exceptions whose last argument is a message, or what was wanted."""
WORDS = 14
"""Letters of a message that stand in a test as well; all if it has fewer between its values."""


def called(call: ast.Call) -> str:
    return call.func.attr if isinstance(call.func, ast.Attribute) else \
        call.func.id if isinstance(call.func, ast.Name) else ""


def pieces(message: ast.expr) -> Iterator[str]:
    """The literal texts in an expression, except in its values' own expressions."""
    if isinstance(message, ast.Constant) and isinstance(message.value, str):
        yield message.value
    elif isinstance(message, ast.JoinedStr):
        for part in message.values:
            if isinstance(part, ast.Constant):
                yield str(part.value)
    elif isinstance(message, ast.BinOp):
        yield from pieces(message.left)
        yield from pieces(message.right)
    elif isinstance(message, ast.IfExp):
        yield from pieces(message.body)
        yield from pieces(message.orelse)


def refusals(source: str) -> Iterator[tuple[int, list[str]]]:
    """The line of each refusal in a module, and the literal texts that say what came, or if there
    are none, what was wanted."""
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Call) and called(node) in REFUSING and node.args:
            came, _, wanted = "\0".join(pieces(node.args[-1])).partition("; wanted")
            texts = [[x for x in y.split("\0") if len(x.strip(" ;,:.'()<>")) > 3]
                     for y in (came, wanted)]
            if any(texts):
                yield node.lineno, texts[0] or texts[1]


def literals(folder: Path) -> str:
    """The texts that the tests hold, one a line, without the marks of regular expressions."""
    texts = []
    for path in sorted(folder.rglob("*.py")):
        if path != Path(__file__):
            for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
                if isinstance(node, ast.Constant) and isinstance(node.value, str):
                    texts.append(node.value.replace("\\", ""))
    return "\n".join(texts)


def is_tested(texts: list[str], tests: str) -> bool:
    """Returns whether so many letters of a text, one after another, stand in the tests."""
    return any(text[i:i + WORDS] in tests for text in texts
               for i in range(max(1, len(text) - WORDS + 1)))


def test_words_of_every_refusal_stand_in_a_test():
    tests, untested = literals(TESTS), {}
    for folder in ("readers", "mechanism"):
        for path in sorted((SCENE / folder).rglob("*.py")):
            lines = [(line, texts) for line, texts in refusals(path.read_text(encoding="utf-8"))
                     if not is_tested(texts, tests)]
            if lines:
                untested[str(path.relative_to(SCENE))] = lines
    assert not untested, "\n".join(f"{path}:{line}: {' … '.join(texts)}"
                                   for path, lines in untested.items() for line, texts in lines)


def test_a_message_that_no_test_has_is_seen():
    """A few letters alone are not enough; values between the words do not count."""
    source = 'def f(x):\n    x.refuse("key", f"{x} is far too blue; wanted " f"{x} in red")\n'
    assert list(refusals(source)) == [(2, [" is far too blue"])]
    assert is_tested([" is far too blue"], "red is far too blue; w")
    assert not is_tested([" is far too blue"], "red is fat too blu")
    assert not list(refusals('f.refuse("key", str(error))'))
