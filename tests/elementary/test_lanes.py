"""Sines and cosines of several angles at once have the bits of one alone, under every compiler and
flag."""

import ctypes
from pathlib import Path

import numpy as np
import pytest

from coscrew_codegen.elementary import sincos
from coscrew_codegen.formats import PRECISIONS, Precision
from coscrew_codegen.mechanics import derive
from coscrew_codegen.scene.model import HERE, Kind
from coscrew_codegen.targets import scene_c
from tests.support.compiled.c_harness import DIALECTS, run
from tests.support.compiled.flags import FMA
from tests.support.each import each_precision
from tests.support.scenes.generated_scenes import BANNER
from tests.support.scenes.mechanisms import Y, chain, inertia, scene
from tests.support.truth.elementary import Array, results, same, worst_cases

FLAGS = (("-O0",), ("-O2",), ("-O3", *FMA, "-ffp-contract=fast"))
COUNTS = (2, 3, 4)


def scene_of(joints: int) -> dict[str, str]:
    """The C of a chain of so many revolute joints."""
    link = Kind.REVOLUTE, Y, HERE, inertia(1, (1, 0, 0), (1, 1, 1, 0, 0, 0))
    model = chain(*[link] * joints, name=f"chain{joints}")
    return dict(scene_c.files(derive(scene(model, functions=("gravity_torques",))), BANNER))


def loop(count: int, precision: Precision) -> str:
    """C that calls the function for `count` angles on every row."""
    real, f = precision.c_type, precision.suffix
    given = ", ".join(f"x[{count} * i + {n}]" for n in range(count))
    return (f"void run_{count}{f}(long rows, const {real} *x, {real} *s, {real} *c) {{\n"
            f"  for (long i = 0; i < rows; i++) {{\n    {real} sines[4], cosines[4];\n"
            f"    ksl_sincos_{count}{f}({given}, sines, cosines);\n"
            f"    memcpy(s + {count} * i, sines, {count} * sizeof *s);\n"
            f"    memcpy(c + {count} * i, cosines, {count} * sizeof *c);\n  }}\n}}")


@pytest.fixture(scope="module", params=[(*dialect, flags) for dialect in DIALECTS
                                        for flags in FLAGS],
                ids=lambda x: " ".join((x[0], *x[1], *x[2])))
def library(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory):
    compiler, language, flags = request.param
    folder: Path = tmp_path_factory.mktemp("lanes")
    for joints in (6, 7):  # 4 + 2, 4 + 3
        for path, text in scene_of(joints).items():
            (folder / path).write_text(text)
    loops = "\n".join(loop(n, p) for p in PRECISIONS for n in COUNTS)
    (folder / "loops.c").write_text(
        f'#include "chain6.c"\n#include "chain7.c"\n#ifdef __cplusplus\nextern "C" {{\n#endif\n'
        f"{loops}\n#ifdef __cplusplus\n}}\n#endif\n")
    run((compiler, *language, *flags, "-shared", "-fPIC", folder / "loops.c", "-o",
         folder / "loops.so", "-lm"))
    return ctypes.CDLL(str(folder / "loops.so"))


def angles(precision: Precision) -> Array:
    """Ordinary ones; some beyond the limit, infinite or NaN, in every place of four."""
    rng, one = np.random.default_rng(8), np.dtype(precision.numpy_type).type
    ordinary = rng.uniform(-10, 10, 12000).astype(one)
    some = rng.random(12000) < 0.2
    special = np.array([0, -0.0, np.inf, -np.inf, np.nan, 1e30, -1e9, 6588396, 1607,
                        *worst_cases("sincos", precision)[0]], one)
    ordinary[some] = rng.choice(special, some.sum())
    bits = rng.integers(0, 2**(8 * precision.bytes), 12000, dtype=f"u{precision.bytes}")
    return np.concatenate([ordinary, bits.view(one)])


@each_precision
@pytest.mark.parametrize("count", COUNTS)
def test_bits_are_those_of_one_angle(library: ctypes.CDLL, precision: Precision, count: int):
    x = angles(precision)
    found = [np.empty_like(x) for _ in "sc"]
    getattr(library, f"run_{count}{precision.suffix}")(
        ctypes.c_long(len(x) // count), *(y.ctypes.data_as(ctypes.c_void_p) for y in (x, *found)))
    for got, wanted in zip(found, results(sincos.FUNCTION, precision, x), strict=True):
        assert same(got, wanted)
