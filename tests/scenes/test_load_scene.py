"""load_scene: kernels are compiled, and cached by content; without a compiler NumPy computes the
same."""

import os
import re
import shutil
import stat
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

import coscrew_codegen
from coscrew_codegen.runtime import compilation
from coscrew_codegen.runtime.load import Kernels, kernels_of
from tests.support.compiled.c_harness import COMPILERS
from tests.support.scenes import scene_texts as texts
from tests.support.scenes.generated_scenes import ARGUMENTS, pendulum, slider
from tests.support.scenes.scene_values import same_bits


@pytest.fixture
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty cache."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    return tmp_path / "cache" / "coscrew"


@pytest.fixture(scope="module")
def counting(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A compiler that keeps a list of its calls, in a file `calls` beside it."""
    script = tmp_path_factory.mktemp("counting") / "counting cc"
    log = script.with_name("calls")
    script.write_text(f'#!/bin/sh\ncase "$*" in --version) ;; *) echo "$*" >> "{log}";; esac\n'
                      f'exec {shutil.which(COMPILERS[0])} "$@"\n')
    script.chmod(script.stat().st_mode | stat.S_IXUSR)
    log.touch()
    return script


@pytest.fixture
def counted(counting: Path, monkeypatch: pytest.MonkeyPatch, cache: Path):
    """Number of compilations by $CC since the test began."""
    log = counting.with_name("calls")
    before = len(log.read_text().splitlines())
    monkeypatch.setenv("CC", f"'{counting}'")
    return lambda: len(log.read_text().splitlines()) - before


@pytest.fixture(scope="module")
def filled(counting: Path, tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Kernels]:
    """A cache with the slider's library, compiled by `counting`; and the kernels."""
    folder = tmp_path_factory.mktemp("filled")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("XDG_CACHE_HOME", str(folder))
        patch.setenv("CC", f"'{counting}'")
        made = kernels_of(slider())
    return folder / "coscrew", made


@pytest.fixture(scope="module")
def compiled(filled: tuple[Path, Kernels]) -> Kernels:
    """The slider's kernels, compiled."""
    return filled[1]


@pytest.fixture(scope="module", params=("compiled", "NumPy"))
def kernels(request: pytest.FixtureRequest, compiled: Kernels,
            tmp_path_factory: pytest.TempPathFactory) -> Kernels:
    """The slider's kernels, compiled and not."""
    if request.param == "compiled":
        return compiled
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("XDG_CACHE_HOME", str(tmp_path_factory.mktemp("numpy")))
        patch.setenv("CC", "/no/such/compiler")
        with pytest.warns(RuntimeWarning, match="slider runs in pure NumPy: no C compiler"):
            return kernels_of(slider())


def test_libraries_are_compiled_once(counted, cache: Path):
    first = kernels_of(slider())
    assert first.compiled and counted() == 5  # both precisions and their calls, and a link
    again = kernels_of(slider())
    assert again.compiled and counted() == 5
    assert same_bits(first.double.forward_dynamics(*ARGUMENTS),
                     again.double.forward_dynamics(*ARGUMENTS))
    kernels_of(replace(slider(), neutral=(0.0, 0.5)))
    assert counted() == 8  # the same calls
    assert len(list(cache.rglob("*.so"))) == 2
    assert not list(cache.rglob(".*"))  # nothing left over from building


def test_other_compilers_make_libraries_of_their_own(cache: Path, monkeypatch):
    for number, compiler in enumerate(COMPILERS, 1):
        monkeypatch.setenv("CC", compiler)
        kernels = kernels_of(slider())
        assert kernels.compiled and "-ffp-contract=off" in kernels.compiler
        assert len(list(cache.rglob("*.so"))) == number


def test_a_level_of_optimization_in_cc_replaces_the_own(cache: Path, compiled: Kernels,
                                                         monkeypatch):
    monkeypatch.setenv("CC", f"{COMPILERS[-1]} -O0")
    kernels = kernels_of(slider())
    assert kernels.compiled and not re.search("-O[^0]", kernels.compiler)
    assert same_bits(kernels.double.forward_dynamics(*ARGUMENTS),
                     compiled.double.forward_dynamics(*ARGUMENTS))
    monkeypatch.setenv("CC", COMPILERS[-1])
    assert re.search("-O[12] ", str(compilation.compiler()))


def test_other_flags_and_processors_make_libraries_of_their_own(monkeypatch):
    def key(**changed: object) -> str:
        return compilation._key({}, {}, replace(using, **changed))

    using = compilation.compiler()
    assert key() == key()
    keys = {key(), key(flags=("-O0",)), key(version="another"), key(command=("another",))}
    monkeypatch.setattr(compilation, "_processor", lambda: "another")
    assert len(keys | {key()}) == 5


LOADING = """
import os, sys
from coscrew_codegen.runtime.load import kernels_of
from tests.support.scenes.generated_scenes import ARGUMENTS, slider

for base in sys.argv[1:]:
    os.environ["XDG_CACHE_HOME"] = base
    print(kernels_of(slider()).double.forward_dynamics(*ARGUMENTS).tolist(), flush=True)
"""


def test_damaged_libraries_are_made_again(counted, filled, tmp_path: Path, monkeypatch):
    """In another process, since opening a truncated library may end it.  Each damage has a cache of
    its own."""
    whole, kernels = filled
    library, = whole.rglob("*.so")
    content = library.read_bytes()
    damages = {"truncated": content[:len(content) // 2], "emptied": b"",
               "changed": content[:-1] + bytes([content[-1] ^ 1]), "replaced": b"no library"}
    for damage, bad in damages.items():
        folder = tmp_path / damage / "coscrew" / library.parent.name
        folder.mkdir(parents=True)
        (folder / library.name).write_bytes(bad)
    done = subprocess.run([sys.executable, "-W", "error", "-c", LOADING,
                           *(tmp_path / damage for damage in damages)], capture_output=True,
                          text=True, cwd=Path(__file__).parents[2])
    wanted = str(kernels.double.forward_dynamics(*ARGUMENTS).tolist())
    assert dict(zip(damages, done.stdout.splitlines(), strict=False)) == dict.fromkeys(
        damages, wanted), done.stderr
    assert not done.stderr and counted() == 5 * len(damages)
    for damage in damages:
        assert len(list((tmp_path / damage / "coscrew").rglob("*.so"))) == 1
        monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / damage))
        assert kernels_of(slider()).compiled and counted() == 5 * len(damages)


