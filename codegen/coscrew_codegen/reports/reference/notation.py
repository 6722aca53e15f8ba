"""Turns plain-text statements and equations into Markdown with formulas in LaTeX.

    "R = exp v~, θ = |v|; singular at 2π"
    "$`R = \\exp\\tilde{v},\\;\\theta = |v|`$; singular at $`2\\pi`$"

Formulas are recognized word by word: names of arguments, single letters, functions, numbers and the
signs between them; the rest is prose.
"""

import re
from collections.abc import Collection
from dataclasses import dataclass
from itertools import groupby

_GREEK = {"α": "alpha", "δ": "delta", "θ": "theta", "ν": "nu", "π": "pi", "τ": "tau", "ω": "omega",
          "φ": "varphi", "eps": "varepsilon", "alpha": "alpha", "tau": "tau", "rho": "rho"}
_FUNCTIONS = {"sin": r"\sin", "cos": r"\cos", "cot": r"\cot", "exp": r"\exp", "log": r"\log",
              "det": r"\det", "tanh": r"\tanh", "max": r"\max", "min": r"\min",
              "sqrt": r"\sqrt", "Σ": r"\sum", "dm": "dm",
              **{name: rf"\operatorname{{{name}}}" for name in
                 ("adj", "artanh", "atan2", "diag", "sat", "tr", "Ad", "CoAd")}}
_SIGNS = {"<=": r"\le", ">=": r"\ge", "×": r"\times", "·": r"\cdot", "±": r"\pm", "∫": r"\int",
          "⊙": r"\odot", "⊕": r"\oplus", "=": "=", "+": "+", "-": "-", "/": "/",
          "<": "<", ">": ">", "|": "|", "!": "!", "'": "'", "*": "^{*}", "~": r"^{\sim}",
          "(": "(", ")": ")", "[": "[", "]": "]"}
_SPACED = {"<=", ">=", "×", "·", "±", "⊙", "⊕", "=", "+", "<", ">"}
_WORDS = {"angle", "angles", "axis", "energy", "pivot"}  # names of arguments that are English words

_TOKEN = re.compile(r"""
    (?P<units>\bkg[ ]m\^2|\brad/s|\bin[ ][WmJ]\b)
  | (?P<bar>[ ]\|[ ])
  | (?P<matrix>\[\[.*?\]\](?!\]))
  | (?P<operator>\[(?:Ad|ad)\]\*?(?:'|\^-1)?)
  | (?P<power>\^(?:-?[\w.]*\w))
  | (?P<number>\d+(?:\.\d+)?(?:e-?\d+)?(?![A-Za-z_]))
  | (?P<word>[^\W\d]\w*\u0304?(?:\.(?:lin|ang)\b)?[~*]?(?:'(?!s\b))?)
  | (?P<possessive>'s\b)
  | (?P<sign><=|>=|[×·±∫⊙⊕=+\-/<>|!*~()\[\]'])
  | (?P<mark>[,;])
  | (?P<space>\s+)
  | (?P<other>.)""", re.VERBOSE)


@dataclass(frozen=True)
class _Token:
    kind: str
    text: str
    math: bool = False


def markdown(text: str, names: Collection[str], code: Collection[str] = ()) -> str:
    """The text with its formulas between $` and `$, as on GitHub and GitLab, where Markdown leaves
    backslashes alone; `names` are its symbols, `code` names of functions."""
    tokens = _classified(text, names, code)
    runs = [(math, list(group)) for math, group in groupby(tokens, key=lambda token: token.math)]
    return "".join(_formula(run) if math else _prose(run, code) for math, run in runs)


def latex_name(name: str, index: str = "") -> str:
    """v1 → v_{1}, vo → \\mathrm{vo}, tau_c → \\tau_{c}; with a component's index as subscript."""
    base, number, below = _split(r"([^\W\d_]+?\u0304?)(\d\w*?)?(?:_(\w+))?", name)
    plain = base.removesuffix("\u0304")
    symbol = (rf"\{_GREEK[plain]}" if plain in _GREEK else
              plain if len(plain) == 1 else rf"\mathrm{{{plain}}}")
    symbol = symbol if plain == base else rf"\bar{{{symbol}}}"
    subscript = ",".join(filter(None, (number, below, index)))
    return f"{symbol}_{{{subscript}}}" if subscript else symbol


