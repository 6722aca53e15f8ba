"""Every bound that is called searched is searched, and the search finds violations."""

from pathlib import Path

import numpy as np
import pytest

import coscrew
from coscrew_codegen.program.values.formats import DOUBLE, SINGLE, Precision
from tests.hard_cases import climb
from tests.hard_cases.climb import NAMES, SAME, Found, after, compiled
from tests.hard_cases.climb_case import parts
from tests.hard_cases.corpus import TABLE
from tests.search import split
from tests.support.domains import domains
from tests.support.each import each_precision

ROUNDS = 20
"""Climbs of a search: as many on every machine."""
EVALUATE = "static void evaluate(const REAL *x, REAL *y) {"


def test_what_is_said_to_be_searched_is():
    searched = {op.name for op in TABLE.values() if "searched" in op.tested_bounds}
    assert searched == {*NAMES, *SAME} and not set(NAMES) & set(SAME)
    for name, other in SAME.items():
        assert TABLE[name].normwise == TABLE[other].normwise
        assert TABLE[name].rounding == TABLE[other].rounding


@each_precision
@pytest.mark.parametrize("name", SAME)
def test_what_is_not_searched_again_has_the_same_bits(name: str, precision: Precision):
    """Right Jacobians are the left ones of -v, except for the signs of zeros."""
    rng, dtype = np.random.default_rng(5), np.dtype(precision.numpy_type)
    (domain,) = domains(TABLE[name])
    rows = domain.inputs(domain.draw(rng, 2000, dtype)).astype(dtype)
    sign = -1 if "right" in name else 1
    with np.errstate(all="ignore"):
        one, other = (np.asarray(getattr(coscrew, called)(*split(TABLE[name], x)))
                      for called, x in ((name, rows), (SAME[name], sign * rows)))
    assert one.dtype == dtype and np.array_equal(one, other, equal_nan=True)


@pytest.mark.parametrize("name, precision", [
    ("quaternion_from_mat3x3", SINGLE), ("SE3_exp", DOUBLE), ("euler_xyx_from_mat3x3", SINGLE),
    ("mat3x3_jacobi", DOUBLE)])
def test_estimates_are_what_is_judged(name: str, precision: Precision, tmp_path: Path):
    """Estimates agree with the judged errors, which come near the bound in a few climbs."""
    operation = TABLE[name]
    program = compiled(operation, precision, tmp_path)
    result = after(operation, precision, Found(), 0, program, ROUNDS)
    stated = [error / part.k for error, part in zip(result.errors, parts(operation), strict=True)]
    assert result.of_bound == pytest.approx(stated, rel=0.02)
    assert all(0.4 < ratio <= 1 for ratio in result.of_bound) and not result.broken


OPPOSITE = """-0x1.6a08d20fa2e5ap-1 0x1.c8791874dfbc1p-8 -0x1.92e2bp-5 -0x1.6a08984955b22p+0
-0x1.c1008cp-1 -0x1.155afde98c436p-13 0x1.02e1ff60763e1p-15 0x1.c1006016c1d79p-2
0x1.3e279bf933013p-16"""
"""Two quaternions at right angles, where both ways are equally short, except for rounding."""


@pytest.mark.parametrize("name", NAMES)
def test_no_estimate_is_larger_than_what_is_judged(name: str, tmp_path: Path):
    """Otherwise the search would climb to errors that do not exist, and miss others.  An excess of
    one u is allowed: the judgement takes off the errors of given rotations."""
    operation = TABLE[name]
    before = Found(parameters=[OPPOSITE.split()] if name == "quaternion_interpolated" else [])
    result = after(operation, SINGLE, before, 0, compiled(operation, SINGLE, tmp_path), ROUNDS)
    for error, part, ratio in zip(result.errors, parts(operation), result.of_bound, strict=True):
        assert error <= 1.02 * ratio * part.k + 1


@pytest.mark.parametrize("spoil, is_seen", [
    ("if (x[0] > 0.5f) { y[3] *= 1 + 16 * (REAL)U; }", lambda result: max(result.of_bound) > 1),
    ("if (x[0] > 0.5f) { y[0] = (REAL)NAN; }", lambda result: result.broken),
    ("if (x[0] > 0.5f) { y[0] += 1; }", lambda result: result.broken)],
    ids=["a rounding", "NaN", "an error that is too large to climb to"])
def test_what_is_broken_is_found(spoil: str, is_seen, tmp_path: Path,
                                 monkeypatch: pytest.MonkeyPatch):
    operation, text_of = TABLE["quaternion_from_axis_angle"], climb.text_of

    def spoiled(*target) -> str:
        before, mark, body = text_of(*target).partition(EVALUATE)
        body, end, rest = body.partition("\n}")
        return f"{before}{mark}{body}\n  {spoil}{end}{rest}"

    monkeypatch.setattr(climb, "text_of", spoiled)
    result = after(operation, SINGLE, Found(), 0, compiled(operation, SINGLE, tmp_path), ROUNDS)
    assert is_seen(result) and result.worst > 1


def test_a_search_goes_on_and_starts_anew_when_the_kernel_has_changed(
        tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    operation, text_of = TABLE["quaternion_from_axis_angle"], climb.text_of
    monkeypatch.setattr(climb, "FOLDER", tmp_path)
    (first,) = climb.climb(operation, SINGLE, 0.1)
    (second,) = climb.climb(operation, SINGLE, 0.2)
    assert not list(climb.climb(operation, SINGLE, 0.2))
    assert (first.seconds, second.seconds, second.slices) == (0.1, 0.2, 2)
    assert second.errors[0] >= first.errors[0] > 0
    monkeypatch.setattr(climb, "text_of", lambda *target: text_of(*target) + "\n/* changed */\n")
    (third,) = climb.climb(operation, SINGLE, 0.1)
    assert (third.seconds, third.slices) == (0.1, 3) and third.kernel != second.kernel
    assert third.errors[0] >= second.errors[0]
