"""`coscrew generate SCENE.toml`: the files, `--check`, and messages."""

from pathlib import Path

import numpy as np
import pytest

from coscrew_codegen import load_scene
from coscrew_codegen.__main__ import main
from coscrew_codegen.backends.python_extension import scene_calls
from coscrew_codegen.scene.identifiers import identifiers
from tests.support.compiled.c_harness import COMPILERS, CXX_COMPILERS, DIALECTS, EXACT, STRICT, run
from tests.support.each import each_precision
from tests.support.scenes.generated_scenes import imported
from tests.support.scenes.scene_values import UNIT, inputs, same_bits

FILES = ("arm.c", "arm.h", "arm/__init__.py", "arm/_arrays.py", "arm/_elementary_double.py",
         "arm/_elementary_single.py", "arm/double.py", "arm/single.py", "armf.c",
         "coscrew_runtime.h")

SCENE = """
name = "arm"
runtime = ["hand.mass"]
[bodies.upper]
mass = 2
com = [0, 0, 0.2]
inertia = [0.1, 0.1, 0.01]
[bodies.hand]
mass = 0.5
com = [0.01, 0.02, 0.1]
inertia = [0.01, 0.02, 0.015]
[joints.shoulder]
type = "revolute"
child = "upper"
axis = [0, 1, 0]
damping = 0.3
[joints.wrist]
type = "spherical"
parent = "upper"
child = "hand"
origin = { xyz = [0, 0, 0.4] }
[effects.gravity]
"""


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The current folder, with a scene in it; the cache is beside it."""
    work = tmp_path / "work"
    work.mkdir()
    (work / "arm.toml").write_text(SCENE)
    monkeypatch.chdir(work)
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    return work


def generated(folder: Path) -> tuple[str, ...]:
    return tuple(sorted(p.relative_to(folder).as_posix() for p in folder.rglob("*") if p.is_file()))


def test_files_are_written_and_checked(folder: Path, capsys: pytest.CaptureFixture[str]):
    assert main(["generate", "arm.toml", "-o", "out"]) == 0
    output = capsys.readouterr()
    assert output.out == "out: 10 files, 10 changed\n"
    assert output.err.startswith("arm.toml: joint shoulder: damping 0.3")
    assert output.err.count("\n") == 1
    assert generated(folder / "out") == FILES
    assert main(["generate", "arm.toml", "--output", "out"]) == 0
    assert capsys.readouterr().out == "out: 10 files, 0 changed\n"
    assert main(["generate", "arm.toml", "-o", "out", "--check"]) == 0
    header = folder / "out" / "arm.h"
    header.write_text(header.read_text().replace("ARM_NQ 5", "ARM_NQ 6"))
    assert main(["generate", "arm.toml", "-o", "out", "--check"]) == 1
    output = capsys.readouterr()
    assert "-#define ARM_NQ 6\n+#define ARM_NQ 5\n" in output.out
    assert "out: 1 files are out of date; run `coscrew generate arm.toml -o out`" in output.err
    assert "ARM_NQ 6" in header.read_text()


def test_what_an_earlier_generator_made_is_removed_and_nothing_else(folder: Path):
    package = folder / "out" / "arm"
    package.mkdir(parents=True)
    (package / "half.py").write_text(
        "# Made by `coscrew generate arm.toml`; changes are overwritten.\n")
    (package / "mine.py").write_text("# by hand\n")
    (folder / "out" / "other.h").write_text("/* Made by `coscrew generate other.toml`; … */\n")
    assert main(["generate", "arm.toml", "-o", "out"]) == 0
    assert generated(folder / "out") == tuple(sorted((*FILES, "arm/mine.py", "other.h")))


def test_files_that_others_made_are_not_overwritten(folder: Path,
                                                   capsys: pytest.CaptureFixture[str]):
    (folder / "arm.c").write_text("/* by hand */\n")
    assert main(["generate", "arm.toml", "-o", "."]) == 2
    assert "arm.c is there already" in capsys.readouterr().err
    assert generated(folder) == ("arm.c", "arm.toml")
    assert (folder / "arm.c").read_text() == "/* by hand */\n"


def test_files_name_no_folder(folder: Path):
    assert main(["generate", str(folder / "arm.toml"), "-o", str(folder / "out")]) == 0
    for file in FILES:
        text = (folder / "out" / file).read_text(encoding="utf-8")
        first = text.split("\n")[0]
        made = "SCENE`, the same for every scene" if file == "coscrew_runtime.h" else "arm.toml`"
        assert f"Made by `coscrew generate {made}; changes are overwritten." in first
        assert str(folder) not in text


@pytest.mark.parametrize("arguments, message", (
    (["missing.toml", "-o", "out"], "missing.toml: cannot be read"),
    (["arm.toml"], "where to?  Wanted: coscrew generate arm.toml -o DIR"),
    (["arm.toml", "-o", "out", "--family", "vec3"], "--family selects kernels of the library"),
    (["arm.toml", "-o", "out", "--language", "c"], "--language selects kernels of the library"),
    (["arm.toml", "-o", "arm.toml"], "cannot write arm.toml"),
    (["arm.toml", "-o", "out", "--functions", "jacobian_hnd"],
     "'jacobian_hnd' is no function of the scene; did you mean 'jacobian_hand'?"),
    (["--functions", "energy"], "--functions selects functions of a scene, and no scene is given"),
    (["--cuda"], "--cuda selects functions of a scene, and no scene is given"),
))
def test_errors_are_one_line(folder: Path, capsys: pytest.CaptureFixture[str], arguments: list[str],
                             message: str):
    assert main(["generate", *arguments]) == 2
    last = capsys.readouterr().err.splitlines()[-1]
    assert last.startswith(f"coscrew: {message}")
    assert generated(folder) == ("arm.toml",)


def test_functions_of_many_states_are_generated_when_selected(folder: Path):
    assert main(["generate", "arm.toml", "-o", "out", "--many"]) == 0
    assert main(["generate", "arm.toml", "-o", "out", "--many", "--check"]) == 0
    for compiler in COMPILERS:
        for name in ("arm_many.c", "arm_manyf.c"):
            run([compiler, "-std=c11", *STRICT, "-O1", "-c", folder / "out" / name, "-o",
                 folder / "arm.o"])
    header = (folder / "out" / "arm_many.h").read_text()
    assert "\nvoid arm_energy_manyf(ptrdiff_t n, const float *p, ptrdiff_t p_stride," in header


def test_functions_for_cuda_are_generated_when_selected(folder: Path):
    assert main(["generate", "arm.toml", "-o", "out", "--cuda", "--tier", "accurate"]) == 0
    assert main(["generate", "arm.toml", "-o", "out", "--cuda", "--tier", "accurate",
                 "--check"]) == 0
    for stem in ("arm", "arm_accurate"):
        run([CXX_COMPILERS[0], "-x", "c++", "-std=c++11", *STRICT, "-fsyntax-only", "-include",
             folder / "out" / f"{stem}.cuh", "/dev/null"])
    header = (folder / "out" / "arm.cuh").read_text()
    assert "\nKSL_KERNEL void arm_energy_kernelf(ptrdiff_t n, const float *p," in header


def test_generated_c_compiles_and_loads_from_the_file(folder: Path):
    assert main(["generate", "arm.toml", "-o", "out"]) == 0
    for compiler in COMPILERS:
        for name in ("arm.c", "armf.c"):
            run([compiler, "-std=c11", *STRICT, EXACT, "-O2", "-c", folder / "out" / name, "-o",
                 folder / "arm.o"])
    for given in ("arm.toml", Path("arm.toml")):
        kernels = load_scene(given)
        assert kernels.compiled and kernels.scene.name == "arm"
        assert kernels.functions.parameters == (("hand.mass", 0.5),)
        assert kernels.double.mass_matrix([0.5], [0, 1, 0, 0, 0]).shape == (4, 4)


AWKWARD = ("int", "sin", "q", "lambda", "tau", "np", "v_0", "*/ x", "π", "2", "arm_NQ", "call",
           "x_call", "x_many", "x", "xf")


def test_bodies_and_joints_may_be_called_anything(folder: Path):
    """Keywords of the languages, names of arguments, the end of a comment, suffixes of C names."""
    parents = ("world", *(f"{name} body" for name in AWKWARD))
    scene = ['name = "main_arm"', "[effects.gravity]"]
    for n, name in enumerate(AWKWARD):
        scene += [f'["bodies"."{name} body"]', "mass = 1", "inertia = [1, 1, 1]",
                  "com = [0.1, 0.2, 0.3]", f'["joints"."{name}"]', f'parent = "{parents[n]}"',
                  f'child = "{name} body"', f"axis = [{n % 2}, {1 - n % 2}, 0]",
                  f'type = "{("revolute", "prismatic")[n % 3 == 2]}"',
                  "origin = { xyz = [0.1, 0, 0] }"]
    (folder / "main_arm.toml").write_text("\n".join(scene), encoding="utf-8")
    functions = ["inverse_dynamics", "forward_dynamics", "mass_matrix", "step_leapfrog"]
    named = (f"jacobian_{x}" for x in identifiers([f"{name} body" for name in AWKWARD]))
    assert main(["generate", "main_arm.toml", "-o", "out", "--functions", *functions, *named]) == 0
    for compiler, language in DIALECTS:
        run([compiler, *language, *STRICT, "-fsyntax-only", folder / "out" / "main_arm.c",
             folder / "out" / "main_armf.c"])
    kernels = load_scene("main_arm.toml", functions=functions)
    package = imported(kernels.functions, folder / "other")
    assert package.JOINTS == AWKWARD
    q, v, a = np.random.default_rng(3).normal(size=(3, 7, len(AWKWARD)))
    tau = package.double.inverse_dynamics(q, v, a)
    result = kernels.double.forward_dynamics(q, v, tau)
    condition = np.linalg.cond(kernels.double.mass_matrix(q))
    largest = np.linalg.norm(a, axis=-1)
    bound = 100 * UNIT["double"] * condition * largest  # eight roundings for each joint, amplified
    assert np.all(np.linalg.norm(result - a, axis=-1) <= bound)


@each_precision
def test_derived_dynamics_have_the_same_bits_in_c_and_numpy(folder: Path, precision):
    """At the shoulder's angle 0, where sine and cosine are exact; the wrist's quaternions are
    arbitrary."""
    kernels = load_scene("arm.toml")
    package = imported(kernels.functions, folder / "out")
    transcendental = ("integrated", *(step.name for step in kernels.functions.steps))
    compared = 0
    for function in scene_calls.callables(kernels.functions):
        if function.name in transcendental:
            continue
        arguments = inputs(function, precision.numpy_type, 50)
        for (name, _), values in zip(function.inputs, arguments, strict=True):
            if name == "q":
                values[..., 0] = 0
                values[..., 1:] /= np.linalg.norm(values[..., 1:], axis=-1, keepdims=True)
            if name == "p":
                np.abs(values, out=values)  # of masses and others that must be positive
        result, wanted = (getattr(getattr(x, precision.name), function.name)(*arguments)
                          for x in (kernels, package))
        assert same_bits(result, wanted), function.name
        compared += 1
    assert compared >= 10


@pytest.mark.parametrize("requested", ("--precision", "scene"))
def test_single_precision_alone(folder: Path, requested: str):
    """Its functions are the same as in files with both precisions; nothing is in double."""
    assert main(["generate", "arm.toml", "-o", "both"]) == 0
    if requested == "scene":
        (folder / "arm.toml").write_text('precision = "single"\n' + SCENE)
    options = ["--precision", "single"] if requested == "--precision" else []
    assert main(["generate", "arm.toml", "-o", "out", *options]) == 0
    assert generated(folder / "out") == tuple(
        x for x in FILES if "double" not in x and x != "arm.c")
    alone, both = ((folder / x / "armf.c").read_text().split("\n", 1)[1] for x in ("out", "both"))
    assert alone == both
    header = (folder / "out" / "arm.h").read_text()
    assert "in single precision only" in header and "tau = M(q) a" in header
    assert "double" not in alone and "(double" not in header
    for compiler, dialect in DIALECTS:
        run([compiler, *dialect, *STRICT, "-c", folder / "out" / "armf.c", "-o", folder / "x.o"])
