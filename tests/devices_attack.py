"""Compares functions of arrays on a GPU, by JAX, PyTorch and CuPy, with NumPy's and with bounds.

`python -m tests.devices_attack [LIBRARY ...]` takes those that are installed and see a GPU, and
prints the largest differences, in u of the largest component of a result.  Where a library rounds
every operation once, as CuPy does, results have NumPy's bits; elementary functions keep their
proved bounds, and nearest rotations theirs, whatever is fused.
"""

import argparse
import sys
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from functools import partial
from importlib import import_module
from typing import Any

import mpmath
import numpy as np
from scipy.spatial.transform import Rotation

import coscrew
from coscrew_codegen.algebra.operations import OPERATIONS, Operation
from coscrew_codegen.algebra.operations.formulas.nearest import BESIDE, NEAREST
from coscrew_codegen.program.elementary import ELEMENTARY, Elementary
from coscrew_codegen.program.values.formats import PRECISIONS, Precision
from coscrew_codegen.reports.kernels.inputs import benign
from coscrew_codegen.runtime.load import Kernels, kernels_of
from tests.support.scenes import scene_bits
from tests.support.truth.nearest import nearest, off_orthonormal

ROWS = 20


@dataclass(frozen=True)
class Device:
    """A library with a GPU: its namespace, the ways to its arrays and back, and its compiler."""

    name: str
    namespace: Any
    to: Callable[[np.ndarray], Any]
    back: Callable[[Any], np.ndarray]
    compiled: Callable[[Callable[..., Any]], Callable[..., Any]]

    def evaluate(self, function: Callable[..., Any], given: Iterable[np.ndarray]
                 ) -> list[np.ndarray]:
        """The function's results, computed on the GPU."""
        results = self.compiled(function)(*map(self.to, given))
        return [self.back(y) for y in (results if isinstance(results, tuple) else (results,))]


def devices(names: Iterable[str]) -> Iterator[Device]:
    for name in names:
        try:
            device = LIBRARIES[name]()
        except ImportError as error:
            print(f"{name}: {error}", file=sys.stderr)
            continue
        if device:
            yield device
        else:
            print(f"{name}: no GPU", file=sys.stderr)


def _jax() -> Device | None:
    jax = import_module("jax")
    jax.config.update("jax_enable_x64", True)
    if jax.default_backend() != "gpu":
        return None
    jnp = import_module("jax.numpy")
    return Device(f"jax {jax.__version__}", jnp, jnp.asarray, np.asarray, jax.jit)


def _torch() -> Device | None:
    torch = import_module("torch")
    if not torch.cuda.is_available():
        return None
    return Device(f"torch {torch.__version__}", torch,
                  lambda x: torch.as_tensor(x, device="cuda"), lambda x: x.cpu().numpy(),
                  lambda function: function)


def _cupy() -> Device | None:
    cupy = import_module("cupy")
    if not cupy.cuda.runtime.getDeviceCount():
        return None
    return Device(f"cupy {cupy.__version__}", cupy, cupy.asarray, cupy.asnumpy,
                  lambda function: function)


LIBRARIES = {"jax": _jax, "torch": _torch, "cupy": _cupy}


def inputs_of(operation: Operation, precision: Precision) -> list[np.ndarray]:
    rows = benign(operation, precision, ROWS, 5).astype(precision.numpy_type)
    ends = np.cumsum([a.quantity.size for a in operation.inputs])[:-1]
    return [np.ascontiguousarray(x).reshape(ROWS, *a.quantity.shape) for x, a in zip(
        np.split(rows, ends, axis=1), operation.inputs, strict=True)]


def differences(wanted: Any, results: list[np.ndarray], precision: Precision) -> float:
    """The largest difference of a row, in u of the row's largest component."""
    largest = 0.0
    for a, b in zip(wanted if isinstance(wanted, tuple) else (wanted,), results, strict=True):
        assert a.shape == b.shape and a.dtype == b.dtype
        if a.tobytes() == b.tobytes():
            continue
        rows, others = (np.asarray(x, float).reshape(len(a), -1) for x in (a, b))
        size = np.maximum(np.abs(rows).max(axis=1), float(precision.smallest_normal))
        largest = max(largest, (np.abs(rows - others).max(axis=1) / size).max()
                      / float(precision.u))
    return largest


def operations(device: Device, precision: Precision) -> str:
    functions, twins = coscrew.arrays(device.namespace), getattr(coscrew, precision.name)
    values = {}
    for operation in OPERATIONS:
        given = inputs_of(operation, precision)
        results = device.evaluate(getattr(functions, operation.name), given)
        values[operation.name] = differences(
            getattr(twins, operation.name)(*given), results, precision)
    return summary("operations", values)


def summary(what: str, got: dict[str, float]) -> str:
    worst = max(got, key=lambda name: got[name])
    same = sum(not x for x in got.values())
    return f"{len(got)} {what}: {same} with NumPy's bits, at most {got[worst]:.3g} u ({worst})"


