"""A scene's functions of many states have the bits of one: with every compiler, width and flag, for
any number of states, strides, shared rows, in place, and for numbers of every kind."""

import inspect
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from coscrew_codegen.accuracy.scene_tiers import SceneTier, in_tier
from coscrew_codegen.accuracy.tiers import tier_named
from coscrew_codegen.backends.scene import scene_c, scene_c_many, scene_c_parts
from coscrew_codegen.backends.scene.scene_text import c_name, many
from coscrew_codegen.dynamics import derive
from coscrew_codegen.program.scene_functions import SceneFunctions, Signature, Split
from coscrew_codegen.program.values.formats import DOUBLE, Precision
from coscrew_codegen.runtime import compilation, lanes
from coscrew_codegen.runtime.load import Kernels, kernels_for, kernels_of
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.scene.scene import Scene, Tolerance
from tests.support.compiled.c_harness import C11, COMPILERS, CXX17, STRICT, run
from tests.support.compiled.cross import COMPILERS as CROSS
from tests.support.compiled.cross import needed
from tests.support.compiled.flags import FMA, HASWELL, SANITIZERS, X86, has_sanitizers
from tests.support.each import each_precision
from tests.support.scenes import effect_scenes, lanes_program, mechanisms
from tests.support.scenes.arms import arm
from tests.support.scenes.generated_scenes import pendulum, slider, spinner
from tests.support.scenes.kinds import Kind
from tests.support.scenes.mechanisms import gravity
from tests.support.scenes.scene_values import same_bits

NATIVE = ("-O2", "-march=native", "-ffp-contract=fast")
BUILDS = {"gcc": ((*C11, "-O0", "-DKSL_LANE_BYTES=0", *STRICT), (*C11, *NATIVE, *STRICT),
                  (*CXX17, "-O1", "-march=native", "-DKSL_LANE_BYTES=16")),
          "clang": ((*C11, "-O1", *STRICT),
                    (*C11, "-O2", *HASWELL, "-ffp-contract=fast", *STRICT),
                    (*CXX17, "-O1", "-march=native", "-ffp-contract=fast"))}
"""No lanes, and those of SSE2, AVX2 and this processor."""
by_build = pytest.mark.parametrize("compiler, flags", [
    (x, flags) for x in COMPILERS for flags in (
        *([(*C11, *SANITIZERS, *FMA)] if has_sanitizers(x) else []), *BUILDS[x])
] if X86 else [(x, (*C11, "-O2")) for x in COMPILERS],
    ids=lambda x: x if isinstance(x, str) else " ".join(x))


def compared(scene: SceneFunctions, folder: Path, compiler: str, *flags: str) -> int:
    """Compares numbers, which are equal; returns how many."""
    sources = lanes_program.written(scene, folder)
    run((compiler, *flags, *sources, "-o", folder / "lanes", "-lm"))
    return int(run([folder / "lanes"]))


@by_build
def test_bits_are_those_of_one_state(compiler: str, flags: tuple[str, ...], tmp_path: Path):
    assert compared(pendulum(), tmp_path, compiler, *flags) > 10000


@pytest.mark.parametrize("scene, compiler", ((slider, COMPILERS[0]), (spinner, COMPILERS[-1])))
def test_bits_of_other_scenes(scene: Callable[[], SceneFunctions], compiler: str, tmp_path: Path):
    assert compared(scene(), tmp_path, compiler, *C11, "-O1", *FMA) > 10000


@pytest.mark.parametrize("joints", (1, 2, 3, 5, 7, 18))
@pytest.mark.parametrize("compiler, flags", (
    *((x, ("-march=native",) if X86 else ()) for x in COMPILERS), (COMPILERS[-1], FMA),
    (COMPILERS[0], ("-O2", "-DKSL_LANE_BYTES=16"))), ids=str)
def test_rows_of_many_lengths(joints: int, compiler: str, flags: tuple[str, ...], tmp_path: Path):
    """Rows are transposed in blocks and tiles: shorter ones than these, the rest of longer ones,
    and so many that a loop takes the first."""
    link = Kind.REVOLUTE, mechanisms.Z, mechanisms.at(1, 0, 0), mechanisms.inertia(1, (1, 0, 0))
    plane = Scene("plane", mechanisms.chain(*[link] * joints), ())
    made = derive(plane, ("inverse_dynamics", "mass_matrix"))
    assert compared(made, tmp_path, compiler, *C11, "-O1", *flags, *STRICT) > 5000