def _split(pattern: str, name: str) -> tuple[str, ...]:
    """The groups of the pattern, "" for missing ones."""
    if match := re.fullmatch(pattern, name):
        return match.groups("")
    raise ValueError(f"{name!r} is no symbol; wanted letters, digits, and an index behind _")


def _tokens(text: str, math: bool) -> list[_Token]:
    return [_Token(str(m.lastgroup), m.group(), math) for m in _TOKEN.finditer(text)]


def _classified(text: str, names: Collection[str], code: Collection[str]) -> list[_Token]:
    """The tokens, with those of formulas marked: also spaces and commas between two of these, but
    not signs and brackets around prose."""
    tokens = _tokens(text, False)
    tokens = [_Token(t.kind, t.text, _is_math(tokens, n, names, code))
              for n, t in enumerate(tokens)]
    tokens = _without_prose_in_brackets(tokens)
    atoms = {n for n, t in enumerate(tokens) if t.math and t.kind != "sign"}
    for n, token in enumerate(tokens):
        if token.kind in ("space", "mark"):
            before, after = _next_solid(tokens, n, -1), _next_solid(tokens, n, 1)
            if before is not None and after is not None and before.math and after.math:
                tokens[n] = _Token(token.kind, token.text, True)
    for math, group in groupby(range(len(tokens)), key=lambda n: tokens[n].math):
        run = list(group)
        if math and not atoms & set(run):
            for n in run:
                tokens[n] = _Token(tokens[n].kind, tokens[n].text)
    return tokens


def _is_math(tokens: list[_Token], n: int, names: Collection[str], code: Collection[str]) -> bool:
    token = tokens[n]
    if token.kind in ("matrix", "operator", "power", "number", "sign", "bar"):
        return True
    if token.kind != "word":
        return False
    word = re.sub(r"(\.lin|\.ang)?[~*]?'?$", "", token.text)
    if word in code:
        return False
    if word == "a" and word == token.text:  # the article, unless next to a sign
        return _is_symbol_a(tokens, n, names)
    if word in _WORDS or word in names and len(word) > 3 and word.isalpha() and word != "self":
        return any(t is not None and _is_symbol(t, names) for t in _beside(tokens, n))
    return (word in names or word in _FUNCTIONS or word in _GREEK or len(word) == 1
            or word.endswith("\u0304") or re.fullmatch(r"[^\W\d_]\d\w?", word) is not None
            or re.fullmatch(r"([^\W\d_]|mt)_\w{1,2}", word) is not None)


def _is_symbol(token: _Token, names: Collection[str]) -> bool:
    """Returns whether the token occurs in formulas only, never in prose."""
    word = re.sub(r"[~*]?'?$", "", token.text)
    return token.kind in ("sign", "power", "number") or token.kind == "word" and (
        word in names and len(word) < 4 or word in _GREEK)


def _is_symbol_a(tokens: list[_Token], n: int, names: Collection[str]) -> bool:
    before, after = _beside(tokens, n)
    if after and after.kind == "word":
        word = after.text.rstrip("~*'")
        signed = before is not None and before.kind == "sign"
        return word in names or len(word) == 1 and (signed or "a" in names)
    return any(t is not None and t.kind in ("sign", "power", "mark") for t in (before, after))


def _beside(tokens: list[_Token], n: int) -> tuple[_Token | None, _Token | None]:
    """The tokens before and after, ignoring spaces."""
    before = (t for t in reversed(tokens[:n]) if t.kind != "space")
    after = (t for t in tokens[n + 1:] if t.kind != "space")
    return next(before, None), next(after, None)


def _without_prose_in_brackets(tokens: list[_Token]) -> list[_Token]:
    """The tokens, with brackets around prose marked as prose."""
    waiting: list[int] = []
    for n, token in enumerate(tokens):
        if token.text in ("(", "["):
            waiting.append(n)
        elif token.text in (")", "]") and waiting:
            start = waiting.pop()
            if any(not t.math and t.kind not in ("space", "mark") for t in tokens[start:n]):
                for place in (start, n):
                    tokens[place] = _Token("other", tokens[place].text)
    return tokens


