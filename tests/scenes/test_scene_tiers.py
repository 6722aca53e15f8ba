"""Tiers of scenes: their selection, their files, and the same bits in C and NumPy, with fma and
without."""

import importlib
import os
import pickle
import re
import subprocess
import sys
from collections.abc import Callable
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest

import coscrew_codegen
from coscrew_codegen.__main__ import main
from coscrew_codegen.accuracy import tiers
from coscrew_codegen.accuracy.scene_tiers import NoFunctionsError, in_tier, tiers_of
from coscrew_codegen.accuracy.tiers import OF_SCENES, Tier, tier_named
from coscrew_codegen.backends.output_files import scene_files
from coscrew_codegen.dynamics import derive
from coscrew_codegen.program.values.formats import PRECISIONS
from coscrew_codegen.runtime import callables, compilation, source_text
from coscrew_codegen.runtime.load import kernels_of
from coscrew_codegen.runtime.request import BOTH
from coscrew_codegen.scene.function_selection import TiersError, known_tiers, selected_tiers
from coscrew_codegen.scene.readers.scene_error import SceneError
from coscrew_codegen.scene.readers.toml.toml_scene import SceneOverrides, read_scene
from tests.benchmarks import cortex_m4
from tests.benchmarks import scene_calls as scene_calls_benchmark
from tests.benchmarks import scene_tiers as scene_tiers_benchmark
from tests.support.compiled.c_harness import C11, COMPILERS, CXX17, INCLUDE, STRICT
from tests.support.compiled.c_harness import run as command
from tests.support.compiled.flags import FMA, HASWELL, UNHEEDED
from tests.support.each import each_precision
from tests.support.scenes import scene_bits
from tests.support.scenes.generated_scenes import CASES
from tests.support.scenes.scene_values import same_bits
from tests.support.scenes.tiers import states

FILE = """name = "swing"
{}
[bodies.bob]
mass = 0.1
com = [0, 0.01, -0.3]
inertia = [0.02, 0.03, 0.04]
[joints.hinge]
type = "revolute"
child = "bob"
axis = [0, 1, 0]
[effects.gravity]
"""

MARKED = [tier for tier in OF_SCENES if tier.marked and tier.precisions == PRECISIONS]
each_tier = pytest.mark.parametrize("tier", MARKED, ids=lambda tier: tier.name)

CHECKS = callables.checks(source_text.checks())