@pytest.mark.parametrize("compiler", COMPILERS)
def test_files_of_two_scenes_are_compiled_as_one(compiler: str, tmp_path: Path):
    """Both depend on time."""
    first = slider()
    for scene in (first, replace(first, name="other")):
        for name, text in (scene_c.files(scene, "") | scene_c_many.files(scene, "")).items():
            (tmp_path / name).write_text(text)
    names = (f"{x}{y}.c" for y in ("", "f", "_many", "_manyf") for x in (first.name, "other"))
    (tmp_path / "all.c").write_text("".join(f'#include "{x}"\n' for x in names))
    run((compiler, *C11, *STRICT, "-c", tmp_path / "all.c", "-o", tmp_path / "all.o"))


def test_scenes_with_every_effect(tmp_path: Path):
    """Steps, too, that are split where a state needs it."""
    scene = derive(effect_scenes.all_but(()), ("forward_dynamics", "step_leapfrog"))
    assert any(isinstance(x, Split) for step in scene.steps for x in step.body)
    assert compared(scene, tmp_path, COMPILERS[-1], *C11, "-O1", *FMA) > 10000


@pytest.mark.parametrize("tier, compiler, flags", (
    ("accurate", "clang", ("-O1", *HASWELL)), ("pairs", "gcc", ("-O1", "-march=native")),
    ("certified", "gcc", ("-O1",)), ("certified", "clang", ("-O0", "-march=native"))), ids=str)
def test_tiers(tier: str, compiler: str, flags: tuple[str, ...], tmp_path: Path):
    made = in_tier(pendulum(), tier_named(tier))
    assert tier_compared(made, tmp_path, compiler, *C11, *flags, *STRICT) > 5000


@pytest.mark.parametrize("tier", ("accurate", "certified"))
def test_tiers_within_memory(tier: str, tmp_path: Path):
    made = in_tier(pendulum(), tier_named(tier))
    assert tier_compared(made, tmp_path, "gcc", *SANITIZERS, "-O0", *FMA) > 5000


def test_mixed_tier(tmp_path: Path):
    model = replace(arm(), joints=arm().joints[:2], bodies=arm().bodies[:2])
    scene = Scene("mixed", model, (gravity(),), functions=("inverse_dynamics",), tiers=("mixed",),
                  accuracy=(Tolerance("inverse_dynamics", "", 1e-6),))
    made = in_tier(derive(scene), tier_named("mixed"))
    assert tier_compared(made, tmp_path, COMPILERS[0], *C11, "-O1", *FMA, *STRICT) > 2000


def tier_compared(made: SceneTier, folder: Path, compiler: str, *flags: str) -> int:
    sources = lanes_program.tier_written(made, folder)
    run((compiler, *flags, *sources, "-o", folder / "lanes", "-lm"))
    return int(run([folder / "lanes"]))


