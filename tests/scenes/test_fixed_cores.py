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
from coscrew_codegen.reports.cost import cost_measurement
from coscrew_codegen.reports.cost.cost_request import CostRequest
from coscrew_codegen.reports.cost.error_states import box_of
from coscrew_codegen.reports.cost.measured import Counts
from coscrew_codegen.reports.cost.needs import core_costs, core_estimates, cortex_m4
from coscrew_codegen.reports.cost.needs.core_costs import CORES, CoreCost, on_cores
from coscrew_codegen.runtime.compilation import compiler
from coscrew_codegen.runtime.load import Kernels, kernels_for
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.simulation.result_units import in_unit
from coscrew_codegen.simulation.run_summary import RunOverrides
from coscrew_codegen.simulation.system import system
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
        estimate = core_estimates.of_fixed(function.programs[products].program, products).on(core)
        assert estimate and abs(estimate / count - 1) < 0.1


UNITS = {"inverse_dynamics": "N m", "energy": "J"}
REQUEST = CostRequest(tuple(UNITS), Counts.of(12))


@pytest.fixture(scope="module")
def measured() -> Kernels:
    its = read_scene(GIMBAL)
    return kernels_for(its, REQUEST.needed(its, None))


@pytest.fixture(scope="module")
def costs(measured: Kernels) -> tuple[CoreCost, ...]:
    """The costs of these functions in each format."""
    return cost_measurement.measure(measured, RunOverrides(), REQUEST).cores


def test_cost_shows_formats_on_cores(costs):
    """Bounds over the ranges, and instructions, function by function."""
    assert [x.function for x in costs] == ["inverse_dynamics"] * 9 + ["energy"] * 9
    known = {x.format: x for x in costs[:9]}
    assert list(known) == [
        "double", "single", "double accurate", "single accurate", "double certified",
        "single certified", "single pairs", "fixed", "fixed (high)"]
    double, single, full, high = (known[x] for x in ("double", "single", "fixed", "fixed (high)"))
    bounds = [x.bounds["N m"] for x in (double, full, high, single)]
    assert bounds == sorted(bounds) and 10 * high.bounds["N m"] < single.bounds["N m"]
    assert known["double accurate"].bounds["N m"] < double.bounds["N m"]
    assert all(x.counted and x.instructions.keys() == CORES.keys() for x in costs)
    assert all(x.time for x in (full, high))
    assert all(double.instructions[x] > 10 * full.instructions[x] for x in CORES)
    assert all(single.instructions[x] > 4 * full.instructions[x] for x in list(CORES)[:2])
    text = core_costs.table(costs).text()
    assert "energy" in text and f"{full.instructions['Cortex-M0+']:,}" in text


def test_cost_shows_errors_found_in_the_ranges_beside_the_bounds(measured, costs):
    """Certified functions also return bounds, which lie between."""
    its = read_scene(GIMBAL)
    assert its.ranges
    box = box_of(system(measured, "double"), 1.0, 1e-3)
    states = box.drawn(np.random.default_rng(0), 400)
    for name in ("q", "v", "a"):
        lower, upper = np.array(its.ranges.of(name, 3)).T
        assert ((lower <= states[name]) & (states[name] <= upper)).all()
        assert (states[name].max(0) > 0.9 * upper).all()
    for x in costs:
        unit = UNITS[x.function]
        assert 0 < x.worst[unit] <= x.bounds[unit] < 100 * x.worst[unit], x.format
        assert ("certified" in x.format) == (unit in x.returned)
        assert not x.returned or x.worst[unit] <= x.returned[unit] <= x.bounds[unit]
    table = core_costs.table(costs)
    column = table.headers.index("found")
    assert [row[column] for row in table.rows] == [
        in_unit(x.worst[UNITS[x.function]], UNITS[x.function]) for x in costs]


def test_cost_shows_nothing_of_scenes_without_the_tier(tmp_path):
    assert on_cores(fx.panda(tmp_path, tiers=""), ("energy",), compiler(), {}) == ()
    assert on_cores(read_scene(GIMBAL), ("forward_dynamics",), compiler(), {}) == ()


def test_bounds_are_shown_where_nothing_counts(monkeypatch):
    monkeypatch.setattr(cortex_m4, "EMULATOR", "no-such-emulator")
    costs = on_cores(read_scene(GIMBAL), ("gravity_torques",), compiler(), {})
    assert len(costs) == 9 and not any(x.counted for x in costs)
    assert "Estimated from operations, without no-such-emulator" in core_costs.table(costs).text()
