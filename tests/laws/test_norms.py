"""Norms over the whole range of exponents, in ulps: from the smallest subnormal to overflow."""

from collections.abc import Callable
from functools import cache
from pathlib import Path

import mpmath as mp
import numpy as np
import pytest

import coscrew
import coscrew.accurate
from coscrew_codegen.accuracy.tiers import tier_named
from coscrew_codegen.algebra.operations import OPERATIONS, Operation
from coscrew_codegen.program.values.formats import DOUBLE, Precision
from tests.support.compiled.c_harness import COMPILERS, EXACT, call, harness
from tests.support.each import each_precision
from tests.support.truth.attack import plain_program

KINDS = {"vec3": (slice(0, 3), slice(0, 3)), "vec4": (slice(0, 4), slice(0, 4)),
         "quaternion": (slice(0, 4), slice(0, 4)),
         "screw": (slice(3, 6), slice(0, 3)), "coscrew": (slice(0, 3), slice(3, 6))}
"""The part whose norm it is, and the other one, which is used if all components of the first are
below the threshold."""
NAMES = tuple(op.name for op in OPERATIONS
              if op.name.partition("_")[2] in ("norm", "l2norm", "normalized", "normalize")
              and op.name.partition("_")[0] in KINDS)
TABLE = {op.name: op for op in OPERATIONS}
ULPS = {"plain": 2.5, "accurate": 0.51}
ROWS = 240
Evaluate = Callable[[Operation, Precision, np.ndarray], np.ndarray]


@cache
def rows(kind: str, precision: Precision) -> np.ndarray:
    """Sizes over the whole range, components of one size or of very different ones."""
    rng, info = np.random.default_rng(len(kind)), np.finfo(precision.numpy_type)
    n = KINDS[kind][1].stop if kind in ("vec3", "vec4", "quaternion") else 6
    least = info.minexp - info.nmant
    x = rng.uniform(0.5, 1, (ROWS, n)) * rng.choice((-1, 1), (ROWS, n))
    sizes = np.linspace(least + 1, info.maxexp, ROWS).round().astype(int)[:, None]
    if kind in ("screw", "coscrew"):  # the parts' sizes apart, in half of the rows
        other = np.where(rng.uniform(size=(ROWS, 1)) < 0.5, sizes, rng.permutation(sizes))
        sizes = np.hstack((np.repeat(sizes, 3, axis=1), np.repeat(other, 3, axis=1)))
    apart = rng.choice((0, 3, info.nmant, 4 * info.nmant), (ROWS, 1))
    with np.errstate(under="ignore", over="ignore"):
        x = np.ldexp(x, (sizes - (rng.uniform(0, 1, (ROWS, n)) * apart).astype(int)))
        x = x.astype(precision.numpy_type)
        return x[np.isfinite(x).all(axis=1)]


def truth(name: str, row: list[float], precision: Precision) -> list[mp.mpf]:
    """The norm, or the components divided by it, exactly."""
    kind, _, result = name.partition("_")
    first, second = KINDS[kind]
    threshold = np.dtype(precision.numpy_type).type(1e-9 if precision == DOUBLE else 1e-6)
    part = second if all(abs(x) < threshold for x in row[first]) else first
    norm = mp.sqrt(mp.fsum(mp.mpf(x)**2 for x in row[part]))
    if result.endswith("norm"):
        return [norm]
    return [mp.mpf(x) / norm if norm else mp.mpf(x) for x in row]


def ulps(result: float, exact: mp.mpf, precision: Precision) -> mp.mpf:
    """The error in ulps of the exact number; subnormal numbers have the ulp of the smallest one."""
    info = np.finfo(precision.numpy_type)
    if abs(exact) >= mp.mpf(2)**info.maxexp * (1 - mp.mpf(2)**(-info.nmant - 2)):
        return mp.mpf(0) if np.isinf(result) else mp.inf
    exponent = max(mp.frexp(exact)[1], info.minexp + 1) if exact else info.minexp + 1
    return abs(mp.mpf(result) - exact) / mp.mpf(2)**(exponent - info.nmant - 1)


@pytest.fixture(scope="session")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("norms")


def evaluates(tier: str, folder: Path) -> dict[str, Evaluate]:
    module = {"plain": coscrew, "accurate": coscrew.accurate}[tier]
    norms = tuple(TABLE[name] for name in NAMES
                  if tier == "plain" or tier_named("accurate").has(plain_program(TABLE[name])))
    library = harness(folder, COMPILERS[0], ("-O2", EXACT), tier.removeprefix("plain"), norms)
    return {
        "gufunc": lambda op, precision, x: getattr(module, op.name)(x),
        "twin": lambda op, precision, x: getattr(getattr(module, precision.name), op.name)(x),
        "C": lambda op, precision, x: call(library, op, precision, (x,))[0]}


@pytest.mark.parametrize("tier", ULPS)
@each_precision
@pytest.mark.parametrize("name", NAMES)
def test_norms_over_the_whole_range(name: str, precision: Precision, tier: str, folder: Path):
    x = rows(name.partition("_")[0], precision)
    values = {}
    for implementation, evaluate in evaluates(tier, folder).items():
        with np.errstate(all="ignore"):
            values[implementation] = evaluate(TABLE[name], precision, x)
    assert len({y.tobytes() for y in values.values()}) == 1
    with mp.workdps(60):
        for row, results in zip(x.tolist(), values["C"].tolist(), strict=True):
            exact = truth(name, row, precision)
            for y, t in zip(np.ravel(results), exact, strict=True):
                error = ulps(float(y), t, precision)
                assert error <= ULPS[tier], (float(error), [c.hex() for c in row], float(y).hex())
