"""Certificates with a number, an operation, an operand or a line that is changed at random: what a
checker accepts of them is true, as a judge finds at states of its own."""

from collections.abc import Callable, Iterator, Sequence
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from coscrew_codegen.accuracy.certificate import certificate, of_fixed, of_pairs
from coscrew_codegen.program.fixed.fixed_program import Products
from coscrew_codegen.program.values.formats import DOUBLE, SINGLE
from tests.support.scenes import fixed_robots
from tests.support.scenes.certificate_checks import BOUNDS, FIXED, checker, refuses
from tests.support.scenes.certificate_judge import (
    WORDS,
    FalseStatementError,
    Judge,
    judge_fixed,
)
from tests.support.scenes.certified_functions import function, mixture

COUNT = 60
FACTORS = (0.0, 0.5, 0.9, 1 - 1e-9, 1 + 1e-9, 1.5, 4.0)
CASES = ("plain double", "free base", "pairs", "mixture", "fixed", "fixed, high words")
each_case = pytest.mark.parametrize("case", CASES)


@cache
def made(case: str) -> tuple[str, ...]:
    """The certificate's lines."""
    if case.startswith("fixed"):
        its = fixed_robots.fixed("UR5", ("gravity_torques",)).functions[0]
        products = Products.HIGH if "high" in case else Products.FULL
        return tuple(of_fixed(its.plain, its.programs[products]).splitlines())
    if case in ("pairs", "mixture"):
        its = function("floating", "body_poses")
        return tuple(of_pairs(its, SINGLE, mixture(its, 2) if case == "mixture" else None
                              ).splitlines())
    its, precision = (function("UR5", "gravity_torques"), DOUBLE) if "double" in case else \
        (function("floating", "body_poses"), SINGLE)
    return tuple(certificate(its, precision).splitlines())


def checked_by(case: str) -> Path:
    return FIXED if case.startswith("fixed") else BOUNDS


def judged_false(case: str, its: Sequence[str]) -> bool:
    """Returns whether the judge finds the certificate false or ill-formed."""
    try:
        judge_fixed(its, 1) if case.startswith("fixed") else Judge(its, 1)
    except (FalseStatementError, KeyError, ValueError, IndexError, TypeError, ArithmeticError):
        return True
    return False


class Changes:
    """Changes of a certificate's lines, one at a time."""

    def __init__(self, its: Sequence[str], seed: int) -> None:
        self.its, self.draw = its, np.random.default_rng(seed)
        self.places = [n for n, x in enumerate(its) if x[0] != "#"][1:]
        self.names = [its[n].split()[1] for n in self.places]

    def one(self) -> tuple[str, list[str]]:
        """The kind of a change, and the changed lines."""
        place = int(self.draw.choice(self.places))
        kinds: tuple[Callable[[int], Iterator[str]], ...] = (
            self.figure, self.operation, self.operand, self.more, self.fewer, self.constant,
            self.renamed, self.deleted, self.swapped, self.twice)
        kind = kinds[self.draw.integers(len(kinds))]
        return kind.__name__, [*self.its[:place], *kind(place),
                               *self.its[place + 1 + (kind == self.swapped):]]

    def line(self, place: int) -> tuple[str, list[str]]:
        """The indentation of a line, and its words."""
        return " " * (self.its[place][0] == " "), self.its[place].split()

    def changed(self, place: int, at: int, word: str) -> str:
        indent, words = self.line(place)
        return indent + " ".join([*words[:at], word, *words[at + 1:]])

    def figure(self, place: int) -> Iterator[str]:
        _, words = self.line(place)
        at = int(self.draw.choice([n for n, x in enumerate(words) if x[:2] == "0x"] or [1]))
        word = words[at] if at == 1 else (
            float.fromhex(words[at]) * float(self.draw.choice(FACTORS))).hex()
        yield self.changed(place, at, word)

    def operation(self, place: int) -> Iterator[str]:
        yield self.changed(place, 0, str(self.draw.choice([*WORDS, "is"])))

    def operand(self, place: int) -> Iterator[str]:
        _, words = self.line(place)
        inner = [n for n in range(2, len(words)) if words[n][:2] != "0x"]
        yield self.changed(place, int(self.draw.choice(inner or [1])), self.name())

    def more(self, place: int) -> Iterator[str]:
        _, words = self.line(place)
        at = int(self.draw.integers(2, len(words) + 1))
        word = words[at] if at < len(words) else ""
        yield self.changed(place, at, f"{self.name()} {word}")

    def fewer(self, place: int) -> Iterator[str]:
        indent, words = self.line(place)
        at = int(self.draw.integers(len(words)))
        yield indent + " ".join([*words[:at], *words[at + 1:]])

    def constant(self, place: int) -> Iterator[str]:
        _, words = self.line(place)
        inner = [n for n in range(2, len(words)) if words[n][:2] != "0x"]
        word = str(self.draw.choice(["0", "1", "-2", "1/3", "7@20", "1@31", "0x1p0"]))
        yield self.changed(place, int(self.draw.choice(inner or [1])), word)

    def renamed(self, place: int) -> Iterator[str]:
        yield self.changed(place, 1, self.name())

    def deleted(self, place: int) -> Iterator[str]:
        yield from ()

    def swapped(self, place: int) -> Iterator[str]:
        yield from self.its[place:place + 2][::-1]

    def twice(self, place: int) -> Iterator[str]:
        yield from [self.its[place]] * 2

    def name(self) -> str:
        return str(self.draw.choice(self.names))


@each_case
def test_the_judge_finds_certificates_true(case):
    checker(checked_by(case))(made(case))
    assert not judged_false(case, made(case))


@each_case
def test_accepted_changes_are_true(case):
    """Most changes are refused; the judge, who knows states alone, finds many of these false."""
    changes, refused, false = Changes(made(case), CASES.index(case)), 0, 0
    for _ in range(COUNT):
        kind, its = changes.one()
        is_false = judged_false(case, its)
        if refuses(its, checked_by(case)):
            refused, false = refused + 1, false + is_false
        else:
            assert not is_false, (kind, [x for x in its if x not in made(case)])
    assert refused > COUNT / 2 and false > COUNT / 4
