"""Finds arithmetic in templates and in text of C or Python.

An operator is + - * / % between two operands, or its assignment (+=); counters (++), signs of
numbers and pointers do not count.  Text is assumed to be spaced as ours: pointers are `real *x`.
"""

import re

import jinja2

_HOLE = "X"
_LITERALS = {
    "c": r'/\*.*?\*/|//[^\n]*|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'|#include[^\n]*',
    "python": r'[rf]?"""(?:.|\n)*?"""|#[^\n]*|[rf]?"(?:\\.|[^"\\\n])*"'}
_NUMBER = r"\b(?:0[xX][0-9a-fA-F.]+(?:[pP][+-]?\d+)?|\d+\.?\d*(?:[eE][+-]?\d+)?)\w*"
_OPERATOR = re.compile(
    r"[\w)\]] +(?:[-*/%+]|//|\*\*) +(?=[\w(*&~!\[-])"  # a + b
    r"|[\w)\]](?<!\breturn)(?:[-/%+*]|//|\*\*)(?=[\w(])(?!>)"  # a+b
    r"|[\w)\]](?<!\breturn)(?<!\bcase) [-+](?=[\w(])"  # a +b
    r"|(?:[-*/%+]|//|\*\*)=(?!=)")  # a += b


def text_of(source: str) -> str:
    """The text of a template with X in its holes."""
    parts, inside = [], False
    for _, kind, value in jinja2.Environment().lex(source):
        if kind == "data":
            parts.append(value)
        elif kind == "variable_begin":
            inside = True
            parts.append(_HOLE)
        elif kind == "variable_end":
            inside = False
        assert kind != "data" or not inside
    return "".join(parts)


def operators(source: str, language: str) -> list[str]:
    """The lines of a template that contain arithmetic."""
    code = re.sub(_LITERALS[language], lambda x: "\n" * x[0].count("\n"), text_of(source),
                  flags=re.DOTALL)
    code = re.sub(_NUMBER, "1", code)
    return [row.strip() for row in code.split("\n") if _OPERATOR.search(row)]
