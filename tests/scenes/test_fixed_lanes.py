"""Fixed point of many states, in lanes: the bits of NumPy's integers, with every width, for any
number of states, gaps between rows, shared rows and outputs in place of inputs."""

import ctypes
import re
import subprocess
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from coscrew_codegen.accuracy.fixed_scene import FixedFunction, FixedScene, in_fixed
from coscrew_codegen.accuracy.tiers import tier_named
from coscrew_codegen.backends.fixed import scene_c_fixed, scene_c_fixed_many
from coscrew_codegen.dynamics import derive
from coscrew_codegen.program.fixed.fixed_program import Products
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from tests.support.compiled.c_harness import COMPILERS, STRICT, run
from tests.support.compiled.cross import COMPILERS as CROSS
from tests.support.compiled.cross import needed
from tests.support.compiled.flags import X86
from tests.support.scenes import fixed_point as fx

GIMBAL = Path(__file__).parents[2] / "examples/fixed_point/gimbal.toml"
NAMES = ("inverse_dynamics", "mass_matrix", "energy", "body_poses")
COUNTS = (0, 1, 3, 4, 5, 8, 15, 16, 17, 33, 70)
GAP = 3  # integers between rows
each_products = pytest.mark.parametrize("products", Products, ids=lambda x: x.value)
BUILDS = [(COMPILERS[0], ("-O1", "-march=native")), (COMPILERS[-1], ("-O1", "-march=native"))]
if X86:
    BUILDS += [(COMPILERS[0], ("-O1", "-mavx2")), (COMPILERS[-1], ("-O1", "-mavx2")),
               (COMPILERS[0], ("-O1", "-mavx")), (COMPILERS[-1], ("-O1",)),
               (COMPILERS[0], ("-O1", "-msse4.1"))]
"""This processor; lanes of 32 bytes, with and without products of integers; of 16 bytes."""
SANITIZED = ("-fsanitize=undefined", "-fsanitize-undefined-trap-on-error")
by_build = pytest.mark.parametrize("compiler, flags", BUILDS, ids=lambda x: "".join(x))


@pytest.fixture(scope="module")
def gimbal() -> FixedScene:
    return in_fixed(derive(read_scene(GIMBAL), NAMES), tier_named("fixed"))


@pytest.fixture(scope="module")
def panda(tmp_path_factory: pytest.TempPathFactory) -> FixedScene:
    scene = fx.panda(tmp_path_factory.mktemp("panda"))
    return in_fixed(derive(scene, ("inverse_dynamics",)), tier_named("fixed"))


def library(made: FixedScene, folder: Path, compiler: str, flags: Sequence[str]) -> ctypes.CDLL:
    """The functions of many states, with those of one that they call without lanes."""
    fx.written(made, folder)
    for path, text in scene_c_fixed_many.files(made, "for a test").items():
        (folder / path).write_text(text)
    sources = [folder / f"{made.stem}{mark}{many}.c" for mark in fx.MARKS.values()
               for many in ("", "_many")]
    run((compiler, "-std=c11", *STRICT, *flags, "-shared", "-fPIC", *sources, "-o",
         folder / "many.so"))
    return ctypes.CDLL(str(folder / "many.so"))


def rows(parts: Sequence[np.ndarray], count: int, gap: int) -> np.ndarray:
    """Arguments of so many states, with gaps between rows."""
    made = np.full((count, len(parts) + gap), -1, np.int32)
    made[:, :len(parts)] = np.stack(parts, -1)[:count]
    return made


def called(opened: ctypes.CDLL, made: FixedScene, function: FixedFunction, products: Products,
           given: Sequence[np.ndarray], results: Sequence[np.ndarray], count: int,
           shared: int | None = None) -> None:
    """Calls the function of `count` states; the argument numbered `shared` has one row."""
    passed = [x for n, a in enumerate((*given, *results)) for x in (
        a.ctypes.data_as(ctypes.c_void_p), ctypes.c_ssize_t(0 if n == shared else a.shape[1]))]
    name = f"{scene_c_fixed.c_name(made, function, products)}_many"
    getattr(opened, name)(ctypes.c_ssize_t(count), *passed)


def differences(opened: ctypes.CDLL, made: FixedScene, function: FixedFunction,
                products: Products) -> int:
    """Checks all numbers of states, gaps and a shared row; returns how many integers were
    compared."""
    states, compared = fx.states(function, max(COUNTS)), 0
    sizes = [a.quantity.size for a in function.plain.program.outputs]
    for count in COUNTS:
        for gap, shared in ((0, None), (GAP, None), (GAP, 0)):
            given = [rows(parts, count, gap) for parts in states]
            taken = [[np.broadcast_to(x[0], x.shape) for x in parts] if n == shared else parts
                     for n, parts in enumerate(states)]
            results = [np.full((count, size + gap), 7, np.int32) for size in sizes]
            if not count and shared is not None:
                continue
            called(opened, made, function, products, given, results, count, shared)
            true = fx.results(function.programs[products], taken)[:, :count].T
            assert (np.hstack([x[:, :size] for x, size in zip(results, sizes, strict=True)])
                    == true).all(), (count, gap, shared)
            assert all((x[:, size:] == 7).all() for x, size in zip(results, sizes, strict=True))
            compared += true.size
    return compared


@pytest.mark.parametrize("compiler, flags", (
    BUILDS[0], (COMPILERS[-1], ("-O1", "-DKSL_LANE_BYTES=16", *SANITIZED)),
    (COMPILERS[0], ("-O1", "-DKSL_LANE_BYTES=0"))), ids=lambda x: "".join(x))