def _next_solid(tokens: list[_Token], n: int, step: int) -> _Token | None:
    n += step
    while 0 <= n < len(tokens) and tokens[n].kind in ("space", "mark"):
        n += step
    return tokens[n] if 0 <= n < len(tokens) else None


def _prose(run: list[_Token], code: Collection[str]) -> str:
    return "".join(f"`{t.text}`" if t.text in code else escaped(t.text.replace("kg m^2", "kg m²"))
                   for t in run)


def escaped(text: str) -> str:
    """The text escaped for Markdown, in tables too."""
    return re.sub(r"([\\*_$|\[\]<>])", r"\\\1", text)


def _formula(run: list[_Token]) -> str:
    while run[-1].kind in ("space", "mark"):
        run = run[:-1]
    return f"$`{_latex(run)}`$"


def _latex(run: list[_Token]) -> str:
    """The run in LaTeX: a space between two factors becomes a thin space, others are dropped."""
    parts, n = [], 0
    while n < len(run):
        token = run[n]
        if token.text == "sqrt" and (end := _closing(run, n + 1)):
            parts.append(rf"\sqrt{{{_latex(run[n + 2:end])}}}")
            n = end
        elif token.kind == "space":
            function = run[n - 1].text in _FUNCTIONS and run[n + 1].text != "("
            if n and (_ends_factor(run[n - 1]) or function) and _starts_factor(run[n + 1]):
                parts.append(r"\,")
        else:
            parts.append(rf"{token.text}\;" if token.kind == "mark" else _token_latex(token))
        n += 1
    return re.sub(r"(\\[A-Za-z]+) (?=[^A-Za-z])", r"\1", "".join(parts)).strip()


def _closing(run: list[_Token], start: int) -> int | None:
    """The index of the bracket that closes the one at `start`."""
    depth = 0
    for n in range(start, len(run)):
        depth += {"(": 1, ")": -1}.get(run[n].text, 0)
        if depth == 0:
            return n if run[start].text == "(" else None
    return None


def _ends_factor(token: _Token) -> bool:
    if token.kind == "word":
        return token.text not in _FUNCTIONS
    return token.kind in ("matrix", "operator", "power", "number") or token.text in (
        ")", "]", "*", "~", "'", "!")


def _starts_factor(token: _Token) -> bool:
    return token.kind in ("matrix", "operator", "number", "word") or token.text in ("(", "[")


def _token_latex(token: _Token) -> str:
    text = token.text
    if token.kind == "matrix":
        rows = [row.split(",") for row in re.split(r"\],\s*\[", text[2:-2])]
        inner = r" \\ ".join(" & ".join(_latex(_tokens(entry.strip(), True)) for entry in row)
                             for row in rows)
        return rf"\begin{{bmatrix}} {inner} \end{{bmatrix}}"
    if token.kind == "operator":
        above = text[4:].replace("'", r"\prime").replace("^-1", "-1")
        return rf"[\mathrm{{{text[1:3]}}}]" + (f"^{{{above}}}" if above else "")
    if token.kind == "power":
        return r"^{\mathsf{T}}" if text == "^T" else (
            r"^{-\mathsf{T}}" if text == "^-T" else f"^{{{text[1:]}}}")
    if token.kind == "number":
        digits, _, exponent = text.partition("e")
        power = f"10^{{{exponent}}}"
        return digits if not exponent else power if digits == "1" else rf"{digits} \cdot {power}"
    if token.kind == "word":
        return _word_latex(text)
    if token.kind == "bar":
        return r" \mid "
    return f" {_SIGNS[text]} " if text in _SPACED or text == "∫" else _SIGNS[text]


def _word_latex(text: str) -> str:
    word, part, mark, prime = _split(r"(\w+\u0304?)(\.\w+)?([~*])?(')?", text)
    if word in _FUNCTIONS:
        return f"{_FUNCTIONS[word]} "
    symbol = latex_name(word)
    if part:
        symbol = rf"{symbol}.\mathrm{{{part[1:]}}}"
    if mark == "~":
        wide = "tilde" if re.fullmatch(r"\\?\w", symbol) or symbol[1:] in _GREEK.values() else \
            "widetilde"
        symbol = rf"\{wide}{{{symbol}}}"
    return symbol + ("^{*}" if mark == "*" else "") + ("'" if prime else "")
