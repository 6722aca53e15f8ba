"""Python's functions refuse matrices that are no rotations and quaternions without a direction."""

from collections.abc import Iterable
from importlib import import_module
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

import coscrew
from coscrew import _dispatch
from coscrew_codegen.accuracy.tiers import TIERS
from coscrew_codegen.algebra.lowering.programs import program_of
from coscrew_codegen.algebra.operations import FAMILIES, OPERATIONS, Operation
from coscrew_codegen.backends.library import FamilyKernels
from coscrew_codegen.backends.requirements import requirements
from coscrew_codegen.program import Input
from coscrew_codegen.program.values.formats import DOUBLE, PRECISIONS
from coscrew_codegen.program.values.quantity import (
    DISPLACEMENT,
    NONZERO,
    NONZERO_MATRIX,
    ORDINARY,
    ROTATION,
    UNIT_QUATERNION,
)
from coscrew_codegen.reports.kernels.inputs import benign
from tests.support.rotations import NO_ROTATIONS

LETTERS = {ROTATION: "R", DISPLACEMENT: "R", UNIT_QUATERNION: "U", NONZERO: "N", ORDINARY: "N",
           NONZERO_MATRIX: "M"}
UNCHECKED = frozenset(
    name for line in Path(__file__).with_name("unchecked_operations.txt").read_text().splitlines()
    if line and not line.startswith("#") for name in line.partition(": ")[2].split())
RESTRICTED = {op.name: "".join(LETTERS.get(a.domain, ".") for a in op.inputs) for op in OPERATIONS
              if any(a.domain in LETTERS for a in op.inputs)}
"""A letter for each argument, by its domain."""
REFUSED = {name: letters for name, letters in RESTRICTED.items() if name not in UNCHECKED}
PLACES = {tier: import_module(tier.package) for tier in TIERS}
BY_NAME = {op.name: op for op in OPERATIONS}


def in_places(names: Iterable[str]) -> list[tuple[Operation, ModuleType]]:
    """Each operation with each package that has it, and with the dispatcher."""
    return [(op, place) for op in map(BY_NAME.__getitem__, names) for place in (_dispatch, *(
        place for tier, place in PLACES.items() if tier.has(program_of(op))))]


def named(x: Operation | ModuleType) -> str:
    return x.name if isinstance(x, Operation) else x.__name__


I3 = np.eye(3)
ROTATIONS = {
    "three digits": np.array([[0.707, -0.707, 0], [0.707, 0.707, 0], [0, 0, 1]]),
    "single precision": coscrew.SO3_exp([1, 2, 3]).astype(np.float32),
    "integers": np.array([[0, -1, 0], [1, 0, 0], [0, 0, 1]]), "NaN": np.full((3, 3), np.nan)}


def arguments(operation: Operation, lead: tuple[int, ...] = ()) -> list[np.ndarray]:
    """Valid ones."""
    rows = benign(operation, DOUBLE, max(1, int(np.prod(lead))), 3)
    ends = np.cumsum([a.quantity.size for a in operation.inputs])[:-1]
    return [part.reshape((*lead, *a.quantity.shape))
            for part, a in zip(np.split(rows, ends, axis=1), operation.inputs, strict=True)]


def spoiled(letter: str, shape: tuple[int, ...], R: np.ndarray) -> np.ndarray:
    """An argument that the letter refuses: with this matrix, a length of 1.01, or zero."""
    if letter == "R":
        return np.hstack([R, np.zeros((3, shape[1] - 3))])
    return np.full(shape, 0.505 if letter == "U" else 0)


def test_what_is_required_is_what_the_domains_say():
    """Copies, products and rates, which are algebra, are left out."""
    results: dict[str, str] = {}
    for family in FAMILIES:
        results |= requirements(FamilyKernels(
            family, tuple(op for op in OPERATIONS if op.family == family), PRECISIONS))
    assert results == REFUSED and RESTRICTED.keys() >= UNCHECKED


