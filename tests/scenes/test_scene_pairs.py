"""The pairs tier: single precision by pairs of floats, for processors without double.

Its digits are those promised, against a Newton-Euler method of the tests' own in 60 digits; its
bits are the same in C and NumPy, and on a Cortex-M4F, where it calls no function of double.
"""

import importlib
import re
import sys
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from coscrew_codegen.accuracy.scene_tiers import NoFunctionsError, in_tier
from coscrew_codegen.accuracy.tiers import tier_named
from coscrew_codegen.backends import emit
from coscrew_codegen.backends.output_files import scene_files
from coscrew_codegen.program.scene_functions import SceneFunctions
from coscrew_codegen.program.values.formats import SINGLE
from coscrew_codegen.reports.cost.needs.cortex_m4 import built, counted
from coscrew_codegen.runtime import callables, compilation, source_text
from coscrew_codegen.runtime.load import kernels_for
from coscrew_codegen.scene.scene import Scene
from tests.support.compiled.c_harness import C11, COMPILERS, STRICT, run
from tests.support.compiled.flags import HASWELL
from tests.support.scenes import mechanisms as m
from tests.support.scenes.arms import arm, inverse, motions
from tests.support.scenes.generated_scenes import CASES
from tests.support.scenes.scene_values import same_bits
from tests.support.scenes.tiers import Result, components, states
from tests.support.truth.condition import conditions

PAIRS = tier_named("pairs")
PROMISED = ((1e4, 0.51), (1e6, 1.0))
"""Conditions, and the error below each in units of the last digit."""

CHECKS = callables.checks(source_text.checks())


def test_inverse_dynamics_is_that_of_newton_and_euler():
    model = arm()
    kernels = kernels_for(Scene("arm", model, (m.gravity(),), functions=("inverse_dynamics",),
                                tiers=("pairs",)))
    given = motions(60, SINGLE)
    columns = [given[:, k] for k in range(3)]
    result = kernels.pairs.single.inverse_dynamics(*columns)
    program = kernels.functions.named("inverse_dynamics").program
    size = conditions(program, components(program, columns))
    judged = [Result(j, result[k, j], true, float(size[j][k])) for k in range(60)
              for j, true in enumerate(inverse(model, *given[k]))]
    for condition, most in PROMISED:
        assert not [x for x in judged if x.condition < condition and x.ulps(SINGLE) > most]
    assert max(x.condition for x in judged) > 1e3


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Iterator[tuple[Path, SceneFunctions]]:
    """A pendulum that calls every function there is: its C and its package, in the tier."""
    scene = replace(CASES["pendulum"](), tiers=("pairs", "accurate"))
    path = tmp_path_factory.mktemp("pairs")
    emit.write(scene_files(scene), path)
    sys.path.insert(0, str(path))
    yield path, scene
    sys.path.remove(str(path))


BUILDS = tuple((name, flags) for name in COMPILERS for flags in (
    ("-O1",), ("-O3", "-march=native", "-ffp-contract=fast"), ("-O2", *HASWELL, "-DKSL_HAS_FMAF=0"))
)


@pytest.mark.parametrize("compiler, flags", BUILDS, ids=[" ".join((x, *y)) for x, y in BUILDS])
def test_bits_are_the_same_in_c_and_numpy(folder, compiler: str, flags: tuple[str, ...],
                                          tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    path, scene = folder
    made = in_tier(scene, PAIRS)
    run([compiler, *C11, *STRICT, *flags, "-c", path / f"{made.stem}f.c", "-o", tmp_path / "x.o"])
    using = compilation.Compiler((compiler,), compiler, ("-fPIC", *flags))
    text = source_text.of_one(made)
    library = compilation.library(text.units(("single",)), text.files, using)
    result = text.interface
    twins = importlib.import_module(f"{scene.name}.pairs.single")
    for described in result.signatures:
        given = states(scene, scene.named(described.name), 200, SINGLE)
        given = [np.concatenate([x, x * np.float32(1e6), x * np.float32(1e-6)]) for x in given]
        call = callables.compiled(result, library.opened, CHECKS, described, SINGLE)
        assert same_bits(call(None, *given), getattr(twins, described.name)(*given))


def test_a_cortex_m4f_has_the_same_bits_and_calls_no_double(folder):
    """Pairs take a fraction of the instructions of double precision in software."""
    path, scene = folder
    took: dict[str, int] = {}
    f = scene.named("forward_dynamics")
    given = states(scene, f, 1, SINGLE)
    for tier in ("pairs", "accurate"):
        stem = f"{scene.name}_{tier}"
        name = f"{scene.name}_{f.name}_{tier}f"
        objects = built(path, stem, SINGLE)
        took[tier], there = counted(objects, stem, f, name, [x[0] for x in given], SINGLE)
        twins = importlib.import_module(f"{scene.name}.{tier}.single")
        assert same_bits(there, np.ravel(getattr(twins, f.name)(*given)))
        needed = re.findall(r" U (\w+)", run(("arm-none-eabi-nm", objects)))
        assert bool(set(needed) - {"sqrtf", "fmaf", "memcpy"}) == (tier == "accurate"), needed
    assert 3 * took["pairs"] < took["accurate"]


def test_double_precision_has_no_such_tier():
    scene = replace(CASES["pendulum"](), precisions=("double",))
    with pytest.raises(NoFunctionsError, match="the pairs tier is of single precision, the scene "
                                               "of double"):
        in_tier(scene, PAIRS)