def test_a_cache_that_cannot_be_written_to_is_done_without(tmp_path: Path, monkeypatch):
    (tmp_path / "file").write_text("no folder")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "file"))
    assert kernels_of(pendulum()).compiled


@pytest.mark.parametrize("command", ("/no/such/compiler", "false", "sh -c 'exit 3'"))
def test_without_a_compiler_that_works_numpy_runs(compiled: Kernels, cache: Path, monkeypatch,
                                                  command: str):
    monkeypatch.setenv("CC", command)
    with pytest.warns(RuntimeWarning, match="slider runs in pure NumPy") as messages:
        twin = kernels_of(slider())
    assert messages[0].filename == __file__
    assert compiled.compiled and not twin.compiled and twin.compiler == ""
    assert dir(compiled.single) == dir(twin.single)
    for precision in ("double", "single"):
        for name in ("forward_dynamics", "inverse_dynamics"):
            assert same_bits(getattr(getattr(compiled, precision), name)(*ARGUMENTS),
                             getattr(getattr(twin, precision), name)(*ARGUMENTS))


def test_a_compiler_that_refuses_is_quoted(tmp_path: Path, cache: Path, monkeypatch):
    script = tmp_path / "refusing"
    script.write_text('#!/bin/sh\n[ "$1" = --version ] && echo refusing 1.0 && exit 0\n'
                      "echo 'licence expired' >&2\nexit 1\n")
    script.chmod(0o755)
    monkeypatch.setenv("CC", str(script))
    with pytest.warns(RuntimeWarning, match="(?s)refusing cannot compile:.*licence expired"):
        assert not kernels_of(pendulum()).compiled
    assert not list(cache.rglob(".building*"))


def test_processors_without_march_native_are_served(tmp_path: Path, cache: Path, monkeypatch):
    script = tmp_path / "plain"
    script.write_text('#!/bin/sh\ncase "$*" in *-march=native*) echo unknown >&2; exit 1;; esac\n'
                      f'exec {shutil.which(COMPILERS[0])} "$@"\n')
    script.chmod(0o755)
    monkeypatch.setenv("CC", str(script))
    assert kernels_of(pendulum()).compiled


@pytest.mark.parametrize("name, value, message", (
    ("q", [1.0, 2.0, 3.0], r"q: got shape \(3,\); wanted shape \(\.\.\., 2\)"),
    ("q", np.zeros(1), r"q: got shape \(1,\); wanted shape \(\.\.\., 2\)"),
    ("p", np.zeros(3), r"p: got shape \(3,\); wanted shape \(\.\.\., 2\)"),
    ("v", 1.0, r"v: got shape \(\); wanted shape \(\.\.\., 2\)"),
    ("tau", [[1.0], [2.0]], r"tau: got shape \(2, 1\); wanted shape \(\.\.\., 2\)"),
))
def test_wrong_shapes_are_named(kernels: Kernels, name: str, value: object, message: str):
    refused(kernels, name, value, ValueError, message)


