"""C under every compiler and flag, generated Python and interpreted Programs agree to the bit."""

import ctypes
from importlib import import_module
from pathlib import Path

import numpy as np
import pytest

from coscrew_codegen.program.elementary import ELEMENTARY, ERRORS, Elementary
from coscrew_codegen.program.values.formats import PRECISIONS, Precision
from tests.support.compiled.c_harness import DIALECTS, INCLUDE, run
from tests.support.compiled.flags import FMA
from tests.support.each import each_precision
from tests.support.truth.elementary import Array, results, same

FUNCTIONS = (*ELEMENTARY, *ERRORS)
FLAGS = (("-O0",), ("-O3", *FMA, "-ffp-contract=fast"))


def arguments(function: Elementary, precision: Precision) -> list[Array]:
    """Ordinary numbers, any bits, next to multiples of π/2, and all pairs of special values."""
    rng, one = np.random.default_rng(6), np.dtype(precision.numpy_type).type
    if function in ERRORS:
        plain = next(x for x in ELEMENTARY if function.name == f"{x.name}_error")
        given = arguments(plain, precision)
        return [*given, *results(plain, precision, *given)]
    special = np.array([0, np.inf, np.nan, 1, *(float(precision.limit(name)) for name in (
        "smallest_subnormal", "smallest_normal", "max"))])
    every = np.meshgrid(*[np.concatenate([special, -special])] * len(function.inputs))
    outcomes = []
    for values in every:
        right = np.round(rng.uniform(-2.0**precision.digits, 2.0**precision.digits, 3000))
        bits = rng.integers(0, 2**(8 * precision.bytes), 9000, dtype=f"u{precision.bytes}")
        ordinary = np.concatenate([rng.uniform(-10, 10, 9000), right * np.pi / 2, values.ravel()])
        outcomes.append(np.concatenate([ordinary.astype(one), bits.view(one)]))
    return outcomes


def loop(function: Elementary, precision: Precision) -> str:
    """C that calls the function on every row."""
    kind, f = precision.c_type, precision.suffix
    names = [a.name for a in (*function.inputs, *function.outputs)]
    first, *others = (a.name for a in function.outputs)
    given = ", ".join([*(f"{a.name}[i]" for a in function.inputs), *(f"{x} + i" for x in others)])
    pointers = ", ".join(f"{kind} *{name}" for name in names)
    called = f"ksl_{function.name}{f}({given})"
    return (f"void run_{function.name}{f}(long n, {pointers}) {{\n"
            f"  for (long i = 0; i < n; i++) {{ {first}[i] = {called}; }}\n}}")


@pytest.fixture(scope="module", params=[(*dialect, flags) for dialect in DIALECTS
                                        for flags in FLAGS],
                ids=lambda x: " ".join((x[0], *x[1], *x[2])))
def library(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory):
    compiler, language, flags = request.param
    folder: Path = tmp_path_factory.mktemp("elementary")
    loops = "\n".join(loop(x, precision) for precision in PRECISIONS for x in FUNCTIONS)
    (folder / "loops.c").write_text(
        '#include "ksl/ksl_elementary_error.h"\n'
        f'#ifdef __cplusplus\nextern "C" {{\n#endif\n{loops}\n'
        "#ifdef __cplusplus\n}\n#endif\n")
    run((compiler, *language, *flags, "-shared", "-fPIC", "-I", INCLUDE, folder / "loops.c", "-o",
         folder / "loops.so", "-lm"))
    return ctypes.CDLL(str(folder / "loops.so"))


@each_precision
@pytest.mark.parametrize("function", FUNCTIONS, ids=lambda x: x.name)
def test_c(function: Elementary, precision: Precision, library: ctypes.CDLL):
    given = arguments(function, precision)
    values = [np.empty_like(given[0]) for _ in function.outputs]
    getattr(library, "run_" + function.name + precision.suffix)(
        ctypes.c_long(len(given[0])), *(x.ctypes.data_as(ctypes.c_void_p)
                                        for x in (*given, *values)))
    for got, wanted in zip(values, results(function, precision, *given), strict=True):
        assert same(got, wanted)


@each_precision
@pytest.mark.parametrize("function", FUNCTIONS, ids=lambda x: x.name)
def test_generated_python(function: Elementary, precision: Precision):
    given = arguments(function, precision)
    module = import_module(f"coscrew._elementary_{precision.name}")
    result = getattr(module, function.name)(*given)
    for got, wanted in zip(result if len(function.outputs) > 1 else [result],
                           results(function, precision, *given), strict=True):
        assert same(got, wanted)
