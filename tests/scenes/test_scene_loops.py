"""Loops of scenes' C, over sines and cosines and over results that are alike, have the bits of the
same statements one by one, as NumPy computes them; outputs may still overlap inputs."""

import ctypes
import re
from pathlib import Path

import numpy as np
import pytest

from coscrew_codegen.backends.c.c_stores import Layout, Stores
from coscrew_codegen.backends.nesting import Assignment
from coscrew_codegen.backends.python_extension import scene_calls
from coscrew_codegen.backends.scene import scene_c
from coscrew_codegen.dynamics import derive
from coscrew_codegen.program import Op
from coscrew_codegen.program.scene_functions import SceneFunctions
from coscrew_codegen.program.values.formats import DOUBLE
from coscrew_codegen.runtime.load import kernels_of
from coscrew_codegen.scene.mechanism.model import HERE
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from tests.support.compiled.c_harness import C11, STRICT, run
from tests.support.each import each_compiler, each_precision
from tests.support.scenes.generated_scenes import BANNER, Writer, argument, imported
from tests.support.scenes.kinds import Kind
from tests.support.scenes.mechanisms import Y, Z, at, chain, gravity, inertia, scene
from tests.support.scenes.scene_values import inputs, same_bits

EXAMPLES = Path(__file__).parents[2] / "examples" / "scenes"
KINDS = {"R": Kind.REVOLUTE, "P": Kind.PRISMATIC, "F": Kind.FREE}
CHAINS = ("RR", "RRRR", "RRRRR", "RRRRRRR", "RRRRRRRRR", "RPRR", "RPPPPR", "FRRRRRRRR")
"""One to three calls of four angles, and one to three angles more; angles that are no neighbours;
angles behind a quaternion."""
FUNCTIONS = ("inverse_dynamics", "forward_dynamics", "mass_matrix", "body_poses", "integrated",
             "step_rk4", "step_leapfrog")


def of_kinds(kinds: str) -> SceneFunctions:
    """A chain of joints of these kinds."""
    links = [(KINDS[kind], (Y, Z)[n % 2], at(0, 0, 1) if n else HERE,
              inertia(1 + n, (n % 3, 1, 0), (1, 2, 2, 0, 0, 0))) for n, kind in enumerate(kinds)]
    return derive(scene(chain(*links, name=kinds.lower()), gravity()), FUNCTIONS)


