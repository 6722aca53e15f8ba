"""Gufuncs of arrays with any strides: the bits of C-ordered copies."""

import importlib
import re
import sysconfig
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import coscrew
from coscrew_codegen.accuracy.tiers import TIERS
from coscrew_codegen.algebra.operations import OPERATIONS, Operation
from tests.support.compiled.c_harness import COMPILERS, run

LAYOUTS: dict[str, Callable[[np.ndarray], np.ndarray]] = {
    "every second element": lambda x: x.repeat(2, axis=0)[::2],
    "reversed": lambda x: x[::-1].copy()[::-1],
    "components of other arrays": lambda x: np.stack([x, x + 1], axis=-1)[..., 0],
    "components in Fortran's order": np.asfortranarray,
    "transposed": lambda x: x.swapaxes(-1, -2).copy().swapaxes(-1, -2) if x.ndim > 2 else x,
    "elements in other rows": lambda x: np.stack([x, x], axis=1)[:, 0]}


def sampled(operation: Operation, count: int, kind: type) -> list[np.ndarray]:
    random = np.random.default_rng(count)
    return [random.normal(size=(count, *a.quantity.shape)).astype(kind) for a in operation.inputs]


def results(function: Callable, *inputs: np.ndarray, **out: object) -> list[np.ndarray]:
    with np.errstate(all="ignore"):
        result = coscrew.unchecked(function)(*inputs, **out)
    return list(result) if isinstance(result, tuple) else [result]


def bits(arrays: list[np.ndarray]) -> list[bytes]:
    return [np.where(np.isnan(x), np.nan, x).tobytes() for x in arrays]


@pytest.mark.parametrize("kind", (np.float64, np.float32))
@pytest.mark.parametrize("tier", [tier.package for tier in TIERS])
@pytest.mark.parametrize("layout", LAYOUTS)
def test_arrays_of_any_strides_give_the_bits_of_dense_ones(layout, tier, kind):
    """Inputs and outputs, all at once and one at a time."""
    package, laid = importlib.import_module(tier), LAYOUTS[layout]
    for operation in OPERATIONS:
        function = getattr(package, operation.name, None)
        for count in (1, 2, 500) if function else ():
            inputs = sampled(operation, count, kind)
            dense = results(function, *inputs)
            wanted = bits(dense)
            assert bits(results(function, *map(laid, inputs))) == wanted, operation.name
            for n in range(len(inputs)):
                mixed = [laid(x) if k == n else x for k, x in enumerate(inputs)]
                assert bits(results(function, *mixed)) == wanted, (operation.name, n)
            out = tuple(laid(np.zeros_like(x)) for x in dense)
            results(function, *inputs, out=out if len(out) > 1 else out[0])
            assert bits(list(out)) == wanted, operation.name


@pytest.mark.parametrize("kind", (np.float64, np.float32))
@pytest.mark.parametrize("tier", [tier.package for tier in TIERS])
def test_an_operand_for_all_elements_gives_the_bits_of_its_copies(tier, kind):
    """Any of the operands, and several; in any order of components."""
    package = importlib.import_module(tier)
    for operation in OPERATIONS:
        function, count = getattr(package, operation.name, None), len(operation.inputs)
        inputs = sampled(operation, 301, kind)
        for single in range(1, 2**count - 1) if function else ():
            ones = [x[:1].copy() if single >> k & 1 else x for k, x in enumerate(inputs)]
            wanted = bits(results(function, *(np.repeat(x, 301, axis=0) if len(x) == 1 else x
                                              for x in ones)))
            for order in "CF":
                given = [np.array(x[0], order=order) if len(x) == 1 else x for x in ones]
                assert bits(results(function, *given)) == wanted, (operation.name, single, order)


@pytest.mark.parametrize("step", (1, 2, -1))
def test_an_output_may_be_an_input(step):
    """Element by element, in its own strides too."""
    a, b = (np.random.default_rng(k).normal(size=(800, 6)) for k in (1, 2))
    wanted = coscrew.add_ss(a[::step], b[::step])
    held = a.copy()
    view = held[::step]
    coscrew.add_ss(view, b[::step], out=view)
    assert view.tobytes() == wanted.tobytes()
    assert step != 2 or held[1::2].tobytes() == a[1::2].tobytes()


def test_no_element_is_computed_of_none():
    for x in (np.zeros((0, 6)), np.zeros((0, 12))[:, ::2], np.zeros((6, 0)).T):
        assert coscrew.add_ss(x, x).shape == (0, 6)


@pytest.mark.parametrize("tier", ["", "accurate", "certified"])
def test_loops_of_any_strides_are_compiled_for_avx2_only_where_it_has_fma(tier: str):
    """Without, they take as long, and a quarter of the time of compiling."""
    folder = Path(__file__).parents[2] / "generated" / "gufunc" / tier
    source, shared = ((folder / name).read_text() for name in ("vec3.c", "_gufunc.h"))
    loops = len(re.findall(r"^LOOP(?:_ON_VECTORS)?\(", source, re.MULTILINE))
    include = ("-I", np.get_include(), "-I", sysconfig.get_paths()["include"])
    for flags, count in (((), loops), (
            ("-DCOSCREW_FOR_AVX2",), loops if "WITH_FMA 1" in shared else 0)):
        text = run((COMPILERS[0], "-E", "-P", *flags, *include, folder / "vec3.c"))
        assert len(re.findall(r"_strided\([^;{}]*\) \{", text)) == count
    assert loops > 20
