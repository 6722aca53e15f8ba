"""No error exceeds its bound in any hard case; the search that finds these cases finds broken
kernels."""

from collections import defaultdict
from itertools import islice
from pathlib import Path

import numpy as np
import pytest

import coscrew
from coscrew_codegen.algebra.operations import Operation
from coscrew_codegen.program.values.formats import PRECISIONS, Precision
from tests.hard_cases import corpus
from tests.hard_cases.constructed import ORIGIN, constructed
from tests.hard_cases.corpus import TABLE, Case, CorpusError
from tests.search import search, split
from tests.support.cases import for_all
from tests.support.compiled.calls import TIER_NAMES, of_tier, tiers_of
from tests.support.compiled.implementations import twin
from tests.support.each import each_precision
from tests.support.truth.attack import Arrays, Implementation
from tests.support.truth.judge import JUDGED, ratio

CASES: dict[tuple[str, str], list[Case]] = defaultdict(list)
for _case in corpus.load():
    CASES[_case.operation.name, _case.precision.name].append(_case)

operations = pytest.mark.parametrize("operation", JUDGED, ids=lambda op: op.name)


@pytest.fixture(scope="session")
def ways() -> dict[str, Implementation]:
    """Every tier, as users call it."""
    return {tier: of_tier(tier) for tier in TIER_NAMES}


def results(implementation: Implementation, cases: list[Case]) -> list[list[float]]:
    """All output components of each case."""
    operation, precision = cases[0].operation, cases[0].precision
    rows = np.array([case.inputs for case in cases]).astype(precision.numpy_type)
    outputs = implementation(operation, precision, split(operation, rows))
    return np.hstack([np.asarray(x).reshape(len(rows), -1) for x in outputs]).tolist()


@operations
@for_all(precision=PRECISIONS)
def test_no_hard_case_exceeds_the_bound(operation: Operation, precision: Precision,
                                        ways: dict[str, Implementation]):
    cases = CASES[operation.name, precision.name]
    assert cases, "the corpus has none"
    for tier in tiers_of(operation):
        for case, got in zip(cases, results(ways[tier], cases), strict=True):
            result = ratio(operation, precision, tier, case.inputs, got)
            assert result <= 1, f"{tier}: {result:.4g} of the bound, {case.line}"


@for_all(operation=JUDGED, precision=PRECISIONS)
def test_pure_numpy_is_as_good(operation: Operation, precision: Precision):
    cases = CASES[operation.name, precision.name]
    for case, got in zip(cases, results(twin(coscrew), cases), strict=True):
        result = ratio(operation, precision, "plain", case.inputs, got)
        assert result <= 1, f"{result:.4g} of the bound, {case.line}"


def test_the_corpus_has_what_is_constructed():
    """... and nothing that was: line by line, except inputs constructed or found twice."""
    made = {(c.operation.name, c.precision.name, c.inputs): c.line
            for c in reversed(tuple(constructed()))}
    kept = {c.line for cases in CASES.values() for c in cases if c.origin.startswith(ORIGIN)}
    assert kept == set(made.values())


# files


CASE = Case(TABLE["dot_vv"], PRECISIONS[0], (1.0, -2.5, 0.1, 4.0, 5e-324, 0.0), "by hand")


def test_a_case_is_read_as_it_was_written(tmp_path: Path):
    corpus.save([CASE, CASE], tmp_path)
    assert corpus.load(tmp_path) == (CASE,)
    assert [path.name for path in tmp_path.iterdir()] == ["vec3.txt"]


@pytest.mark.parametrize("old, new, message", [
    ("dot_vv", "dot_vw", "no operation is called 'dot_vw'"),
    ("double", "quad", "wanted one of double, single, got 'quad'"),
    (" double", "", "wanted 'operation precision', got 'dot_vv'"),
    (" : by hand", "", "wanted 'operation precision : inputs : origin'"),
    ("0x1.4", "zero", "wanted hexadecimal floats"),
    ("0x1.4000000000000p+1 ", "", "dot_vv takes 6 components, got 5"),
    ("0x1.4000000000000p+1", "inf", "wanted finite numbers of double precision"),
    ("double", "single", "wanted finite numbers of single precision"),
])
def test_a_wrong_line_is_named(tmp_path: Path, old: str, new: str, message: str):
    (tmp_path / "vec3.txt").write_text(f"# head\n\n{CASE.line.replace(old, new, 1)}\n")
    with pytest.raises(CorpusError, match=r"^vec3\.txt:3: ") as raised:
        corpus.load(tmp_path)
    assert message in str(raised.value)


# search


def _broken(operation: Operation, precision: Precision, inputs: Arrays) -> Arrays:
    """dot_vv whose last product loses its last two bits if it is the largest."""
    a, b = inputs
    with np.errstate(all="ignore"):
        return _blunt(a, b)


def _blunt(a: np.ndarray, b: np.ndarray) -> Arrays:
    products = a * b
    last = np.abs(products[:, 2]) > np.abs(products[:, :2]).sum(axis=1)
    blunt = products[:, 2] * (1 + 4 * np.finfo(a.dtype).eps)
    return (products[:, 0] + products[:, 1] + np.where(last, blunt, products[:, 2]),)


def _arccosine(operation: Operation, precision: Precision, inputs: Arrays) -> Arrays:
    """log R = θ / (2 sin θ) (R - R^T), θ = acos((tr R - 1) / 2): right for most rotations."""
    R, = inputs
    half = (R[:, 0, 0] + R[:, 1, 1] + R[:, 2, 2] - 1) / 2
    with np.errstate(all="ignore"):
        theta = np.arccos(np.clip(half, -1, 1))
        k = np.where(theta > 0, theta / (2 * np.sin(theta)), 0.5).astype(R.dtype)
    v = np.stack([R[:, 2, 1] - R[:, 1, 2], R[:, 0, 2] - R[:, 2, 0], R[:, 1, 0] - R[:, 0, 1]], 1)
    return (k[:, None] * v,)


@each_precision
@pytest.mark.parametrize("name, kernel", [("dot_vv", _broken), ("SO3_log", _arccosine)])
def test_search_finds_what_is_broken(name: str, kernel: Implementation, precision: Precision):
    rounds = search(TABLE[name], precision, "plain", kernel, seed=1)
    assert max(result.ratio for result in islice(rounds, 8)) > 1


@pytest.mark.parametrize("name", ["cross_sc", "SO3_exp"])
def test_search_finds_the_same_for_the_same_seed(name: str):
    def searched(seed: int) -> list[tuple[float, tuple[float, ...]]]:
        rounds = search(TABLE[name], PRECISIONS[1], "plain", of_tier("plain"), seed)
        return [(f.ratio, f.inputs) for f in islice(rounds, 3)]

    assert searched(1) == searched(1) != searched(2)


def test_search_climbs():
    """To 1.5 times the error at the start, and nearly to the bound."""
    rounds = search(TABLE["dot_cs"], PRECISIONS[0], "plain", of_tier("plain"), 1)
    results = [f.ratio for f in islice(rounds, 60)]
    assert results == sorted(results) and 0.85 < results[-1] <= 1 and results[0] < results[-1]
