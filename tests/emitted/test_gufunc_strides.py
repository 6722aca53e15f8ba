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
from coscrew_codegen.program.ops import Op
from tests.support.compiled.c_harness import COMPILERS, INCLUDE, run

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


FOLDER = Path(__file__).parents[2] / "generated" / "gufunc"
each_tier = pytest.mark.parametrize("tier", ["", "accurate", "certified"])


@each_tier
def test_loops_of_any_strides_are_compiled_for_avx2_only_where_the_kernel_takes_fma(tier: str):
    """Without, they take as long, and a quarter of the time of compiling."""
    source = (FOLDER / tier / "vec3.c").read_text()
    header = (INCLUDE / "ksl" / f"{'_'.join(filter(None, ('vec3', tier)))}.h").read_text()
    functions = re.split(r"^static inline ", header, flags=re.MULTILINE)[1:]
    bodies = {re.search(r"ksl_\w+(?=\()", text)[0]: text for text in functions}
    loops = re.findall(r"^OVER\((\w+)\) \{.*?(ksl_\w+)\(", source, re.MULTILINE | re.DOTALL)
    fused = {loop for loop, kernel in loops
             if re.search(r"ksl_product_(error|rest)f?\(", bodies[kernel])}
    include = ("-I", np.get_include(), "-I", sysconfig.get_paths()["include"])
    for flags, wanted in (((), {loop for loop, _ in loops}), (("-DCOSCREW_FOR_AVX2",), fused)):
        text = run((COMPILERS[0], "-E", "-P", *flags, *include, FOLDER / tier / "vec3.c"))
        assert {*re.findall(r"(\w+)_strided\([^;{}]*\) \{", text)} == wanted
    assert len(loops) > 20 and bool(fused) == bool(tier)


@each_tier
def test_loops_of_many_operations_are_compiled_for_any_strides_alone(tier: str):
    """By the counts in the docstrings of double precision: 200 operations, or 1000 where an input
    may be the same for all elements."""
    text = "".join(x.read_text() for x in sorted((FOLDER / tier).glob("*.c")))
    ways = dict(re.findall(r"^LOOP(?:_ON_VECTORS)?\((\w+)_double, \d+, (\w+),", text, re.MULTILINE))
    package = importlib.import_module(".".join(filter(None, ("coscrew", tier))))
    kinds = "|".join(op.value for op in Op)
    for op in [x for x in OPERATIONS if x.name in ways]:
        words = " ".join(getattr(package, op.name).__doc__.split())
        total = sum(map(int, re.findall(rf"(\d+) (?:{kinds})[,.]", words)))
        several = len(op.inputs) > 1 and op.inputs[0] not in op.outputs
        assert (ways[op.name] == "ANY") == (total >= (1000 if several else 200)), op.name
    assert [*ways.values()].count("ANY") > 5
