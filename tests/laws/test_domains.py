"""Every input has a domain, which contains the ordinary and hard numbers drawn for it."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
import sympy as sp

from coscrew_codegen.algebra.domains import LEAST_TURN, PI, hard, ordinary
from coscrew_codegen.algebra.operations import OPERATIONS, Operation
from coscrew_codegen.program.values.formats import PRECISIONS, Precision
from coscrew_codegen.program.values.quantity import (
    ANY,
    BODY,
    DISPLACEMENT,
    FRACTION,
    HALF_TURN,
    LDL_FACTOR,
    MASS,
    NONZERO,
    ORDINARY,
    POSITIVE_DEFINITE,
    REGULAR,
    ROTATION,
    SCALAR,
    SINE_COSINE,
    SYMMETRIC,
    TURN,
    UNIT_QUATERNION,
    UNIT_VECTOR,
    VEC3,
    Argument,
    Domain,
)
from coscrew_codegen.reports.kernels.inputs import benign, split
from tests.support.cases import for_all
from tests.support.limits import LARGEST_ANGLE

ROOT = Path(__file__).parents[2]
INPUTS = tuple({(a.name, a.quantity, a.domain): (op, n) for op in OPERATIONS
                for n, a in enumerate(op.inputs)}.values())
MOST = {"double": 2.0**450, "single": 2.0**45}


def far(x: np.ndarray) -> np.ndarray:
    """The distance of matrices from rotations."""
    R = x[..., :3]
    return np.maximum(np.abs(R.swapaxes(1, 2) @ R - np.eye(3)).max(axis=(1, 2)),
                      np.abs(np.linalg.det(R) - 1))


def length(x: np.ndarray) -> np.ndarray:
    """The length of vectors, or of the angular parts of screws."""
    return np.linalg.norm(x[:, -3:] if x.shape[1] == 6 else x, axis=1)


def symmetric(x: np.ndarray) -> np.ndarray:
    return (x == x.swapaxes(1, 2)).all(axis=(1, 2))


def of_bodies(x: np.ndarray, argument: Argument) -> np.ndarray:
    """Masses are positive, and so is every part of the second moments about the centre of mass."""
    m, h, I = x[:, 0], x[:, 1:4], x[:, 4:]
    places = ((0, 3, 5), (3, 1, 4), (5, 4, 2)) if argument.quantity.name == "inertia" else (
        (0, 3, 4), (3, 1, 5), (4, 5, 2))
    moments = I[:, places]
    if argument.quantity.name != "inertia":  # about the origin
        c = h / m[:, None]
        moments = moments - m[:, None, None] * (
            (c * c).sum(axis=1)[:, None, None] * np.eye(3) - c[:, :, None] * c[:, None, :])
    principal = np.linalg.eigvalsh(moments)
    return (m > 0) & (principal.sum(axis=1) - 2 * principal[:, 2] > 0)


IS_IN: dict[Domain, Callable[[np.ndarray, float, str], np.ndarray]] = {
    ROTATION: lambda x, u, _: far(x) <= 16 * u, DISPLACEMENT: lambda x, u, _: far(x) <= 16 * u,
    UNIT_VECTOR: lambda x, u, _: np.abs(length(x) - 1) <= 4 * u,
    UNIT_QUATERNION: lambda x, u, _: np.abs(np.linalg.norm(x, axis=1) - 1) <= 4 * u,
    NONZERO: lambda x, u, _: x.any(axis=1),
    ORDINARY: lambda x, u, p: (length(x) > MOST[p]**-1.0) & (length(x) < MOST[p]),
    FRACTION: lambda x, u, _: (x >= 0) & (x <= 1), MASS: lambda x, u, _: x >= 0,
    TURN: lambda x, u, p: length(x) <= LARGEST_ANGLE[p],
    HALF_TURN: lambda x, u, _: length(x) <= PI * (1 + 4 * u),
    SINE_COSINE: lambda x, u, _: np.abs(np.hypot(*x.T) - 1) <= 4 * u,
    REGULAR: lambda x, u, _: np.linalg.det(x) != 0, SYMMETRIC: lambda x, u, _: symmetric(x),
    POSITIVE_DEFINITE: lambda x, u, _: symmetric(x) & (np.linalg.eigvalsh(x)[:, 0] > 0),
    LDL_FACTOR: lambda x, u, _: (np.triu(x, 1) == 0).all(axis=(1, 2)) & (
        np.diagonal(x, axis1=1, axis2=2) > 0).all(axis=1)}
"""Tests of rows, with the precision's u and name: for the domains that exclude anything."""


