"""Sines and cosines of several angles at once, and their errors, have the bits of one alone, under
every compiler and flag; scenes compute them so."""

import ctypes
from pathlib import Path

import numpy as np
import pytest

from coscrew_codegen.accuracy.scene_tiers import tiers_of
from coscrew_codegen.backends.c import c_elementary
from coscrew_codegen.backends.c.c_lanes import SEVERAL
from coscrew_codegen.backends.render import render
from coscrew_codegen.backends.scene import scene_c_parts, scene_c_tier
from coscrew_codegen.dynamics import derive
from coscrew_codegen.program.elementary import Elementary, sincos, sincos_error
from coscrew_codegen.program.values.formats import PRECISIONS, Precision
from coscrew_codegen.scene.mechanism.model import HERE
from tests.support.compiled.c_harness import DIALECTS, run
from tests.support.compiled.flags import FMA
from tests.support.each import each_precision
from tests.support.scenes.generated_scenes import BANNER
from tests.support.scenes.kinds import Kind
from tests.support.scenes.mechanisms import Y, Z, chain, inertia, scene
from tests.support.truth.elementary import Array, results, same, worst_cases

FLAGS = (("-O0",), ("-O2",), ("-O3", *FMA, "-ffp-contract=fast"),
         ("-O1", "-U__SSE2__"))  # as where there are no vectors
COUNTS = (2, 3, 4)
FUNCTIONS = (sincos.FUNCTION, sincos_error.ERROR)


def defined(precision: Precision) -> str:
    """The functions, as scenes define them."""
    f = precision.suffix
    names = [name for x in FUNCTIONS for name in (x.name, *SEVERAL[x.name])]
    written = c_elementary.written(precision, names, nested=True)
    return "\n".join((render(f"c/product_error{f}"), f"#define RN(x) KSL_RN{f.upper()}(x)",
                      render("c/elementary", precision=precision, functions=written), "#undef RN"))


def loop(function: Elementary, count: int, precision: Precision) -> str:
    """C that calls the function for `count` angles on every row."""
    real, f = precision.c_type, precision.suffix
    others = [a.name for a in function.inputs[1:]]
    outputs = [a.name for a in function.outputs]
    arrays = [f"{x}_{count}" for x in (*others, *outputs)]
    given = ", ".join((*(f"x[{count} * i + {n}]" for n in range(count)), *arrays))
    declared = (*(f"const {real} *{y}" for y in ("x", *others)), *(f"{real} *{y}" for y in outputs))
    return "\n".join((
        f"void {function.name}_{count}{f}(long rows, {', '.join(declared)}) {{",
        "  for (long i = 0; i < rows; i++) {",
        f"    {real} {', '.join(f'{x}[4]' for x in arrays)};",
        *(f"    memcpy({y}_{count}, {y} + {count} * i, {count} * sizeof *{y});" for y in others),
        f"    ksl_{function.name}_{count}{f}({given});",
        *(f"    memcpy({y} + {count} * i, {y}_{count}, {count} * sizeof *{y});" for y in outputs),
        "  }\n}"))


@pytest.fixture(scope="module", params=[(*dialect, flags) for dialect in DIALECTS
                                        for flags in FLAGS],
                ids=lambda x: " ".join((x[0], *x[1], *x[2])))
def library(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory):
    compiler, language, flags = request.param
    folder: Path = tmp_path_factory.mktemp("lanes")
    loops = [loop(x, n, p) for x in FUNCTIONS for p in PRECISIONS for n in COUNTS]
    (folder / "loops.c").write_text("\n".join((
        "#include <math.h>", "#include <string.h>", render("scene/rounding", products=PRECISIONS),
        render("c/inlining"), *map(defined, PRECISIONS),
        '#ifdef __cplusplus\nextern "C" {\n#endif', *loops, "#ifdef __cplusplus\n}\n#endif\n")))
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
    known = [x]
    for function in FUNCTIONS:
        values = [np.empty_like(x) for _ in function.outputs]
        getattr(library, f"{function.name}_{count}{precision.suffix}")(
            ctypes.c_long(len(x) // count),
            *(y.ctypes.data_as(ctypes.c_void_p) for y in (*known, *values)))
        for got, wanted in zip(values, results(function, precision, *known), strict=True):
            assert same(got, wanted)
        known += values


def test_scenes_compute_several_at_once(monkeypatch: pytest.MonkeyPatch):
    """In a tier, too, and where functions are cut into parts."""
    monkeypatch.setattr(scene_c_parts, "LONG", scene_c_parts.LONGEST)
    links = [(Kind.REVOLUTE, axis, HERE, inertia(1, (1, 0, 0), (1, 1, 1, 0, 0, 0)))
             for axis in (Y, *7 * (Z, Y))]  # the first angle matters to nothing
    made = derive(scene(chain(*links, name="chain15"), tiers=("accurate",)), ("inverse_dynamics",))
    (tier,) = tiers_of(made)
    text = scene_c_tier.files(tier, BANNER)["chain15_accurate.c"]
    assert "part_1_of_inverse_dynamics" in text
    for count in (2, 4):
        assert f"  ksl_sincos_{count}(q" in text
        assert f"  ksl_sincos_error_{count}(q" in text
    assert "ksl_sincos_error(q" not in text