@pytest.mark.parametrize("operation, place", in_places(REFUSED), ids=named)
def test_each_argument_is_refused_by_its_name(operation: Operation, place: ModuleType):
    function = getattr(place, operation.name)
    for k, (a, letter) in enumerate(zip(operation.inputs, REFUSED[operation.name], strict=True)):
        if letter == ".":
            continue
        given = arguments(operation)
        function(*given)
        given[k] = spoiled(letter, a.quantity.shape, np.diag([1.0, -1, 1]))
        with pytest.raises(ValueError, match=f"^{operation.name}: .*\\b{a.name} is (no|zero)"):
            function(*given)


@pytest.mark.parametrize("operation, place", in_places(sorted(UNCHECKED)), ids=named)
def test_algebra_takes_any_numbers(operation: Operation, place: ModuleType):
    given = [spoiled(letter, a.quantity.shape, np.diag([1.0, -1, 1])) if letter != "." else x
             for a, x, letter in zip(operation.inputs, arguments(operation),
                                     RESTRICTED[operation.name], strict=True)]
    result = getattr(place, operation.name)(*given)
    assert all(np.isfinite(x).all() for x in (result if isinstance(result, tuple) else (result,)))


@pytest.mark.parametrize("operation, place", in_places(REFUSED), ids=named)
def test_nan_anywhere_makes_a_result_nan(operation: Operation, place: ModuleType):
    """Products with elementary motions, which do not read every column, are left out."""
    program = program_of(operation)
    read = {x for step in program.instructions for x in step.operands} | set(program.results)
    function, letters = getattr(place, operation.name), REFUSED[operation.name]
    for k in range(len(letters)):
        if letters[k] == ".":
            continue
        shape, indices = operation.inputs[k].quantity.shape, operation.inputs[k].quantity.indices
        columns = {indices[x.index][1] for x in read if isinstance(x, Input) and x.argument == k}
        for index in np.ndindex(*shape[:1], *(min(n, 3) for n in shape[1:])):  # R of displacements
            if len(shape) > 1 and index[1] not in columns:
                continue
            given = arguments(operation)
            given[k][index] = np.nan
            with np.errstate(all="ignore"):
                result = function(*given)
            result = (result if isinstance(result, tuple) else (result,))[:len(operation.outputs)]
            assert any(np.isnan(x).any() for x in result), (operation.inputs[k].name, index)


@pytest.mark.parametrize("R", NO_ROTATIONS.values(), ids=NO_ROTATIONS)
@pytest.mark.parametrize("place", (coscrew, _dispatch), ids=("compiled", "dispatch"))
def test_matrices_that_are_no_rotations(R: np.ndarray, place):
    for given in (R, R.tolist(), [I3, R], np.asfortranarray(R), np.broadcast_to(R, (4, 5, 3, 3)),
                  np.stack([R, I3, I3])[::-1], R.astype(np.float32) if R.max() < 1e30 else R,
                  R.astype(R.dtype.newbyteorder())):
        for name in ("SO3_log", "quaternion_from_mat3x3", "euler_xyz_from_mat3x3"):
            with pytest.raises(ValueError, match=f"{name}: .*R is no rotation.*nearest_rotation"):
                getattr(place, name)(given)
    with pytest.raises(ValueError, match="SE3_log: R of D is no rotation"):
        place.SE3_log(np.column_stack([R, [1, 2, 3]]))


@pytest.mark.parametrize("R", ROTATIONS.values(), ids=ROTATIONS)
@pytest.mark.parametrize("place", (coscrew, _dispatch), ids=("compiled", "dispatch"))
def test_rotations_to_three_digits_are_accepted(R: np.ndarray, place):
    with np.errstate(all="ignore"):
        assert np.isnan(place.SO3_log(R)).all() == np.isnan(R).all()
        place.SE3_log(np.column_stack([R, [1, 2, 3]]))


def test_the_element_is_named_and_nothing_is_written():
    R = np.stack([I3] * 6).reshape(2, 3, 3, 3)
    R[1, 2] *= -1
    out = np.full((2, 3, 3), 7.0)
    with pytest.raises(ValueError, match=r"SO3_log: element \(1, 2\) of R is no rotation"):
        coscrew.SO3_log(R, out=out)
    assert (out == 7).all()
    assert coscrew.SO3_log(R[:0]).shape == (0, 3, 3)