def test_functions_that_are_cut(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(scene_c_parts, "LONG", 0)
    monkeypatch.setattr(scene_c_parts, "LONGEST", 60)
    made = derive(effect_scenes.all_but(()), ("forward_dynamics",))
    assert compared(made, tmp_path, COMPILERS[0], *C11, "-O1", *FMA) > 5000
    assert "CHAIN_PART" in (tmp_path / "chain_many.c").read_text()


def test_bits_on_aarch64(tmp_path: Path):
    compiler = CROSS["aarch64"]
    needed(compiler, "qemu-aarch64")
    sources = lanes_program.written(pendulum(), tmp_path)
    run((compiler, "-O2", "-static", *sources, "-o", tmp_path / "lanes", "-lm"))
    assert int(run(("qemu-aarch64", tmp_path / "lanes"))) > 10000


def test_wider_than_registers_is_refused(tmp_path: Path):
    with pytest.raises(pytest.fail.Exception, match="KSL_LANE_BYTES: this processor's registers"):
        compared(slider(), tmp_path, COMPILERS[0], *C11, "-DKSL_LANE_BYTES=128")


# From Python

@pytest.fixture(scope="module")
def compiled(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A cache of its own: other tests' may hold what these see compiled."""
    return tmp_path_factory.mktemp("cache")


@pytest.fixture(params=(pendulum, slider))
def kernels(request: pytest.FixtureRequest, compiled: Path, monkeypatch: pytest.MonkeyPatch
            ) -> Kernels:
    """Kernels that compute in lanes from 100 states on."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(compiled))
    monkeypatch.setattr(lanes, "PAYS", 100)
    return kernels_of(request.param())


def states(count: int, described: Signature, precision: Precision) -> list[np.ndarray]:
    """t and h of all, p of one, rows of the others that are every second in an array."""
    draw = np.random.default_rng(1)
    return [draw.uniform(0.1, 2, shape).astype(precision.numpy_type)
            if x in ("t", "h", "p") else
            draw.uniform(-2, 2, (2 * count, *shape)).astype(precision.numpy_type)[::2]
            for x, shape in described.inputs]


@each_precision
def test_leading_axes_use_lanes(kernels: Kernels, precision: Precision):
    used = 0
    for described in kernels.interface.signatures:
        function = getattr(getattr(kernels, precision.name), described.name)
        kernels._lanes._met = 0
        given = states(99, described, precision)
        wanted = function(*given)  # one by one
        kernels._lanes._met = 100
        name = c_name(many(kernels.interface), described.name, precision)
        used += kernels._lanes.function(name, 0) is not None
        assert same_bits(function(*given), wanted), described.name
        folded = [x if x.ndim == len(shape) else x.reshape(9, 11, *shape)
                  for x, (_, shape) in zip(given, described.inputs, strict=True)]
        result = function(*folded)
        outputs = result if isinstance(result, tuple) else (result,)
        plain = wanted if isinstance(wanted, tuple) else (wanted,)
        assert same_bits(tuple(x.reshape(y.shape) for x, y in zip(outputs, plain, strict=True)),
                         plain), described.name
    assert used == len(kernels.interface.signatures)


@each_precision
def test_runs_take_leading_axes(kernels: Kernels, precision: Precision):
    draw = np.random.default_rng(2)
    real, scene = precision.numpy_type, kernels.interface
    q, v, p = (draw.uniform(0.1, 1, (*lead, n)).astype(real) for lead, n in (
        ((3, 5), scene.nq), ((5,), scene.nv), ((3, 1), len(scene.parameters))))
    for step in (x for x in scene.signatures if x.moved):
        run = getattr(getattr(kernels, precision.name), step.name).repeated
        kernels._lanes._met = -1000
        of_one = [run(7, 0.25, 0.01, p[i, 0], q[i, j], v[j]) for i in range(3) for j in range(5)]
        wanted = [np.reshape([x[n] for x in of_one], (3, 5, -1)) for n in range(2)]
        for met in (-1000, 1000):  # one by one, in lanes
            kernels._lanes._met = met
            for threads in (1, 2, 99):
                result = run(7, 0.25, 0.01, p, q, v, threads=threads)
                assert same_bits(result, tuple(wanted)), (step.name, met, threads)
        run_of_all = c_name(many(scene), step.name.replace("step", "run", 1), precision)
        assert kernels._lanes.function(run_of_all, 0)


def test_runs_refuse_rows_of_other_lengths(kernels: Kernels):
    scene = kernels.interface
    name = next(x.name for x in scene.signatures if x.moved)
    p = np.ones(len(scene.parameters))
    for nq, nv in ((scene.nq - 1, scene.nv), (scene.nq, scene.nv + 1)):
        with pytest.raises(ValueError, match="wanted shape"):
            getattr(kernels.double, name).repeated(1, 0.0, 0.01, p, np.zeros(nq), np.zeros(nv))
    with pytest.raises(ValueError, match="n: got -1; wanted a number of steps"):
        getattr(kernels.double, name).repeated(-1, 0.0, 0.01, p, np.zeros(scene.nq),
                                               np.zeros(scene.nv))
    for threads, error in ((0, ValueError), (True, TypeError), (1.0, TypeError)):
        with pytest.raises(error, match="threads: got .*; wanted a positive integer"):
            getattr(kernels.double, name).repeated(
                1, 0.0, 0.01, p, np.zeros(scene.nq), np.zeros(scene.nv), threads=threads)


@each_precision
def test_runs_keep_arrays_that_need_no_conversion(kernels: Kernels, precision: Precision):
    """They give the bits of lists, from which arrays are made."""
    scene, real = kernels.interface, precision.numpy_type
    name = next(x.name for x in scene.signatures if x.moved)
    run = getattr(getattr(kernels, precision.name), name).repeated
    draw = np.random.default_rng(3)
    given = [draw.uniform(0.1, 1, 2 * n).astype(real)[::2]
             for n in (len(scene.parameters), scene.nq, scene.nv)]
    before = [x.tobytes() for x in given]
    result = run(7, 0.25, 0.01, *given)
    assert [x.tobytes() for x in given] == before
    assert same_bits(result, run(7, 0.25, 0.01, *(x.tolist() for x in given)))


def test_runs_have_help_of_their_own(kernels: Kernels):
    name = next(x.name for x in kernels.interface.signatures if x.moved)
    result = getattr(kernels.double, name).repeated
    assert inspect.getdoc(result).startswith("q and v after n steps of h, the first of them at t.")
    assert [*inspect.signature(result).parameters] == ["n", "t", "h", "p", "q", "v", "threads"]


@pytest.mark.parametrize("scene", (pendulum, slider))
def test_lanes_are_compiled_when_they_pay(scene: Callable[[], SceneFunctions], tmp_path: Path,
                                          monkeypatch: pytest.MonkeyPatch):
    def libraries() -> int:
        return len(list((tmp_path / "coscrew").rglob("*.so")))

    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    monkeypatch.setattr(lanes, "PAYS", 100)
    kernels = kernels_of(scene())
    described = next(x for x in kernels.interface.signatures if x.name == "forward_dynamics")
    before = libraries()
    for count, more in ((60, 0), (39, 0), (1, 1), (500, 1)):
        kernels.double.forward_dynamics(*states(count, described, DOUBLE))
        assert libraries() == before + more


def test_states_without_room_for_their_results_do_not_count(kernels: Kernels):
    described = next(x for x in kernels.interface.signatures if x.name == "forward_dynamics")
    given = states(1, described, DOUBLE)
    vast = [x if x.ndim == len(shape) else np.broadcast_to(x, (2**50, *shape))
            for x, (_, shape) in zip(given, described.inputs, strict=True)]
    with pytest.raises(MemoryError):
        kernels.double.forward_dynamics(*vast)
    with pytest.raises(ValueError, match="out: got shape"):
        kernels.double.forward_dynamics(*states(200, described, DOUBLE), out=np.empty((199, 1)))
    assert kernels._lanes._met == 0


@pytest.mark.parametrize("scene", (pendulum, slider))
def test_without_lanes_states_are_computed_one_by_one(
        scene: Callable[[], SceneFunctions], tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))  # none are compiled yet
    monkeypatch.setattr(lanes, "PAYS", 100)
    kernels = kernels_of(scene())

    def fail(*_: object) -> None:
        raise compilation.CompilationError("no such vectors")

    monkeypatch.setattr(compilation, "library", fail)
    described = next(x for x in kernels.interface.signatures if x.name == "forward_dynamics")
    given = states(200, described, DOUBLE)
    with pytest.warns(RuntimeWarning, match="one by one: no such vectors") as messages:
        result = kernels.double.forward_dynamics(*given)
    assert messages[0].filename == __file__
    assert same_bits(result[:50], kernels.double.forward_dynamics(*(
        x if n in ("t", "p") else x[:50] for x, (n, _) in zip(given, described.inputs,
                                                            strict=True))))


def test_lanes_are_compiled_when_they_pay_and_opened_if_they_are_there(
        tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    """After 16384 states from the cache, after a million by compiling."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    scene = read_scene(Path(__file__).parents[2] / "examples/scenes/pendulum.toml")

    def opened_after(states: int, calls: int = 1) -> bool:
        kernels = kernels_for(scene, ("energy",), ("double",))
        name = c_name(many(kernels.interface), "energy", DOUBLE)
        results = [kernels._lanes.function(name, states) for _ in range(calls)]
        return results[-1] is not None

    library, made = compilation.library, list[str]()
    monkeypatch.setattr(compilation, "library", lambda units, *others: (
        made.extend(x for x, *_ in units.values()), library(units, *others))[1])
    assert not opened_after(16384) and not opened_after(999_999)
    assert made == ["pendulum_calls.c", "calls/binding.c"]
    assert opened_after(1_000_000) and made[2:] == ["pendulum_many.c"]
    assert not opened_after(16383) and opened_after(16384)
    assert opened_after(4, calls=512) and not opened_after(4, calls=511)
    assert len(made) == 3


def test_lanes_are_compiled_for_many_calls_of_few_states(
        tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    monkeypatch.setattr(lanes, "CALLS", 3)
    kernels = kernels_of(pendulum())
    name = c_name(many(kernels.interface), "forward_dynamics", DOUBLE)
    results = [kernels._lanes.function(name, 1) is not None for _ in range(4)]
    assert results == [False, False, True, True]


@each_precision
def test_tiers_use_lanes(precision: Precision, tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    monkeypatch.setattr(lanes, "PAYS", 100)
    kernels = kernels_of(replace(pendulum(), tiers=("accurate",))).accurate
    described = next(x for x in kernels.interface.signatures if x.name == "forward_dynamics")
    function = getattr(kernels, precision.name).forward_dynamics
    given = states(99, described, precision)
    wanted = function(*given)
    name = c_name(many(kernels.interface), "forward_dynamics", precision)
    assert kernels._lanes.function(name, 0) is None and kernels._lanes.function(name, 1)
    assert same_bits(function(*given), wanted)