def accepted(x: np.ndarray, argument: Argument, precision: Precision) -> np.ndarray:
    x = x.astype(np.float64)
    if argument.domain == BODY:
        return of_bodies(x, argument)
    return IS_IN[argument.domain](x, float(precision.u), precision.name)


@pytest.mark.parametrize("operation, place", INPUTS, ids=lambda x: (
    x.name if isinstance(x, Operation) else str(x)))
@for_all(precision=PRECISIONS)
def test_what_is_drawn_is_in_its_domain(operation: Operation, place: int, precision: Precision):
    argument, dtype = operation.inputs[place], np.dtype(precision.numpy_type)
    rows = split(operation, benign(operation, precision, 200, 1))[place]
    domain = hard(argument)
    drawn = domain.inputs(domain.draw(np.random.default_rng(1), 200, dtype)).astype(dtype)
    hard_rows = drawn.reshape(-1, *argument.quantity.shape)
    assert rows.shape == hard_rows.shape and rows.dtype == dtype
    assert np.isfinite(rows).all() and np.isfinite(hard_rows).all()
    if argument.domain in IS_IN or argument.domain == BODY:
        assert accepted(rows, argument, precision).all()
        if argument.domain not in (BODY, MASS, SINE_COSINE, POSITIVE_DEFINITE, SYMMETRIC, REGULAR,
                                   LDL_FACTOR):  # of these hard ones are any numbers
            assert accepted(hard_rows, argument, precision).all()


@pytest.mark.parametrize("domain", (*IS_IN, BODY), ids=lambda domain: domain.name)
def test_what_is_not_in_a_domain_is_noticed(domain: Domain):
    """Ordinary numbers are in none of them, with the exception of single rows; nor is zero."""
    argument = next(a for op in OPERATIONS for a in op.inputs if a.domain == domain)
    x = np.random.default_rng(2).normal(size=(50, *argument.quantity.shape)) * 2e13
    x[::2] = 0
    assert not accepted(x, argument, PRECISIONS[1]).all()


def test_every_input_says_what_it_may_be():
    for operation in OPERATIONS:
        for a in operation.inputs:
            assert a.own_domain or a.quantity.domain, f"{operation.name}: {a.name}"


def test_an_input_that_says_no_domain_is_refused():
    """The domain of vectors, numbers and matrices must be stated, at least as ANY."""
    def made(argument: Argument) -> Operation:
        return Operation("vec3", "halved", "vo = a / 2", (argument,), (Argument("vo", VEC3),),
                         lambda a: a / sp.Integer(2))

    with pytest.raises(ValueError, match="operation halved: a, a vec3, has no domain; .* ANY"):
        made(Argument("a", VEC3))
    assert made(Argument("a", VEC3, ANY)).inputs[0].domain_in_words == "a any numbers"
    assert Argument("k", SCALAR).domain == ANY  # of an output, or of no operation


def test_hard_rotations_turn_by_angles_of_all_sizes():
    """By zero, by tiny angles, by nearly half a turn."""
    (argument,) = next(op for op in OPERATIONS if op.name == "SO3_log").inputs
    domain, dtype = hard(argument), np.dtype(np.float64)
    R = domain.inputs(domain.draw(np.random.default_rng(3), 2000, dtype)).reshape(-1, 3, 3)
    angle = np.arccos(np.clip((R[:, 0, 0] + R[:, 1, 1] + R[:, 2, 2] - 1) / 2, -1, 1))
    assert (angle < 1e-9).any() and (angle > np.pi - 1e-6).any()
    assert ((angle > 0.1) & (angle < 3)).any() and LEAST_TURN < 1e-20
    assert ordinary(argument) is not None


def test_the_reference_shows_each_domain():
    for family in {op.family for op in OPERATIONS}:
        page = (ROOT / f"generated/docs/operations/{family}.md").read_text(encoding="utf-8")
        entries = dict(part.split("\n", 1) for part in page.split("\n## ")[1:])
        for op in (op for op in OPERATIONS if op.family == family):
            shown = next(line for line in entries[op.name].splitlines()
                         if line.startswith("- Inputs: ")).replace("\\", "")
            assert all(a.domain_in_words in shown for a in op.inputs), op.name
