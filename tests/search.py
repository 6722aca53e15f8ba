"""Searches for the inputs whose errors come closest to their bounds.

`python -m tests.search [--operation NAME …] [--precision P] [--tier T] [--seconds S] [--seed N]
[--append]` draws inputs from each operation's domain and climbs from the worst: it changes last
bits, exponents, signs and parameters, and keeps what is worse.  Errors of whole batches are
estimated in a wider precision; the worst of each batch are judged exactly (support/truth/judge.py).
"""

import argparse
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np
from tabulate import tabulate
from tqdm import tqdm

from coscrew_codegen.algebra.domains import Generator, Rows
from coscrew_codegen.algebra.operations import Operation
from coscrew_codegen.program.values.formats import PRECISIONS, Precision
from tests.hard_cases import climb
from tests.hard_cases.corpus import TABLE, Case, load, save
from tests.support.compiled.calls import TIER_NAMES, of_tier, tiers_of
from tests.support.domains import angle, domains
from tests.support.truth.attack import (
    TIERED,
    UNIT,
    Arrays,
    Implementation,
    bounds,
    exact_functions,
    plain_program,
)
from tests.support.truth.attack import rows as attacking_rows
from tests.support.truth.backward import BACKWARD
from tests.support.truth.extended import evaluate
from tests.support.truth.judge import JUDGED, groups, ratio

BATCH, PARENTS = 768, 24
EXACT_EACH_ROUND = 2  # rows judged exactly, chosen by estimates; without estimates 24 times as many


@dataclass(frozen=True)
class Found:
    """The worst inputs so far and their error as a multiple of the bound."""

    ratio: float
    inputs: tuple[float, ...]