@pytest.mark.parametrize("kinds", CHAINS)
def test_loops_have_the_bits_of_statements_one_by_one(kinds: str, tmp_path: Path,
                                                      monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    functions = of_kinds(kinds)
    kernels, package = kernels_of(functions), imported(functions, tmp_path)
    assert kernels.compiled
    for precision in ("double", "single"):
        for f in scene_calls.callables(functions):
            given = inputs(f, {"double": "f8", "single": "f4"}[precision], 30)
            for (name, _), values in zip(f.inputs, given, strict=True):
                if name == "h":
                    values[...] = 2.0**-8
                if name == "q" and kinds[0] == "F":
                    values[:, 3:7] /= np.linalg.norm(values[:, 3:7], axis=-1, keepdims=True)
            result, wanted = (getattr(getattr(x, precision), f.name)(*given)
                              for x in (kernels, package))
            assert same_bits(result, wanted), (f.name, precision)


@each_precision
@each_compiler
def test_results_of_a_loop_may_overlap_what_it_reads(compiler: str, precision, tmp_path: Path):
    """q ⊕ phi, into memory that begins one number before, at, or after each of them."""
    functions = of_kinds("RRRRRR")
    for name, text in scene_c.files(functions, BANNER).items():
        (tmp_path / name).write_text(text)
    source = f"rrrrrr{precision.suffix}.c"
    text = (tmp_path / source).read_text()
    assert "qo_0_to_5[i] = q[i] + phi[i];" in text
    run((compiler, *C11, *STRICT, "-O2", "-shared", "-fPIC", tmp_path / source, "-o",
         tmp_path / "x.so", "-lm"))
    call = getattr(ctypes.CDLL(str(tmp_path / "x.so")), f"rrrrrr_integrated{precision.suffix}")
    kind = np.dtype(precision.numpy_type)
    q, phi = np.random.default_rng(1).normal(size=(2, 6)).astype(kind)
    for which in range(2):
        for shift in (-1, 0, 1):
            memory = np.zeros(8, kind)
            memory[1:7] = (q, phi)[which]
            given = [q, phi]
            given[which] = memory[1:7]
            call(*(ctypes.c_void_p(x.ctypes.data) for x in (*given, memory[1 + shift:])))
            assert (memory[1 + shift:7 + shift] == q + phi).all(), (which, shift)


def lines_of(results: list[str], inputs: tuple[str, ...], in_place: bool) -> list[str]:
    """The stores of y[0], y[1], … by these instructions: 'v+a' of the elements in turn, '2' the
    constant."""
    w, made = Writer(*(argument(x, 9) for x in inputs)), []
    for n, text in enumerate(results):
        if text.isdigit():
            made.append(int(text))
            continue
        left, right = (w.at(x[0], int(x[1:] or n)) for x in text.split("+"))
        made.append(w.do(f"r_{n}", Op.ADD, left, right))
    function = w.function("f", "f", (argument("vo", len(made)),), made)
    program = function.program
    texts = {f"r_{n}": f"{' + '.join(f'{x[0]}[{int(x[1:] or n)}]' for x in text.split('+'))}"
             for n, text in enumerate(results) if "+" in text}
    assigned = [Assignment(step, texts[step.name]) for step in program.instructions]
    shown = [f"r_{n}" if "+" in x else f"{x}.0" for n, x in enumerate(results)]
    stores = Stores(program, assigned, shown, [f"vo[{n}]" for n in range(len(made))],
                    Layout({"vo": 3}, in_place), DOUBLE)
    return [row for line in stores.statements({}, 98) for row in line.split("\n")]


def test_neighbours_that_are_alike_are_a_loop():
    assert lines_of(["v+a"] * 4, ("v", "a"), True) == [
        "for (int i = 0; i < 4; ++i) {", "  vo[i] = v[i] + a[i];", "}"]
    assert lines_of(["a0+a1", "v+a5", "v+a5", "v+a5"], ("v", "a"), True) == [
        "vo[0] = r_0;", "for (int i = 1; i < 4; ++i) {", "  vo[i] = v[i] + a[5];", "}"]
    assert lines_of(["0"] * 7, ("v",), False) == [
        "for (int i = 0; i < 7; ++i) {", "  vo[i] = 0.0;", "}"]


def test_few_and_those_that_differ_stand_in_rows():
    assert lines_of(["v+a", "v+a", "a+v", "0", "0"], ("v", "a"), True) == [
        "vo[0] = r_0; vo[1] = r_1; vo[2] = r_2;", "vo[3] = 0.0; vo[4] = 0.0;"]


def test_what_an_output_in_place_would_overwrite_is_read_before():
    """v is vo: a loop that reads v[0], or v one further, would read what it has written."""
    for shifted in (["v0+a"] * 4, ["v1+a", "v2+a", "v3+a", "v4+a"]):
        assert lines_of(shifted, ("v", "a"), True) == [
            "vo[0] = r_0; vo[1] = r_1; vo[2] = r_2;", "vo[3] = r_3;"]
        assert "double vo_0_to_3[4];" in lines_of(shifted, ("v", "a"), False)


def test_a_scenes_text_is_as_a_person_would_write_it():
    files = scene_c.files(derive(read_scene(EXAMPLES / "quadruped.toml")), BANNER)
    for path, f in (("quadruped.c", ""), ("quadrupedf.c", "f")):
        text = files[path]
        assert "for (int i = 7; i < 19; i += 4) {\n" in text
        assert f"ksl_sincos_4{f}(q[i], q[i + 1], q[i + 2], q[i + 3], &sin_q[i], &cos_q[i]);" in text
        assert "cos_q[18]" in text and "sines_of" not in text
        assert not re.search(r"\w+_(?:kick|drift|time)_\d", text)
        alike = re.sub(r"\d+", "", text).split("\n")
        assert not any(len({*alike[n:n + 6]}) == 1 and alike[n].strip() for n in range(len(alike)))
    arm = scene_c.files(derive(read_scene(EXAMPLES / "arm6.toml")), BANNER)["arm6.c"]
    assert "static void arm6_rk4_velocity(double h, const double v[6]," in arm