@pytest.fixture
def write(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[[str], Path]:
    """Writes a scene with further lines."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))

    def write(more: str = "") -> Path:
        path = tmp_path / "swing.toml"
        path.write_text(FILE.format(more))
        return path

    return write


def contents(folder: Path) -> dict[str, str]:
    return {str(x.relative_to(folder)): x.read_text() for x in folder.rglob("*") if x.is_file()}


# selection


def test_files_options_and_load_scene_select_tiers(write, tmp_path: Path):
    """A tier adds the same by file and by option; nothing else changes but its mention."""
    assert main(["generate", str(write()), "-o", str(tmp_path / "plain")]) == 0
    assert main(["generate", str(write('tiers = ["plain", "accurate"]')), "-o",
                 str(tmp_path / "file")]) == 0
    assert main(["generate", str(write()), "--tier", "accurate", "-o",
                 str(tmp_path / "option")]) == 0
    plain, file, option = (contents(tmp_path / x) for x in ("plain", "file", "option"))
    assert {*file} == {*option} == {*plain} | {
        "swing_accurate.h", "swing_accurate.c", "swing_accuratef.c",
        *(f"swing/accurate/{x}.py" for x in ("__init__", "double", "single", "_exact",
                                             "_elementary_double"))}
    for name, text in plain.items():
        assert name == "swing/__init__.py" or file[name] == text
    assert "--tier accurate" in option["swing.c"].splitlines()[0]
    of_file, of_option = (x["swing_accurate.c"].split("\n", 1)[1] for x in (file, option))
    assert of_file == of_option
    messages = coscrew_codegen.load_scene(write(), tiers=["accurate"])
    again = coscrew_codegen.load_scene(messages.scene)
    one = coscrew_codegen.load_scene(write('tiers = ["accurate"]'), precision="double")
    for kernels in (messages, again, one):
        assert "inverse_dynamics" in kernels.accurate.double
    assert not [*one.accurate.single]


@pytest.mark.parametrize("given, problem", (
    ('["acurate"]', "'acurate' is no tier of scenes; did you mean 'accurate'?"),
    ("[]", "an empty list; wanted names"), ('"accurate"', "the text 'accurate'; wanted a list"),
    ('["accurate", "accurate"]', "'accurate' occurs twice")))
def test_names_are_checked(write, given: str, problem: str):
    with pytest.raises(SceneError, match=re.escape(f"tiers: {problem}")):
        coscrew_codegen.load_scene(write(f"tiers = {given}"))


def test_a_tier_of_the_library_alone_is_named(monkeypatch: pytest.MonkeyPatch):
    alone = replace(tiers.PLAIN, name="quick", scene=None)
    monkeypatch.setattr(tiers, "TIERS", (*tiers.TIERS, alone))
    with pytest.raises(TiersError, match="'quick' is no tier of scenes; the library alone has it"):
        selected_tiers(["quick"])


def test_what_is_not_there_is_named(write, capsys: pytest.CaptureFixture[str]):
    with pytest.raises(TiersError, match="did you mean 'accurate'"):
        coscrew_codegen.load_scene(write(), tiers=["accurat"])
    with pytest.raises(TypeError, match="tiers: wanted a list of names"):
        coscrew_codegen.load_scene(write(), tiers="accurate")
    plain = coscrew_codegen.load_scene(write(), functions=["energy"])
    with pytest.raises(AttributeError, match=r"it was not selected: tiers=\['accurate'\]"):
        plain.accurate
    with pytest.raises(AttributeError, match="have no attribute 'acurate'"):
        plain.acurate
    tiered = coscrew_codegen.load_scene(write(), tiers=["accurate"]).accurate
    with pytest.raises(AttributeError, match="'step_leapfrog'; steps have no tier"):
        tiered.double.step_leapfrog
    with pytest.raises(AttributeError, match="double precision, accurate tier has no function "
                                             "'enrgy'; did you mean 'energy'"):
        tiered.double.enrgy
    alone = coscrew_codegen.load_scene(write(), tiers=["accurate"], functions=["step_rk4"])
    with pytest.raises(NoFunctionsError, match="swing: the accurate tier needs a function; steps"):
        alone.accurate
    assert main(["generate", "--tier", "accurate"]) == 2
    assert "--tier selects tiers of a scene, and no scene is given" in capsys.readouterr().err


@pytest.mark.parametrize("module", (cortex_m4, scene_calls_benchmark, scene_tiers_benchmark),
                         ids=lambda module: module.__name__.rpartition(".")[2])
def test_benchmarks_ask_for_tiers_that_scenes_without_an_accuracy_have(write, module):
    scene = read_scene(write(""), overrides=SceneOverrides(tiers=module.TIERS))
    assert [x.tier.name for x in tiers_of(derive(scene))] == [x for x in module.TIERS
                                                              if x != "plain"]


def test_plain_is_always_there():
    assert selected_tiers(()) == selected_tiers(("plain",)) == ()
    assert selected_tiers(known_tiers()) == tuple(tier.name for tier in OF_SCENES if tier.marked)
    assert known_tiers()[0] == "plain"


# files


@each_tier
def test_internal_functions_and_steps_have_no_tier(tier):
    result = in_tier(CASES["spinner"](), tier)
    for _, tiered in result.in_precisions:
        assert not tiered.steps and not any(f.internal for f in tiered.functions)
        assert [f.name for f in tiered.functions] == [
            f.name for f in result.plain.functions if not f.internal]


@pytest.fixture(scope="module")
def package(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """C and Python, in all tiers, of a free body, a joint and all effects of joints."""
    folder = tmp_path_factory.mktemp("carrier")
    for name, text in scene_files(replace(
            scene_bits.functions(), tiers=tuple(tier.name for tier in MARKED))).items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    return folder


@each_tier
@pytest.mark.parametrize("flags", (C11, CXX17), ids=" ".join)
@pytest.mark.parametrize("compiler", COMPILERS)
def test_c_compiles_without_a_warning(package: Path, tier, compiler: str, flags: tuple[str, ...],
                                      tmp_path: Path):
    """Alone and between the scene's own and the library's headers; also
    where fma is no instruction."""
    name = scene_bits.functions().name
    alone, together = sorted(package.glob(f"{name}_{tier.mark}*.c")), tmp_path / "all.c"
    together.write_text("".join((*(f'#include "{x.name}"\n' for x in alone),
                                 f'#include "{name}.c"\n#include "{name}f.c"\n'
                                 "#include <ksl/ksl_elementary_error.h>\n")))
    assert alone
    for source, more in (*((x, ()) for x in alone), (together, ("-I", str(INCLUDE), *FMA))):
        command([compiler, *flags, *STRICT, *more, "-O0", "-I", package, "-c", source, "-o",
                 tmp_path / "x.o"])


@pytest.mark.parametrize("precision", ("double", "single"))
def test_a_precision_alone_is_whole(write, precision: str, tmp_path: Path):
    """Its C compiles without a warning, of unused functions either; its package runs."""
    folder = tmp_path / precision
    assert main(["generate", str(write()), "--tier", "accurate", "--precision", precision,
                 "-o", str(folder)]) == 0
    for compiler in COMPILERS:
        (source,) = folder.glob("swing_accurate*.c")
        command([compiler, *C11, *STRICT, "-O1", "-c", source, "-o", tmp_path / "x.o"])
    script = (f"import swing.accurate; m = swing.accurate.{precision}; "
              "print(m.inverse_dynamics([1], [2], [3]).dtype)")
    result = subprocess.run([sys.executable, "-c", script], check=True, text=True, cwd=folder,
                            capture_output=True).stdout
    assert result.strip() == {"double": "float64", "single": "float32"}[precision]


def test_sines_of_one_number_are_defined_beside_those_of_several(tmp_path: Path):
    """One precision needs the sine of a time alone, the other its cosine, too; both need those of
    several angles at once."""
    path = tmp_path / "chain.toml"
    links = [f"""
[bodies.b{n}]
mass = 1
com = [0, 0.1, -0.3]
inertia = [0.02, 0.03, 0.04]
[joints.j{n}]
type = "revolute"
parent = "{f"b{n - 1}" if n else "world"}"
child = "b{n}"
axis = [0, {n % 2}, {1 - n % 2}]
origin = {{ xyz = [0, 0, -0.5] }}
""" for n in range(4)]
    path.write_text("".join((*links, """
[effects.actuator.j0]
kind = "pd"
kp = 10
kd = 1
target = "sin(3*t)"
""")))
    assert main(["generate", str(path), "--functions", "inverse_dynamics", "--tier", "accurate",
                 "-o", str(tmp_path)]) == 0
    sources = [tmp_path / f"chain_accurate{f}.c" for f in ("", "f")]
    text = "".join(x.read_text() for x in sources)
    assert "ksl_sin(" in text and "ksl_sincos_3(" in text
    for source in sources:
        command(["gcc", *C11, *STRICT, "-c", source, "-o", tmp_path / "x.o"])


# bits

FLAGS = {"gcc": (("-O0",), ("-O3", "-march=native", "-ffp-contract=fast"),
                 ("-std=c11", "-O2", *FMA, "-ffp-contract=fast", UNHEEDED),
                 ("-O2", *HASWELL, "-DKSL_HAS_FMA=0", "-ffp-contract=fast")),
         "clang": (("-O1",), ("-O3", "-march=native", "-ffp-contract=fast"),
                   ("-O2", *HASWELL, "-DKSL_CONTRACT_OFF"))}
WHOLE = ("-O0", "-O1")  # levels at which all functions are compiled; at others, SOME
SOME = ("inverse_dynamics", "mass_matrix", "energy", "body_poses")
BUILDS = tuple((compiler, flags) for compiler in COMPILERS for flags in FLAGS[compiler])


@cache
def text_of(tier: Tier, *names: str) -> source_text.SourceText:
    """The C of the scene's functions, of these names or all, in a tier."""
    of_all = scene_bits.functions()
    return source_text.of_one(in_tier(replace(of_all, functions=tuple(
        f for f in of_all.functions if f.name in names or not names)), tier))


@each_tier
@pytest.mark.parametrize("compiler, flags", BUILDS,
                         ids=[" ".join((name, *flags)) for name, flags in BUILDS])
def test_bits_are_the_same_in_c_and_numpy(package: Path, tier, compiler: str,
                                          flags: tuple[str, ...], tmp_path: Path,
                                          monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    monkeypatch.syspath_prepend(package)
    text = text_of(tier, *(() if {*flags} & {*WHOLE} else SOME))
    using = compilation.Compiler((compiler,), compiler, ("-fPIC", *flags))
    of_all = scene_bits.functions()
    library = compilation.library(text.units(BOTH), text.files, using)
    result = text.interface
    assert {x.name for x in result.signatures} >= {*SOME}
    for p in PRECISIONS:
        twins = importlib.import_module(f"{of_all.name}.{tier.mark}.{p.name}")
        for described in result.signatures:
            call = callables.compiled(result, library.opened, CHECKS, described, p)
            given = states(of_all, of_all.named(described.name), 40, p)
            assert same_bits(call(None, *given), getattr(twins, described.name)(*given)), (
                described.name, p.name)


@each_precision
def test_numbers_of_any_kind_give_the_same_bits(precision, tmp_path: Path,
                                                monkeypatch: pytest.MonkeyPatch):
    """Zeros, infinities, NaN, the least and large numbers, in rational arithmetic."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    slider = replace(CASES["slider"](), tiers=("accurate",))
    compiled = getattr(kernels_of(slider).accurate, precision.name)
    monkeypatch.setenv("CC", "no-such-compiler")
    with pytest.warns(RuntimeWarning, match="pure NumPy"):
        pure = getattr(kernels_of(slider).accurate, precision.name)
    draw = np.random.default_rng(5)
    kinds = (0.0, -0.0, 1.0, -1.5, 1e-300, 1e30, 5e-324, np.inf, -np.inf, np.nan, 0.1)
    for f in in_tier(slider, tier_named("accurate")).first.functions:
        with np.errstate(all="ignore"):
            given = [draw.choice(kinds, (300, *a.quantity.shape)).astype(precision.numpy_type)
                     for a in f.program.inputs]
        assert same_bits(getattr(compiled, f.name)(*given), getattr(pure, f.name)(*given)), f.name


def test_kernels_of_a_tier_are_cached_and_pickled(write):
    path = write('tiers = ["accurate"]')
    wanted = coscrew_codegen.load_scene(path).accurate.double.inverse_dynamics([1], [2], [3])
    kernels = coscrew_codegen.load_scene(path)
    assert kernels.accurate is kernels.accurate and kernels.accurate.plain is kernels
    copied = pickle.loads(pickle.dumps(kernels.accurate))
    assert same_bits(copied.double.inverse_dynamics([1], [2], [3]), wanted)
    script = ("import sys; from coscrew_codegen import load_scene; "
              f"load_scene({str(path)!r}).accurate.double.inverse_dynamics([1], [2], [3]); "
              "assert 'coscrew_codegen.dynamics' not in sys.modules")
    subprocess.run([sys.executable, "-c", script], check=True, env={**os.environ})