def elementary(device: Device, precision: Precision) -> str:
    """Their errors in ulps, divided by the proved bounds: at most 1."""
    functions, result = coscrew.arrays(device.namespace), {}
    for function in ELEMENTARY:
        x = numbers(precision)
        given = (x, np.roll(x, 1))[:len(function.inputs)]
        results = device.evaluate(getattr(functions, function.name), given)
        result[function.name] = max(ratios(function, precision, given, results))
    worst = max(result, key=lambda name: result[name])
    assert result[worst] <= 1.01, result
    return f"{len(result)} elementary functions: {result[worst]:.2f} of their bounds ({worst})"


def numbers(precision: Precision) -> np.ndarray:
    """Numbers of every size, zero among them."""
    rng = np.random.default_rng(7)
    most = 300 if precision.digits == 53 else 37
    x = rng.standard_normal(499) * 10.0**rng.uniform(-most, most, 499)
    return np.concatenate([x, rng.uniform(-20, 20, 500), [0.0]]).astype(precision.numpy_type)


def ratios(function: Elementary, precision: Precision, given: tuple[np.ndarray, ...],
           results: list[np.ndarray]) -> Iterator[float]:
    """Errors in ulps divided by the bound, where no intermediate number is subnormal."""
    smallest = float(precision.smallest_normal / precision.u)
    names = ([a.name for a in function.outputs] if function.name == "sincos"
             else [function.name])
    with mpmath.workdps(400 if precision.digits == 53 else 80):
        for name, ys in zip(names, results, strict=True):
            truth = getattr(mpmath, {"s": "sin", "c": "cos"}.get(name, name))
            for *xs, y in zip(*(z.tolist() for z in given), ys, strict=True):
                true = truth(*map(mpmath.mpf, xs))
                if smallest < abs(true) < float(precision.limit("max")):
                    error = abs(mpmath.mpf(float(y)) - true) / float(np.spacing(abs(y)))
                    yield float(error / function.error(precision))
    yield 0.0


def nearest_rotations(device: Device, precision: Precision) -> str:
    """Where singular values coincide every part of a rotation comes from one choice."""
    sides = [Rotation.random(ROWS, random_state=seed).as_matrix() for seed in (1, 2)]
    given = np.concatenate([sides[0] @ np.diag(s) @ sides[1] for s in (
        (1, 1, 1), (1, 1, -0.5), (2, 1, 1), (1, 1, 0.5), (1, 1, 0), (3, 2, 1),
        (1, 1 - 1e-9, -0.5), (1, 1e-4, 1e-4))]).astype(precision.numpy_type)
    function = coscrew.arrays(device.namespace).mat3x3_nearest_rotation
    results, = device.evaluate(function, [given])
    off, far = 0.0, 0.0
    with mpmath.workdps(50):
        u = mpmath.mpf(2)**-precision.digits
        for A, R in zip(given, results, strict=True):
            wanted, gap = nearest(A)
            error = mpmath.mnorm(mpmath.matrix(R.tolist()) - wanted, "f")
            off = max(off, float(off_orthonormal(R) / u) / BESIDE)
            far = max(far, float(error * gap / u) / NEAREST)
    assert max(off, far) <= 1, (off, far)
    return f"nearest rotations: {far:.2f} and orthonormal to {off:.2f} of their bounds"


def scene(device: Device, precision: Precision, kernels: Kernels) -> str:
    """A scene's functions, with an own t and p for all states."""
    functions, result = kernels.arrays(device.namespace), {}
    rng = np.random.default_rng(5)
    for signature in kernels.interface.signatures:
        if signature.name not in functions:
            continue
        given = [rng.uniform(0.2, 0.9, shape if x in "thp" else (ROWS, *shape)).astype(
            precision.numpy_type) for x, shape in signature.inputs]
        wanted = getattr(getattr(kernels, precision.name), signature.name)(*given)
        results = device.evaluate(getattr(functions, signature.name), given)
        result[signature.name] = differences(wanted, results, precision)
    return summary("functions of a scene", result)


def checks(device: Device, kernels: Kernels) -> Iterator[tuple[Precision, Callable[[], str]]]:
    for precision in PRECISIONS:
        for check in (elementary, nearest_rotations, operations):
            yield precision, partial(check, device, precision)
        yield precision, partial(scene, device, precision, kernels)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("libraries", metavar="LIBRARY", nargs="*", choices=LIBRARIES,
                        default=list(LIBRARIES))
    kernels, failures = kernels_of(scene_bits.functions()), 0
    for device in devices(parser.parse_args().libraries):
        for precision, check in checks(device, kernels):
            try:
                line = check()
            except (AssertionError, RuntimeError, TypeError, ValueError) as error:
                failures += 1
                line = f"FAILS: {type(error).__name__}: {error}"
            print(f"{device.name}, {precision.name}: {line}", flush=True)
    return min(failures, 1)


if __name__ == "__main__":
    sys.exit(main())
