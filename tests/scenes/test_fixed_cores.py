"""Fixed point on cores without floating point, under qemu-user: the bits of NumPy's integers, in
few instructions and without a call of the compiler's library."""

from pathlib import Path

import numpy as np
import pytest

from coscrew_codegen.accuracy.fixed_scene import FixedScene, in_fixed
from coscrew_codegen.accuracy.tiers import tier_named
from coscrew_codegen.backends.fixed.c_integers import INTEGERS
from coscrew_codegen.backends.fixed.scene_c_fixed import c_name
from coscrew_codegen.dynamics import derive
from coscrew_codegen.program.fixed.fixed_program import Products
from coscrew_codegen.reports.cost.needs import core_costs, cortex_m4
from coscrew_codegen.reports.cost.needs.core_costs import CORES, on_cores
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from tests.support.compiled.c_harness import run
from tests.support.compiled.cross import needed
from tests.support.scenes import fixed_point as fx

GIMBAL = Path(__file__).parents[2] / "examples/fixed_point/gimbal.toml"
MOST = {("Cortex-M0+", "full"): 19_500, ("Cortex-M0+", "high"): 18_000,
        ("Cortex-M3", "full"): 3_800, ("Cortex-M3", "high"): 3_500,
        ("Cortex-M4F", "full"): 3_700, ("Cortex-M4F", "high"): 2_100}
"""Instructions of a call of the arm's inverse dynamics, sines included; with software's double
230,523, 64,414 and 64,401."""


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> FixedScene:
    scene = fx.panda(tmp_path_factory.mktemp("panda"))
    return in_fixed(derive(scene, ("inverse_dynamics",)), tier_named("fixed"))


@pytest.mark.parametrize("products", Products, ids=lambda x: x.value)
@pytest.mark.parametrize("core", CORES)
def test_cores_have_the_bits_of_numpy_in_few_instructions(made, core, products, tmp_path: Path):
    needed(cortex_m4.COMPILER[0], cortex_m4.EMULATOR)
    fx.written(made, tmp_path)
    (function,) = made.functions
    given = fx.states(function, 16)
    stem = f"{made.stem}{fx.MARKS[products]}"
    built = cortex_m4.built(tmp_path, stem, INTEGERS, CORES[core])
    assert "__aeabi" not in run(("arm-none-eabi-nm", "-u", built))
    true = fx.results(function.programs[products], given)
    for n in (0, 15):
        row = [np.array([x[n] for x in parts], np.int32) for parts in given]
        count, results = cortex_m4.counted(
            built, made.stem, function.plain, c_name(made, function, products), row, INTEGERS,
            CORES[core])
        assert (results == true[:, n]).all()
        assert 0.8 * MOST[core, products.value] < count <= MOST[core, products.value]


def test_cost_shows_formats_on_cores():
    """Bounds over the ranges, and instructions, function by function."""
    costs = on_cores(read_scene(GIMBAL), ("inverse_dynamics", "energy"))
    assert [x.function for x in costs] == ["inverse_dynamics"] * 4 + ["energy"] * 4
    assert [x.format for x in costs[:4]] == ["double", "single", "fixed", "fixed (high)"]
    double, single, full, high = (x.bounds["N m"] for x in costs[:4])
    assert double < full < high < single / 10
    assert all(x.instructions.keys() == CORES.keys() for x in costs)
    by_core = [[x.instructions[core] for x in costs[:4]] for core in CORES]
    assert all(counts[0] > 10 * counts[2] for counts in by_core)
    assert all(counts[1] > 4 * counts[2] for counts in by_core[:2])
    text = core_costs.table(costs).text()
    assert "energy" in text and f"{by_core[0][2]:,}" in text


def test_cost_shows_nothing_of_scenes_without_the_tier(tmp_path):
    assert on_cores(fx.panda(tmp_path, tiers=""), ("energy",)) == ()
    assert on_cores(read_scene(GIMBAL), ("forward_dynamics",)) == ()


def test_bounds_are_shown_where_nothing_counts(monkeypatch):
    monkeypatch.setattr(cortex_m4, "EMULATOR", "no-such-emulator")
    costs = on_cores(read_scene(GIMBAL), ("gravity_torques",))
    assert len(costs) == 4 and not any(x.instructions for x in costs)
    assert "Not counted without no-such-emulator." in core_costs.table(costs).text()
