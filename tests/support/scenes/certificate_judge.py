"""Judges what a certificate states, without its checker: whether each line has the words that its
operation has, and whether the numbers hold at states at random and at corners, computed with 64
bits."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction

import numpy as np

WORDS: Mapping[str, tuple[int, ...]] = {
    "input": (0, 1), "add": (2, 3), "sub": (2, 3), "mul": (2,), "div": (2, 3), "neg": (1,),
    "copy": (1,), "single": (1,), "sin": (1,), "cos": (1,), "input_length": (1, 3), "error": (3,),
    "rest": (4,), "sin_rest": (2,), "cos_rest": (2,), "high": (2,), "shift": (1,)}
"""How many operands each operation may have."""
STATES = 24
LESS = 1 + 1e-9
"""Factor by which rounding to 64 bits may carry a value beyond a true bound."""
Array = np.ndarray
APPLY: Mapping[str, Callable[..., Array]] = {
    "add": lambda a, b, *_: a + b, "sub": lambda a, b, *_: a - b, "mul": lambda a, b: a * b,
    "div": lambda a, b, *_: a / b, "neg": lambda a: -a, "copy": lambda a: a, "single": lambda a: a,
    "sin": np.sin, "cos": np.cos, "error": lambda a, b, p: a * b - p,
    "rest": lambda a, b, _, h: a * b - h, "sin_rest": lambda a, s: np.sin(a) - s,
    "cos_rest": lambda a, c: np.cos(a) - c}


class FalseStatementError(Exception):
    """A line that is not well formed, or does not hold."""


def wanted(true: object, line: str) -> None:
    """Raises an error unless the line is true."""
    if not np.asarray(true).all():
        raise FalseStatementError(line)


def number(x: str) -> np.longdouble:
    """A constant of 64 bits."""
    value = Fraction(x)
    return np.longdouble(value.numerator) / np.longdouble(value.denominator)


def drawn(lines: Sequence[str], draw: np.random.Generator) -> Iterator[tuple[str, Array, str]]:
    """The inputs, each at states within its size, a third of them at its ends; quaternions have
    norm 1."""
    groups: dict[str, Array] = {}
    for words in (x.split() for x in lines if x.startswith("input ")):
        size = float.fromhex(words[-3])
        x = draw.uniform(-size, size, STATES)
        x = np.where(draw.random(STATES) < 0.4, np.sign(x) * size, x)
        if len(words) == 6:
            if words[2] not in groups:
                q = draw.normal(size=(4, STATES))
                groups[words[2]] = q / np.linalg.norm(q, axis=0)
            x, groups[words[2]] = groups[words[2]][0], np.roll(groups[words[2]], -1, axis=0)
        yield words[1], x, " ".join(words)


class Judge:
    """The values of a certificate of floating point: exact ones, computed ones, numbers of pairs.
    """

    def __init__(self, lines: Sequence[str], seed: int) -> None:
        its = [x.rstrip() for x in lines if x[0] != "#"]
        self.single = its[0].split()[0] == "24"
        self.kind = np.float32 if self.single else np.float64
        self.pairs = len(its[0].split()) == 4
        self.exact: dict[str, Array] = {}
        self.computed: dict[str, Array] = {}
        self.numbers: dict[str, Array] = {}
        for name, x, line in drawn(its, np.random.default_rng(seed)):
            wanted(name not in self.exact, line)
            self.exact[name] = self.computed[name] = self.numbers[name] = self.rounded(x)
        lengths = []
        self.last = self.waiting = ""  # the last value; if it still needs numbers
        for line in its[1:]:
            op, name, *words = line.split()
            if line[0] == " ":
                self.instruction(op, name, words, line)
                continue
            wanted(len(words) - 3 in WORDS.get(op, ()) and not self.waiting, line)
            s, e, r = (float.fromhex(x) for x in words[-3:])
            if op == "input_length":
                lengths.append((name, s, e, line))
            elif op != "input":
                self.value(op, name, words[:-3], (s, e, r), line)
        wanted(not self.waiting, "the last line")
        for length in lengths:
            self.length(*length)

    def rounded(self, x: Array) -> Array:
        """The numbers of the format near these, as numbers of 64 bits."""
        return np.asarray(x).astype(self.kind).astype(np.longdouble)

    def value(self, op: str, name: str, words: Sequence[str], figures: Sequence[float], line: str
              ) -> None:
        """Judges a value: its size, its error and, without pairs, its rounding."""
        s, e, r = figures
        operands = [x for x in words if not x.endswith(",")][:WORDS[op][0]]
        wanted(name not in self.exact and all(x in self.exact or x[0] in "-0123456789"
                                              for x in operands), line)
        self.exact[name] = APPLY[op](*(self.exact[x] if x in self.exact else number(x)
                                       for x in operands))
        wanted(abs(self.exact[name]) <= s * LESS, line)
        before = APPLY[op](*(self.at(x) for x in operands))
        if self.pairs:
            self.computed[name], self.waiting = before, name if op != "neg" else ""
            self.claim, self.last = (e, r, before), name
            return
        after = before.astype(np.float32) if op == "single" else self.rounded(before)
        self.computed[name] = after.astype(np.longdouble)
        wanted(abs(self.computed[name] - before) <= r * LESS, line)
        wanted(abs(self.computed[name] - self.exact[name]) <= e * LESS, line)

    def at(self, x: str) -> Array:
        """The computed value of an operand; of a constant it is rounded, or a pair."""
        if x in self.computed:
            return self.computed[x]
        hi = self.rounded(np.asarray(number(x)))
        return hi + self.rounded(number(x) - hi) if self.pairs else hi

    def instruction(self, op: str, name: str, words: Sequence[str], line: str) -> None:
        """Judges an instruction on numbers, or the numbers that stand for the last value."""
        if op == "is":
            e, r, before = self.claim
            total = sum((self.numbers[x] for x in words), np.zeros(STATES, np.longdouble))
            wanted(abs(total - before) <= r * LESS, line)
            wanted(abs(total - self.exact[name]) <= e * LESS, line)
            wanted(name == self.last, line)
            self.computed[name], self.waiting = total, ""
            return
        wanted(self.pairs and len(words) - 2 in WORDS.get(op, ())[:1] and
               all(x[:2] == "0x" for x in words[-2:]) and name not in self.numbers, line)
        x = [self.numbers[y] if y in self.numbers else number(y) for y in words[:-2]]
        exact = APPLY[op](*x)
        self.numbers[name] = self.rounded(exact)
        self.numbers[f"'{name}"] = exact - self.numbers[name]
        wanted(abs(self.numbers[name]) <= float.fromhex(words[-2]) * LESS, line)
        wanted(abs(self.numbers[f"'{name}"]) <= float.fromhex(words[-1]) * LESS, line)

    def length(self, name: str, s: float, e: float, line: str) -> None:
        """Judges the length of a vector; that of one component is before its rounding."""
        names = [x for x in name.split(",") if x]
        inner = [x for x in names if x in self.exact]
        if len(names) > 1:
            wanted(sum(self.exact[x]**2 for x in inner) <= (s * LESS)**2, line)
            wanted(sum((self.exact[x] - self.computed[x])**2 for x in inner) <= (e * LESS)**2, line)


def judge_fixed(lines: Sequence[str], seed: int) -> None:
    """Judges a certificate of fixed point: integers, rounded as the operations say."""
    its = [x.split() for x in lines if x[0] != "#"]
    integers: dict[str, list[int]] = {}
    exact: dict[str, list[Fraction]] = {}
    bits: dict[str, int] = {}
    draw = np.random.default_rng(seed)
    for op, name, *words, f, s, e, _ in its[1:]:
        line = " ".join((op, name, *words))
        wanted(len(words) in WORDS.get(op, ())[:1] and name not in integers, line)
        n, size, error = int(f), Fraction(float.fromhex(s)), Fraction(float.fromhex(e))
        if op == "input":
            most = int(size * Fraction(2)**n)
            integers[name] = [int(x) for x in draw.integers(-most, most + 1, STATES)]
            integers[name][:2] = -most, most
            draw.shuffle(integers[name])
            exact[name], bits[name] = [x / Fraction(2)**n for x in integers[name]], n
            continue
        given = [_word(x, integers, exact, bits) for x in words]
        at = sum(x[2] for x in given) if op in ("mul", "high") else given[0][2]
        wanted(op not in ("add", "sub") or given[0][2] == given[1][2] == n, line)
        wanted(op != "high" or n == at - 32, line)
        exact[name] = [_exact(op, x) for x in zip(*(y[1] for y in given), strict=True)]
        integers[name] = [_integer(op, x, at, n) for x in zip(*(y[0] for y in given), strict=True)]
        bits[name] = n
        for x, y in zip(exact[name], integers[name], strict=True):
            wanted(abs(x) <= size * Fraction(LESS) and
                   abs(y / Fraction(2)**n - x) <= error * Fraction(LESS) and abs(y) < 2**63, line)


def _word(x: str, integers: Mapping[str, list[int]], exact: Mapping[str, list[Fraction]],
          bits: Mapping[str, int]) -> tuple[list[int], list[Fraction], int]:
    """The integers, the values and the bits of an operand."""
    word, _, at = x.partition("@")
    if word not in integers:
        wanted(at, x)
        integer = round(Fraction(word) * Fraction(2)**int(at))
        wanted(abs(integer) < 2**31, x)
        return [integer] * STATES, [Fraction(word)] * STATES, int(at)
    factor = Fraction(2)**(bits[word] - int(at)) if at else Fraction(1)
    return integers[word], [y * factor for y in exact[word]], int(at or bits[word])


def _exact(op: str, x: Sequence[Fraction]) -> Fraction:
    """The exact value of an operation."""
    if op in ("sin", "cos"):
        return Fraction(str(APPLY[op](np.longdouble(x[0].numerator) / x[0].denominator)))
    return {"mul": lambda: x[0] * x[-1], "high": lambda: x[0] * x[-1], "add": lambda: x[0] + x[-1],
            "sub": lambda: x[0] - x[-1], "neg": lambda: -x[0], "shift": lambda: x[0]}[op]()


def _integer(op: str, x: Sequence[int], at: int, n: int) -> int:
    """The integer that the operation returns."""
    if op in ("sin", "cos"):
        return round(Fraction(str(APPLY[op](np.longdouble(x[0]) / np.longdouble(2)**at))) * 2**n)
    value = {"mul": lambda: x[0] * x[-1], "high": lambda: x[0] * x[-1], "add": lambda: x[0] + x[-1],
             "sub": lambda: x[0] - x[-1], "neg": lambda: -x[0], "shift": lambda: x[0]}[op]()
    shift = at - n if op in ("mul", "high", "shift") else 0
    return (value + (1 << shift - 1) >> shift) if shift > 0 else value << -shift
