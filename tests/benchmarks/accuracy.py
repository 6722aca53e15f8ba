"""Errors of coscrew's plain double kernels and of other libraries, for the same hard inputs.

`python -m tests.benchmarks.accuracy` prints, for every operation and range of inputs, the worst
error of each in u = 2^-53 of the result's (its part's) largest component.  Truth has 60 digits.
"""

from collections.abc import Callable, Iterator

import mpmath as mp
import numpy as np
from tabulate import tabulate
from tqdm import tqdm

import coscrew
import coscrew.accurate
from coscrew_codegen.algebra.domains import directions
from coscrew_codegen.algebra.operations import Operation
from coscrew_codegen.program.values.formats import DOUBLE
from tests.benchmarks.peers import Peer, peers
from tests.hard_cases.corpus import TABLE
from tests.support.truth.judge import groups
from tests.support.truth.motions import (
    DIGITS,
    TRUTHS,
    exponential_series,
    hstack,
    norm,
    quaternion_exp,
    skew,
)
from tests.support.truth.truths import Components, other_way, truth

U = 2.0**-53
SAMPLES = 16
Arrays = tuple[np.ndarray, ...]


def _other_screw(s: mp.matrix) -> mp.matrix:
    """The screw of the same displacement whose rotation has the opposite sense."""
    w = s[3:6] * (1 - 2 * mp.pi / norm(s[3:6]))
    t = exponential_series(skew(s[3:6]), 1) * s[0:3]
    return mp.matrix([*mp.lu_solve(exponential_series(skew(w), 1), t), *w])


_INVERSES = {
    "SO3_rightJacobianInverse": lambda v: TRUTHS["SO3_rightJacobianInverse"](
        v * (1 - 2 * mp.pi / norm(v))),
    "SE3_rightJacobianInverse": lambda s: TRUTHS["SE3_rightJacobianInverse"](_other_screw(s))}