@pytest.mark.parametrize("place", PLACES.values(), ids=lambda x: x.__name__)
def test_arguments_are_judged_along_the_axes_that_are_named(place):
    mixed, right = (np.stack([I3, D, I3], -1) for D in (np.diag([-1.0, 1, 1]), I3[[1, 2, 0]]))
    first = [(0, 1), *[(0,)] * (1 if place is not coscrew.certified else 2)]
    for unlike in (mixed, mixed.astype(np.float32), mixed.tolist()):
        with pytest.raises(ValueError, match=r"^SO3_log: element \(1,\) of R is no rotation"):
            place.SO3_log(unlike, axes=first)
    result, wanted = (x if isinstance(x, tuple) else (x,) for x in (
        place.SO3_log(right, axes=first), place.SO3_log(right.transpose(2, 0, 1))))
    for a, b in zip(result, wanted, strict=True):
        assert np.array_equal(a.T, b, equal_nan=True)
    for wrong in ([(0, 5), (0,)], [(0, 0), (0,)], [(0,), (0,)], 3):
        with pytest.raises((ValueError, TypeError)):
            place.SO3_log(mixed, axes=wrong)


def test_quaternions_are_judged_along_the_axis_that_is_named():
    q = np.array([[0, 0.6, 0], [0, 0, 0], [0, 0, 0], [1, 0.8, -1]])
    swapped = [(0,), (0,), (0,)]
    assert np.array_equal(coscrew.quaternion_log(q, axes=[(0,), (0,)]).T,
                          coscrew.quaternion_log(q.T))
    assert np.array_equal(coscrew.quaternion_nearest_unit(q, axis=0), q)
    assert np.array_equal(coscrew.rotate_qv(q, np.ones((3, 3)), axes=swapped).T,
                          coscrew.rotate_qv(q.T, np.ones((3, 3))))
    q[:, 1] = 0
    with pytest.raises(ValueError, match=r"element \(1,\) of q is zero"):
        coscrew.quaternion_nearest_unit(q, axis=0)
    with pytest.raises(ValueError, match=r"element \(1,\) of q is no unit quaternion"):
        coscrew.rotate_qv(q, np.ones((3, 3)), axes=swapped)


@pytest.mark.parametrize("name", ("quaternion_log", "mat3x3_from_quaternion", "rotate_qv",
                                  "axis_angle_from_quaternion", "quaternion_nearest_unit"))
def test_quaternions_without_a_direction(name: str):
    more = [[1, 2, 3]] if name == "rotate_qv" else []
    for zero in (np.zeros(4), [[0, 0, 0, 1], [0, -0.0, 0, 0]], np.zeros((2, 4), np.float32)):
        for place in (coscrew, _dispatch):
            with pytest.raises(ValueError, match=f"{name}: .*q is (zero|no unit quaternion)"):
                getattr(place, name)(zero, *more)


def test_products_of_matrices_and_of_quaternions_take_any():
    """They are algebra: velocities' matrices and rates of quaternions are none."""
    assert np.array_equal(coscrew.product_drv(coscrew.skew([1, 2, 3]), [4, 5, 6]), [-3, 6, -3])
    assert coscrew.mat3x3_determinant(2 * I3) == 8
    assert not coscrew.quaternion_product_qq(np.zeros(4), [0, 0, 0, 1]).any()


def test_twins_refuse_nothing():
    for precision in PRECISIONS:
        assert not np.isnan(getattr(coscrew, precision.name).SO3_log(np.diag([-1, 1, 1]))).any()


@pytest.mark.parametrize("package", (coscrew, coscrew.accurate, coscrew.certified))
def test_unchecked_functions_are_their_own_and_others_are_refused(package):
    for name in ("SO3_log", "SE3_log"):
        one = coscrew.unchecked(getattr(package, name))
        assert coscrew.unchecked(one) is one
    for given in (3, "SO3_log", None, np.add, len):
        with pytest.raises(ValueError, match="unchecked: got .*; wanted a function of coscrew"):
            coscrew.unchecked(given)