def test_bits_are_those_of_numpy(gimbal, compiler, flags, tmp_path):
    opened = library(gimbal, tmp_path, compiler, flags)
    assert len(gimbal.functions) == len(NAMES)
    for function in gimbal.functions:
        for products in Products:
            assert differences(opened, gimbal, function, products) > 500


@by_build
def test_bits_of_an_arm(panda, compiler, flags, tmp_path):
    (function,) = panda.functions
    opened = library(panda, tmp_path, compiler, flags)
    for products in Products:
        assert differences(opened, panda, function, products) > 2000


@each_products
def test_outputs_may_be_inputs(panda, products, tmp_path):
    (function,) = panda.functions
    opened = library(panda, tmp_path, COMPILERS[0], ("-O1", "-march=native"))
    states = fx.states(function, 70)
    given = [rows(parts, 70, 0) for parts in states]
    called(opened, panda, function, products, given, given[2:], 70)
    assert (fx.results(function.programs[products], states) == given[2].T).all()


SHIFTS = (0, 1, 5, 31, 32, 33, 40, 62)


@by_build
def test_products_and_shifts_of_all_sizes(gimbal, compiler, flags, tmp_path):
    """Products of the largest integers, which no function of a robot has: each shift of 64 bits to
    the right, and to 32 bits."""
    fx.written(gimbal, tmp_path)
    for path, text in scene_c_fixed_many.files(gimbal, "for a test").items():
        (tmp_path / path).write_text(text)
    cases = "".join(
        f"""
void narrowed_{s}(const int32_t *a, const int32_t *b, int32_t *r);
void narrowed_{s}(const int32_t *a, const int32_t *b, int32_t *r) {{
  ksl_states_fixed x, y, z;
  memcpy(&x, a, sizeof x); memcpy(&y, b, sizeof y);
  z = ksl_narrowed_lanes(ksl_wide_product_lanes(x, y, {-min(s, 8)}), {s - min(s, 8)});
  memcpy(r, &z, sizeof z);
}}""" for s in SHIFTS)
    (tmp_path / "shifts.c").write_text(
        f'#include "{gimbal.stem}_many.c"\nint lanes(void);\n'
        f"int lanes(void) {{ return KSL_LANES_FIXED; }}\n{cases}\n")
    run((compiler, "-std=c11", *STRICT, *flags, "-shared", "-fPIC", tmp_path / "shifts.c",
         tmp_path / f"{gimbal.stem}.c", "-o", tmp_path / "shifts.so"))
    opened = ctypes.CDLL(str(tmp_path / "shifts.so"))
    lanes, draw = opened.lanes(), np.random.default_rng(5)
    ends = np.array([-2**31 + 1, 2**31 - 1, -1, 1, 0, 12345])
    for s in SHIFTS:
        for _ in range(20):
            a, b = (np.where(draw.random(lanes) < 0.5, draw.choice(ends, lanes),
                             draw.integers(-2**31 + 1, 2**31, lanes)) for _ in range(2))
            first, rest = min(s, 8), s - min(s, 8)
            wide = (a * b) >> first
            true = (wide + (1 << rest >> 1)) >> rest
            whole = np.abs(true) < 2**31
            given = [x.astype(np.int32) for x in (a, b)]
            result = np.zeros(lanes, np.int32)
            getattr(opened, f"narrowed_{s}")(*(x.ctypes.data_as(ctypes.c_void_p)
                                               for x in (*given, result)))
            assert (result == true)[whole].all(), s


@each_products
def test_lanes_of_aarch64(gimbal, products, tmp_path):
    compiler = CROSS["aarch64"]
    needed(compiler, "qemu-aarch64")
    function, count = gimbal.functions[0], 21
    states = fx.states(function, count)
    fx.written(gimbal, tmp_path)
    for path, text in scene_c_fixed_many.files(gimbal, "for a test").items():
        (tmp_path / path).write_text(text)
    name = f"{scene_c_fixed.c_name(gimbal, function, products)}_many"
    (tmp_path / "main.c").write_text(f"""#include <stdio.h>
#include "{gimbal.stem}_many.h"
static int32_t given[3][{count} * 3], made[{count} * 3];
int main(void) {{
  if (fread(given, sizeof given, 1, stdin) != 1) return 2;
  {name}({count}, given[0], 3, given[1], 3, given[2], 3, made, 3);
  return fwrite(made, sizeof made, 1, stdout) != 1;
}}
""")
    mark = fx.MARKS[products]
    run((compiler, "-std=c11", "-O1", *STRICT, "-static", tmp_path / "main.c",
         *(tmp_path / f"{gimbal.stem}{mark}{many}.c" for many in ("", "_many")), "-o",
         tmp_path / "main"))
    given = b"".join(rows(parts, count, 0).tobytes() for parts in states)
    done = subprocess.run(["qemu-aarch64", tmp_path / "main"], input=given, capture_output=True)
    result = np.frombuffer(done.stdout, np.int32).reshape(count, 3).T
    assert (result == fx.results(function.programs[products], states)).all()


def test_scenes_without_the_tier_have_no_such_files(tmp_path):
    from coscrew_codegen.backends.output_files import scene_files

    plain = derive(fx.panda(tmp_path, tiers=""), ("energy",))
    fixed = replace(plain, tiers=("fixed",))
    more = scene_files(fixed, many=True).keys() - scene_files(plain, many=True).keys()
    assert {re.sub("^panda/", "", x) for x in more} == {
        "coscrew_fixed.h", "fixed.py", "panda_fixed.c", "panda_fixed.h", "panda_fixed_double.c",
        "panda_fixed_high.c", "panda_fixed_high_many.c", "panda_fixed_many.c",
        "panda_fixed_many.h"}