# Rotations: the angles of each range.
_ANGLES: dict[str, Callable[[np.random.Generator], np.ndarray]] = {
    "θ to 1e-4": lambda rng: 10 ** rng.uniform(-30, -4, SAMPLES),
    "1e-4 to 3": lambda rng: np.concatenate([10 ** rng.uniform(-4, 0, SAMPLES // 2),
                                             rng.uniform(1, 3, SAMPLES // 2)]),
    "π - 0.1 to 1e-13": lambda rng: np.pi - 10 ** rng.uniform(-13, -1, SAMPLES),
    "π": lambda rng: np.full(SAMPLES, np.pi)}

_MOTIONS = ("SO3_exp", "SO3_log", "SO3_rightJacobian", "SO3_rightJacobianInverse", "SE3_exp",
            "SE3_log", "SE3_rightJacobian", "SE3_rightJacobianInverse", "quaternion_exp",
            "quaternion_log", "mat3x3_from_quaternion", "quaternion_from_mat3x3",
            "quaternion_interpolated")
_LENGTHS = {"to 1e-300": (-307, -300), "1e-200": (-201, -199), "1": (-3, 3),
            "1e200": (199, 201), "to 1e307": (300, 307)}
_GAPS = {"to 1e-10": (-15, -10), "1e-10 to 1e-4": (-10, -4), "1e-4 to 1": (-4, 0)}


def cases() -> Iterator[tuple[Operation, str, Arrays]]:
    """(operation, range, rows of its inputs)."""
    rng = np.random.default_rng(11)
    for name in _MOTIONS:
        for words, angles in _ANGLES.items():
            yield TABLE[name], words, _turns(TABLE[name], rng, angles(rng))
    for name in ("vec3_l2norm", "vec3_normalized"):
        for words, (low, high) in _LENGTHS.items():
            yield TABLE[name], f"length {words}", (
                directions(rng, SAMPLES) * 10 ** rng.uniform(low, high, (SAMPLES, 1)),)
    for words, (low, high) in _GAPS.items():
        a = rng.standard_normal((SAMPLES, 3))
        off = rng.standard_normal((SAMPLES, 3)) * 10 ** rng.uniform(low, high, (SAMPLES, 1))
        yield TABLE["angle_vv"], f"angle {words}", (a, a + off)


def _turns(operation: Operation, rng: np.random.Generator, angles: np.ndarray) -> Arrays:
    """Inputs for rotations by these angles, computed in 60 digits and rounded once."""
    v = directions(rng, SAMPLES) * angles[:, None]
    lever = directions(rng, SAMPLES) * 10 ** rng.uniform(-1, 1, (SAMPLES, 1))
    kind = operation.inputs[0].quantity.name
    if kind == "vec3":
        return (v,)
    if kind == "screw":
        return (np.hstack([lever, v]),)
    with mp.workdps(DIGITS):
        vectors = [mp.matrix(row.tolist()) for row in v]
        if kind == "mat3x3":
            return (_rounded([exponential_series(skew(x)) for x in vectors]),)
        if kind == "SE3":
            return (_rounded([hstack(exponential_series(skew(x)), mp.matrix(t.tolist()))
                              for x, t in zip(vectors, lever, strict=True)]),)
        quaternions = _rounded([quaternion_exp(x) for x in vectors])[..., 0]
        if len(operation.inputs) == 1:
            return (quaternions,)
        identity = np.tile([0, 0, 0, 1.0], (SAMPLES, 1))
        return identity, quaternions, rng.uniform(0, 1, SAMPLES)


def _rounded(matrices: list[mp.matrix]) -> np.ndarray:
    return np.array([[[float(x) for x in row] for row in m.tolist()] for m in matrices])


def errors(operation: Operation, inputs: Arrays, result: np.ndarray) -> float:
    """The worst error of the rows in u."""
    given = np.hstack([x.reshape(SAMPLES, -1) for x in inputs]).tolist()
    return max(min(_error(operation, right, got) for right in _truths(operation, row))
               for row, got in zip(given, result.reshape(SAMPLES, -1).tolist(), strict=True))


def _truths(operation: Operation, given: list[float]) -> list[Components]:
    """The true results: two at half a turn, and both signs of a quaternion."""
    results = [truth(operation, DOUBLE, tuple(given))]
    other = other_way(operation, given, 64 * U)
    results += [other] if other is not None else []
    if operation.name in _INVERSES and np.linalg.norm(given[-3:]) > np.pi - 64 * U:
        with mp.workdps(DIGITS):  # of libraries that take a rotation instead of its vector
            results.append(list(_INVERSES[operation.name](mp.matrix(given))))
    if operation.outputs[0].quantity.name == "quaternion":
        results += [[-x for x in right] for right in results]
    return results


def _error(operation: Operation, right: Components, got: list[float]) -> float:
    places = [group.places for group in groups(operation, "plain")] or [range(len(got))]
    if not np.isfinite(got).all():
        return float("inf")
    return max(float(max(abs(got[i] - right[i]) for i in part)
                     / (U * max(abs(right[i]) for i in part))) for part in places
               if any(right[i] for i in part))


def row(operation: Operation, words: str, inputs: Arrays, others: tuple[Peer, ...]) -> list[str]:
    """A line of the table."""
    with np.errstate(all="ignore"):
        ours = errors(operation, inputs, getattr(coscrew, operation.name)(*inputs))
        theirs = {peer.name: errors(operation, inputs, peer.functions[operation.name](*inputs))
                  for peer in others if operation.name in peer.functions}
        accurate = getattr(coscrew.accurate, operation.name, None)
        carried = f"{errors(operation, inputs, accurate(*inputs)):.3g}" if accurate else ""
    name, best = min(theirs.items(), key=lambda item: item[1], default=("", float("inf")))
    verdict = "best" if ours <= best else f"{name} by {ours - best:.1f}"
    columns = (f"{theirs[peer.name]:.3g}" if peer.name in theirs else "" for peer in others)
    return [operation.name, words, f"{ours:.3g}", carried, *columns, verdict]


def main() -> None:
    """Print the table."""
    others, missing = peers()
    lines = [row(*case, others) for case in tqdm(list(cases()), disable=None)]
    print("\nWorst error in u = 2^-53 of the largest component; double precision; "
          f"{SAMPLES} inputs a line, seed 11; empty: the library does not have it")
    print("; ".join([f"coscrew (compiled: {coscrew.COMPILED})",
                     *(f"{peer.name} {peer.version}" for peer in others),
                     *(f"{name} is missing" for name in missing)]))
    names = [peer.name for peer in others]
    print(tabulate(lines, ("operation", "inputs", "plain", "accurate", *names, "best"),
                   disable_numparse=True))
    best = sum(line[-1] == "best" for line in lines)
    print(f"plain kernels are best in {best} of {len(lines)} lines")


if __name__ == "__main__":
    main()
