"""Compares the functions of arrays of PyTorch, and all operations by the array API standard, with
NumPy's, and PyTorch's derivatives with differences.

`python -m tests.arrays_attack [operations] [derivatives] [scene]` prints how many functions were
compared.  PyTorch must be installed.
"""

import sys
from collections.abc import Iterator
from itertools import chain

import array_api_strict
import numpy as np
import torch

import coscrew
from coscrew_codegen.algebra.lowering.programs import program_of
from coscrew_codegen.algebra.operations import OPERATIONS, Operation
from coscrew_codegen.program import Op
from coscrew_codegen.program.values.formats import PRECISIONS, Precision
from coscrew_codegen.reports.kernels.inputs import benign
from coscrew_codegen.runtime.load import Kernels, kernels_of
from tests.support.scenes import scene_bits

ROWS = 20
SMOOTH = ("SO3_exp", "SO3_log", "SE3_exp", "SE3_log", "quaternion_interpolated", "vec3_normalized")


def several(x: object) -> tuple:
    return x if isinstance(x, tuple) else (x,)


def rows_of(operation: Operation, precision: Precision, count: int = ROWS) -> list[np.ndarray]:
    rows = benign(operation, precision, count, 5).astype(precision.numpy_type)
    ends = np.cumsum([a.quantity.size for a in operation.inputs])[:-1]
    return [np.ascontiguousarray(x).reshape(count, *a.quantity.shape) for x, a in zip(
        np.split(rows, ends, axis=1), operation.inputs, strict=True)]


def operations() -> Iterator[str]:
    """All operations have NumPy's bits; but PyTorch's square roots may be an ulp away."""
    for xp in (array_api_strict, torch):
        functions = coscrew.arrays(xp)
        for precision in PRECISIONS:
            for operation in OPERATIONS:
                given = rows_of(operation, precision)
                twin = getattr(getattr(coscrew, precision.name), operation.name)
                result = several(getattr(functions, operation.name)(*map(xp.asarray, given)))
                for a, b in zip(several(twin(*given)), result, strict=True):
                    if xp is array_api_strict or Op.SQRT not in program_of(operation).counts:
                        assert a.tobytes() == np.asarray(b).tobytes(), operation.name
                yield operation.name


def derivatives() -> Iterator[str]:
    """Compares derivatives of operations with PyTorch's own differences, also at the identity."""
    functions = coscrew.arrays(torch)
    for name in SMOOTH:
        operation = next(op for op in OPERATIONS if op.name == name)
        given = [torch.tensor(x, requires_grad=True)
                 for x in rows_of(operation, PRECISIONS[0], 2)]
        checked(getattr(functions, name), *given)
        yield name
    for exp, log, size in (("SO3_exp", "SO3_log", 3), ("SE3_exp", "SE3_log", 6)):
        zero = torch.zeros(size, dtype=torch.float64, requires_grad=True)
        both = [getattr(functions, x) for x in (log, exp)]
        checked(lambda x, both=both: both[0](both[1](x)), zero)
        yield log


def checked(function: object, *given: torch.Tensor) -> None:
    assert torch.autograd.gradcheck(function, given, check_forward_ad=True)
    assert torch.autograd.gradgradcheck(function, given)


def scene() -> Iterator[str]:
    """A scene's functions: bits, derivatives, vmap."""
    kernels: Kernels = kernels_of(scene_bits.functions())
    functions = kernels.arrays(torch)
    rng = np.random.default_rng(5)
    for signature in kernels.interface.signatures:
        if signature.name not in functions:
            continue
        given = [rng.uniform(0.2, 0.9, shape if x in "thp" else (3, *shape))
                 for x, shape in signature.inputs]
        tensors = [torch.tensor(x, requires_grad=True) for x in given]
        function = getattr(functions, signature.name)
        wanted = several(getattr(kernels.double, signature.name)(*given))
        axes = tuple(None if x in "thp" else 0 for x, _ in signature.inputs)
        for result in (function(*tensors), torch.vmap(function, axes)(*tensors)):
            for a, b in zip(wanted, several(result), strict=True):
                assert np.array_equal(a, b.detach().numpy()), signature.name
        if signature.name in ("inverse_dynamics", "energy"):
            checked(function, *tensors)
        yield signature.name


def main(*names: str) -> None:
    parts = {"operations": operations, "derivatives": derivatives, "scene": scene}
    count = sum(1 for _ in chain(*(parts[name]() for name in names or parts)))
    print(count, "functions compared")


if __name__ == "__main__":
    main(*sys.argv[1:])