def search(operation: Operation, precision: Precision, tier: str, implementation: Implementation,
           seed: int) -> Iterator[Found]:
    """The worst inputs after each round, endlessly; the same for the same seed."""
    rng = np.random.default_rng([seed, *operation.name.encode(), precision.bytes])
    dtype = np.dtype(precision.numpy_type)
    score = _estimate if tier != "accurate" and operation.name not in BACKWARD else None
    parameters = _drawn(operation, precision, rng, dtype)
    worst, known = Found(0.0, ()), {}
    parents, fitness = parameters[:0], np.empty(0)
    while True:
        inputs = _inputs(operation, parameters, dtype)
        results = joined(implementation(operation, precision, split(operation, inputs)))
        if score:
            estimates = score(operation, precision, tier, inputs, results)
            chosen = np.argsort(-estimates, kind="stable")[:EXACT_EACH_ROUND]
        else:
            chosen = np.arange(min(len(inputs), PARENTS * EXACT_EACH_ROUND))
            parameters, estimates = parameters[chosen], np.zeros(len(chosen))
        for i in chosen.tolist():
            row = tuple(inputs[i].tolist())
            if row not in known:
                known[row] = ratio(operation, precision, tier, row, results[i].tolist())
            estimates[i] = known[row]
            if known[row] > worst.ratio:
                worst = Found(known[row], row)
        yield worst
        pool, marks = np.vstack([parents, parameters]), np.concatenate([fitness, estimates])
        best = np.argsort(-marks, kind="stable")[:PARENTS]
        parents, fitness = pool[best], marks[best]
        fresh = _drawn(operation, precision, rng, dtype)[:BATCH // 4]
        parameters = np.vstack([varied(parents, BATCH * 3 // 4, rng, dtype), fresh])
        rng.shuffle(parameters)


def _drawn(operation: Operation, precision: Precision, rng: Generator, dtype: np.dtype) -> Rows:
    """Initial parameters; for polynomials also some for which results nearly cancel."""
    drawn = np.hstack([domain.draw(rng, BATCH, dtype) for domain in domains(operation)])
    if operation in TIERED:
        cancelling = attacking_rows(operation, precision, BATCH // 4, int(rng.integers(1 << 30)))
        drawn[:BATCH // 4] = joined(cancelling)
        rng.shuffle(drawn)
    return drawn.astype(dtype).astype(float)


def _inputs(operation: Operation, parameters: Rows, dtype: np.dtype) -> Rows:
    """The rows of input components, rounded once."""
    rng, columns, start = np.random.default_rng(0), [], 0
    for domain in domains(operation):
        width = domain.draw(rng, 1, dtype).shape[1]
        columns.append(domain.inputs(parameters[:, start:start + width]).astype(dtype))
        start += width
    return np.hstack(columns)


def split(operation: Operation, rows: Rows) -> Arrays:
    """Each input of its own shape, (n, *shape)."""
    edges = np.cumsum([a.quantity.size for a in operation.inputs])[:-1]
    return tuple(np.ascontiguousarray(part).reshape(len(rows), *a.quantity.shape)
                 for part, a in zip(np.split(rows, edges, axis=1), operation.inputs, strict=True))


def joined(arrays: Arrays) -> Rows:
    """All components of each row, (n, components)."""
    return np.hstack([np.asarray(a).reshape(len(arrays[0]), -1) for a in arrays])


def _estimate(operation: Operation, precision: Precision, tier: str, inputs: Rows,
              results: Rows) -> np.ndarray:
    """Errors over bounds, in a wider precision; results that overflow count as zero."""
    u, info = float(UNIT[precision.name]), np.finfo(precision.numpy_type)
    expected = evaluate(plain_program(operation), precision, inputs)
    with np.errstate(all="ignore"):
        if tier == "certified":
            half = results.shape[1] // 2
            return _usable(np.abs(results[:, :half] - expected), results[:, half:], info)
        if operation in TIERED:
            magnitudes = np.abs(inputs.astype(expected.dtype)).T
            columns = [(u * np.abs(expected[:, i]) * bound.rounded + (float(bound.c1) * u
                        + float(bound.c2) * u * u) * absolute(*magnitudes))
                       for i, (bound, (_, absolute)) in enumerate(zip(
                           bounds(operation, precision, tier), exact_functions(operation),
                           strict=True))]
            allowed = np.stack([np.broadcast_to(c, len(inputs)) for c in columns], axis=1)
        else:
            allowed = np.full_like(expected, np.inf)
            for group in groups(operation, tier):
                places, same = list(group.places), list(group.inputs)
                sizes = np.abs(np.hstack([expected[:, places], inputs[:, same]])).max(axis=1)
                k = group.k + group.slope * np.array([angle(operation, row) for row in inputs])
                allowed[:, places] = (k * u * np.maximum(sizes, group.floor))[:, None]
        return _usable(np.abs(results - expected), allowed, info)


def _usable(error: Rows, allowed: Rows, info: np.finfo) -> np.ndarray:
    """The largest ratio of each row, of components that are finite and not tiny."""
    result = np.where(allowed > 2**20 * float(info.tiny), error / allowed, 0)
    return np.nan_to_num(result, nan=0, posinf=0).max(axis=1).astype(float)


def varied(parents: Rows, count: int, rng: Generator, dtype: np.dtype) -> Rows:
    """Children: one to three parameters of a parent changed, each in one of the ways below."""
    children = parents[rng.integers(len(parents), size=count)]
    who = np.arange(len(children))
    for _ in range(3):
        place = rng.integers(children.shape[1], size=len(children))
        change = rng.integers(2 * len(_CHANGES) if _ else len(_CHANGES), size=len(children))
        old = children[who, place].astype(dtype)
        other = np.where(rng.random(len(children)) < 0.5,
                         children[who, rng.integers(children.shape[1], size=len(children))],
                         parents[rng.integers(len(parents), size=len(children)), place])
        with np.errstate(all="ignore"):
            values = [kind(old, other.astype(dtype), rng) for kind in _CHANGES]
        new = np.choose(np.minimum(change, len(_CHANGES)), [*values, old])
        children[who, place] = np.where(np.isfinite(new), new, old)
    return children


def _flipped(x: Rows, other: Rows, rng: Generator) -> Rows:
    """One bit of the significand flipped."""
    whole = x.view(f"u{x.itemsize}")
    bit = rng.integers(np.finfo(x.dtype).nmant, size=len(x)).astype(whole.dtype)
    return (whole ^ (whole.dtype.type(1) << bit)).view(x.dtype)


_CHANGES: tuple[Callable[[Rows, Rows, Generator], Rows], ...] = (
    lambda x, other, rng: x + rng.integers(-4, 5, len(x)).astype(x.dtype) * np.spacing(x),
    lambda x, other, rng: (x * (1 + rng.standard_normal(len(x)) * np.exp2(
        rng.uniform(-50, 0, len(x))))).astype(x.dtype),
    lambda x, other, rng: np.ldexp(x, rng.integers(-3, 4, len(x))),
    lambda x, other, rng: other,
    lambda x, other, rng: np.where(rng.random(len(x)) < 0.7, -x, 0).astype(x.dtype),
    _flipped)


def within(rounds: Iterator[Found], seconds: float) -> Found:
    """The results of the rounds within this time, at least one."""
    end = time.monotonic() + seconds
    for result in rounds:
        if time.monotonic() >= end:
            return result
    raise AssertionError("a search does not end by itself")


def worst_known(target: tuple[Operation, Precision, str], implementation: Implementation,
                cases: tuple[Case, ...]) -> Found:
    """The corpus's worst case for this operation, precision and tier."""
    operation, precision, tier = target
    rows = [c.inputs for c in cases if (c.operation, c.precision) == (operation, precision)]
    result = Found(0.0, ())
    if rows:
        inputs = np.array(rows).astype(precision.numpy_type)
        results = joined(implementation(operation, precision, split(operation, inputs)))
        ratios = [ratio(operation, precision, tier, given, got)
                  for given, got in zip(rows, results.tolist(), strict=True)]
        result = max((Found(*pair) for pair in zip(ratios, rows, strict=True)),
                     key=lambda f: f.ratio)
    return result


def main() -> None:
    """Search, print the table, and optionally append to the corpus."""
    parser = argparse.ArgumentParser(description="Search the inputs with the largest errors.")
    parser.add_argument("--operation", nargs="+", default=[op.name for op in JUDGED],
                        choices=[op.name for op in JUDGED], metavar="NAME")
    parser.add_argument("--precision", nargs="+", default=[p.name for p in PRECISIONS],
                        choices=[p.name for p in PRECISIONS])
    parser.add_argument("--tier", nargs="+", default=list(TIER_NAMES), choices=TIER_NAMES)
    parser.add_argument("--seconds", type=float, default=2, help="for each line of the table")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("kernels", nargs="*", metavar="KERNEL",
                        help="with --minutes: kernels whose bounds are searched; all if none")
    parser.add_argument("--minutes", type=float, help="of processor time a kernel and precision: "
                        "climb in C (tests.hard_cases.climb), going on from what was found before")
    parser.add_argument("--append", action="store_true", help="add what is worse to the corpus")
    options = parser.parse_args()
    if unknown := set(options.kernels) - set(climb.NAMES):
        parser.error(f"no searched bound: {', '.join(sorted(unknown))}; "
                     f"of {', '.join(climb.NAMES)}")
    if options.minutes:
        raise SystemExit(climb.search(options.kernels, options.minutes, options.append) > 0)
    operations = tuple(TABLE[name] for name in options.operation)
    targets = [(op, p, tier) for op in operations for p in PRECISIONS if p.name in options.precision
               for tier in tiers_of(op) if tier in options.tier]
    cases, lines, violations = load(), [], 0
    ways = {tier: of_tier(tier) for tier in options.tier}
    for target in (progress := tqdm(targets, disable=None)):
        operation, precision, tier = target
        progress.set_description(f"{operation.name} {precision.name} {tier}")
        known = worst_known(target, ways[tier], cases)
        result = within(search(*target, ways[tier], options.seed), options.seconds)
        worse = result.ratio > known.ratio
        if options.append and worse:
            origin = f"search --tier {tier} --seed {options.seed}"
            save((*load(), Case(operation, precision, result.inputs, origin)))
        violations += max(result.ratio, known.ratio) > 1
        lines.append((operation.name, precision.name, tier, result.ratio, known.ratio,
                      _in_u(operation, tier, max(result.ratio, known.ratio))))
    print(tabulate(lines, ("operation", "precision", "tier", "found / bound", "corpus / bound",
                           "u, if not polynomial"), floatfmt=".3f"))
    print(f"{len(lines)} searches, {violations} violations")


def _in_u(operation: Operation, tier: str, ratio: float) -> float | None:
    """The error in u, if the whole result has one bound."""
    promised = {} if operation in TIERED else {group.k for group in groups(operation, tier)}
    return ratio * promised.pop() if len(promised) == 1 else None


if __name__ == "__main__":
    main()