NUMBERS = "float64, float32 or integers up to 64 bits"


class Tracer:
    """Like a tracer of JAX, which is neither an array nor a number."""

    def __array__(self, dtype=None, copy=None):
        raise TypeError("a traced array")

    __float__ = __array__


@pytest.mark.parametrize("name, value, message", (
    ("q", ["a", "b"], "got <U1"),
    ("v", [1j, 2j], "got complex128"),
    ("v", np.ones(2, np.longdouble), f"got {np.dtype(np.longdouble)}"),
    ("tau", np.ones(2, np.float16), "got float16"),
    ("q", np.ones(2, bool), "got bool"),
    ("v", np.zeros(2, "M8[s]"), r"got datetime64\[s\]"),
    ("q", np.ma.masked_array([1.0, 2.0], [True, False]), "got a masked array"),
    ("tau", [Fraction(1), Fraction(2)], r"got objects \(Fraction\)"),
    ("q", [[1.0, 2.0], [1.0]], "got list, which NumPy cannot convert"),
    ("q", Tracer(), r"got Tracer, which NumPy cannot convert \(a traced array\)"),
    ("t", Tracer(), r"got Tracer, which NumPy cannot convert \(a traced array\)"),
    ("t", None, r"got objects \(NoneType\)"),
    ("t", 1j, "got complex128"),
    ("t", True, "got bool"),
    ("t", np.longdouble(1), f"got {np.dtype(np.longdouble)}"),
    ("t", Fraction(1, 3), r"got objects \(Fraction\)"),
    ("t", 2**64, r"got objects \(int\)"),
))
def test_what_are_no_numbers_of_these_precisions_is_a_type_error(
        kernels: Kernels, name: str, value: object, message: str):
    refused(kernels, name, value, TypeError, f"{message}.*wanted .*{NUMBERS}.*")


def refused(kernels: Kernels, name: str, value: object, error: type[Exception], message: str):
    """Functions and steps of both precisions raise this error; `message` follows the function's
    name."""
    message = message if message.startswith(name) else f"{name}: {message}"
    given = (x if isinstance(x, float) else np.array(x) for x in ARGUMENTS)
    arguments = dict(zip(("t", "p", "q", "v", "tau"), given, strict=True)) | {name: value}
    with pytest.raises(error, match=f"^{message}$"):
        kernels.double.forward_dynamics(*arguments.values())
    with pytest.raises(error, match=f"^{message}$"):
        kernels.single.forward_dynamics(**arguments)
    if arguments.pop("tau") is not value:
        with pytest.raises(error, match=f"^{message}$"):
            kernels.double.step_semi_implicit_euler(h=0.1, **arguments)


def test_leading_axes_that_do_not_broadcast_are_named(kernels: Kernels):
    with pytest.raises(ValueError, match=r"leading axes do not broadcast: q \(3,\), phi \(4,\)"):
        kernels.double.integrated(np.zeros((3, 2)), np.zeros((4, 2)))


def test_missing_and_unknown_arguments_are_type_errors(kernels: Kernels):
    with pytest.raises(TypeError, match="swapped"):
        kernels.double.swapped()
    with pytest.raises(TypeError, match="swapped"):
        kernels.double.swapped([1.0, 2.0], [1.0, 2.0])
    with pytest.raises(TypeError, match="angle"):
        kernels.double.swapped([1.0, 2.0], angle=0.0)


def test_names_may_be_given(kernels: Kernels):
    names = ("t", "p", "q", "v", "tau")
    assert same_bits(kernels.double.forward_dynamics(**dict(zip(names, ARGUMENTS, strict=True))),
                     kernels.double.forward_dynamics(*ARGUMENTS))


def test_kernels_tell_what_their_arguments_hold(kernels: Kernels):
    functions = slider()
    assert (kernels.NQ, kernels.NV) == (2, 2)
    assert kernels.joints == tuple(c.joint for c in functions.coordinates)
    assert kernels.bodies == functions.bodies and kernels.parameters == dict(functions.parameters)
    assert kernels.neutral_q.tolist() == list(functions.neutral)


