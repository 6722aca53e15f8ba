"""C, gufunc and NumPy twin return the same bits: one Program, rounded once an operation everywhere.

The twin, in NumPy's plain arithmetic, is the reference; C is compiled without optimisation and with
as much as the compiler has.  Of NaN only "is NaN" is promised, so any NaN equals any other.
"""

import functools
from collections.abc import Callable
from math import ceil
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

import coscrew
from coscrew_codegen.algebra.operations import OPERATIONS, Operation
from coscrew_codegen.program.values.formats import PRECISIONS, Precision
from tests.support.cases import for_all
from tests.support.compiled.c_harness import COMPILERS, EXACT, call, harness, run
from tests.support.each import each_compiler, each_precision
from tests.support.sampling import inputs_of

OUTPUTS = 50_000  # components compared, at least, per operation, precision and implementation
OPTIMISED = ("-O3", "-march=native")
BUILDS = tuple((name, (*flags, "-fno-unroll-loops", EXACT)) for flags in (("-O0",), OPTIMISED)
               for name in COMPILERS)
"""Unrolling repeats vectorised loops: it takes clang half of its time."""
Arrays = tuple[np.ndarray, ...]
Evaluate = Callable[[Operation, Precision, Arrays], Arrays]

@pytest.fixture(scope="session")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder where the harnesses are compiled, once a session."""
    return tmp_path_factory.mktemp("harness")


def evaluate(folder: Path, implementation: str) -> Evaluate:
    """The implementation of this name, as a function of operation, precision and inputs."""
    if implementation.startswith("gufunc"):
        assert coscrew.COMPILED, "coscrew runs in pure NumPy; a machine with a C compiler must not"
        order = "F" if implementation.endswith("strided") else "C"
        return lambda op, precision, inputs: _outputs(coscrew, op, inputs, order)
    compiler, *flags = implementation.split()
    library = harness(folder, compiler, tuple(flags))
    return lambda op, precision, inputs: call(library, op, precision, inputs)


def twin(operation: Operation, precision: Precision, inputs: Arrays) -> Arrays:
    """The outputs of pure NumPy."""
    return _outputs(getattr(coscrew, precision.name), operation, inputs)


@functools.lru_cache(maxsize=1)
def samples(operation: Operation, precision: Precision) -> tuple[Arrays, Arrays]:
    """Inputs, and the twin's outputs."""
    rows = ceil(OUTPUTS / sum(a.quantity.size for a in operation.outputs))
    inputs = inputs_of(operation, precision, rows)
    return inputs, twin(operation, precision, inputs)


def differ(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """The mask of the places where the bits differ and not both are NaN."""
    assert (a.dtype, a.shape) == (b.dtype, b.shape)
    unsigned = f"u{a.dtype.itemsize}"
    different = a.view(unsigned) != b.view(unsigned)
    return different & ~(np.isnan(a) & np.isnan(b)) if different.any() else different


def mismatch(operation: Operation, inputs: Arrays, got: Arrays, want: Arrays) -> str:
    """The first row where `got` and `want` differ, in hex; empty if there is none."""
    for output, g, w in zip(operation.outputs, got, want, strict=True):
        places = np.argwhere(differ(g, w))
        if len(places):
            row, *component = map(int, places[0])
            given = "".join(f"  {a.name} = {_hex(x[row])}\n"
                            for a, x in zip(operation.inputs, inputs, strict=True))
            return (f"{operation.name}: {len(places)} components of {output.name} differ, first "
                    f"{component} of row {row}\n{given}"
                    f"  got  {_hex(g[row])}\n  want {_hex(w[row])}")
    return ""


def fail_for(text: str) -> None:
    """Fail with this text unless it is empty."""
    if text:
        pytest.fail(text, pytrace=False)


def _hex(x: np.ndarray) -> str:
    return " ".join(float(component).hex() for component in np.ravel(x))


def _outputs(module: ModuleType, operation: Operation, inputs: Arrays, order: str = "C") -> Arrays:
    function = getattr(module, operation.name)
    with np.errstate(all="ignore"):
        outputs = (coscrew.unchecked(function) if module is coscrew else function)(
            *(np.asarray(x, order=order) for x in inputs))
    return outputs if isinstance(outputs, tuple) else (outputs,)


IMPLEMENTATIONS = ("gufunc", "gufunc, strided",
                   *(" ".join((name, *flags)) for name, flags in BUILDS))
everywhere = for_all(precision=PRECISIONS, implementation=IMPLEMENTATIONS)


@pytest.mark.parametrize("operation", OPERATIONS, ids=lambda op: op.name)
@everywhere
def test_bits_equal_those_of_the_twin(operation: Operation, precision: Precision,
                                      implementation: str, folder: Path):
    inputs, want = samples(operation, precision)
    got = evaluate(folder, implementation)(operation, precision, inputs)
    assert sum(g.size for g in got) >= OUTPUTS
    fail_for(mismatch(operation, inputs, got, want))


@each_compiler
@each_precision
def test_contraction_would_be_noticed(precision: Precision, compiler: str, folder: Path):
    """With an FMA, contracted CoAd(D) c has other bits; the headers prevent contraction, unless
    KSL_CONTRACT_OFF says, wrongly here, that clang's flags do."""
    operation = next(op for op in OPERATIONS if op.name == "product_CoAdc")
    inputs, want = samples(operation, precision)
    flags = (*OPTIMISED, "-ffp-contract=fast")
    messages = compiler == "clang" and _has_fma(compiler)
    for message, contracts in (((), False), (("-DKSL_CONTRACT_OFF",), messages)):
        contracting = harness(folder, compiler, ("-std=gnu11", *flags, *message),
                              operations=(operation,))
        got = call(contracting, operation, precision, inputs)
        assert bool(mismatch(operation, inputs, got, want)) == contracts


def _has_fma(compiler: str) -> bool:
    macros = run((compiler, "-march=native", "-dM", "-E", "-x", "c", "/dev/null"))
    return "__FMA__" in macros or "__ARM_FEATURE_FMA" in macros