def test_kernels_of_a_file_tell_what_it_says(tmp_path: Path, cache: Path):
    path = tmp_path / "scene.toml"
    path.write_text(texts.SPRING)
    spring = coscrew_codegen.load_scene(path)
    assert (spring.NQ, spring.NV, spring.joints, spring.bodies) == (1, 1, ("slide",), ("block",))
    assert spring.parameters == {"block.mass": 2.0}
    assert spring.neutral_q.tolist() == [0.0]
    path.write_text(texts.BRICK)
    brick = coscrew_codegen.load_scene(str(path))
    assert (brick.NQ, brick.NV, brick.parameters) == (7, 6, {})
    assert brick.neutral_q.tolist() == [0, 0, 0, 0, 0, 0, 1]


@pytest.mark.parametrize("given, name", (({"bodies": {}}, "dict"), (None, "NoneType"), (3, "int")))
def test_what_is_no_scene_is_a_type_error(given: object, name: str):
    with pytest.raises(TypeError, match=f"wanted the path of a scene file, or a Scene; got {name}"):
        coscrew_codegen.load_scene(given)


def test_functions_are_found_by_name(kernels: Kernels):
    assert "step_rk4" in dir(kernels.double) and "implicit_acceleration" not in dir(kernels.double)
    assert list(kernels.double) == dir(kernels.double)
    with pytest.raises(AttributeError, match="slider in double precision has no function "
                                             "'forward_dynamic'; did you mean 'forward_dynamics'"):
        kernels.double.forward_dynamic
    assert "forward_dynamics" in repr(kernels.single) and "single" in repr(kernels.single)
    assert "slider" in repr(kernels)


def test_every_kind_of_number_is_taken(kernels: Kernels):
    wanted = kernels.double.forward_dynamics(*ARGUMENTS)
    t, p, q, v, tau = (np.array(x) for x in ARGUMENTS)
    for time in (2, 2.0, np.float32(2), np.int64(2), t):
        result = kernels.double.forward_dynamics(time, p, q, v, tau)
        assert same_bits(result, wanted), type(time)
    narrow = kernels.single.forward_dynamics(t, p, q, v, tau)
    assert narrow.dtype == np.float32
    assert same_bits(narrow, kernels.single.forward_dynamics(*(np.float32(x) for x in ARGUMENTS)))
    energy = kernels.double.energy(p, q, v)
    assert [type(x) for x in energy] == [np.float64, np.float64]


def test_threads_may_call_at_once(compiled: Kernels):
    t, p, _, v, tau = map(np.array, ARGUMENTS)
    states = np.random.default_rng(0).normal(size=(8, 20000, 2))
    wanted = [compiled.double.forward_dynamics(t, p, q, v, tau) for q in states]
    with ThreadPoolExecutor(8) as pool:
        results = list(pool.map(
            lambda q: compiled.double.forward_dynamics(t, p, q, v, tau), states))
    assert all(map(same_bits, results, wanted))


def test_processes_may_fill_the_cache_at_once(cache: Path):
    program = ("from coscrew_codegen.runtime.load import kernels_of\n"
               "from tests.support.scenes.generated_scenes import pendulum\n"
               "assert kernels_of(pendulum()).compiled")
    running = [subprocess.Popen([sys.executable, "-W", "error", "-c", program],
                                cwd=Path(__file__).parents[2]) for _ in range(2)]
    assert [x.wait() for x in running] == [0, 0]
    assert {x.suffix for x in cache.rglob("*.*")} == {".so", ".o"}


def test_generated_python_mends_itself(cache: Path, monkeypatch):
    monkeypatch.setenv("CC", "/no/such/compiler")
    for _ in range(2):
        with pytest.warns(RuntimeWarning):
            kernels = kernels_of(slider())
        assert kernels.double.swapped([1.0, 2.0]).tolist() == [2.0, 1.0]
        for path in cache.rglob("double.py"):
            path.write_text("broken (")


def test_importing_the_package_loads_nothing_heavy():
    program = ("import sys, coscrew_codegen\n"
               "print(sorted({'sympy', 'numpy', 'jinja2'} & set(sys.modules)))\n"
               "print(callable(coscrew_codegen.load_scene))\n")
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True,
                          check=True, env=dict(os.environ))
    assert done.stdout.splitlines() == ["[]", "True"]
    with pytest.raises(AttributeError, match="'load_scenes'"):
        coscrew_codegen.load_scenes


def test_the_nearest_compiler_is_preferred(monkeypatch):
    monkeypatch.delenv("CC", raising=False)
    wanted = next(x for x in ("clang", "gcc", "cc") if shutil.which(x))
    assert compilation.compiler().command == (wanted,)
    monkeypatch.setenv("PATH", "")
    with pytest.raises(compilation.CompilationError, match="clang, gcc, cc cannot be run"):
        compilation.compiler()
