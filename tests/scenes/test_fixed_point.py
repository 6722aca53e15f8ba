"""Functions of scenes in fixed point: bounds that hold at all states, no overflow, and the same
bits in compiled C, of every processor, as in NumPy's integers."""

import ctypes
import re
import subprocess
from collections import Counter
from dataclasses import replace
from fractions import Fraction
from math import inf
from pathlib import Path

import mpmath
import numpy as np
import pytest

from coscrew_codegen.__main__ import main
from coscrew_codegen.accuracy.fixed_scene import FixedFunction, FixedScene, in_fixed
from coscrew_codegen.accuracy.scene_tiers import NoFunctionsError
from coscrew_codegen.accuracy.tiers import tier_named
from coscrew_codegen.backends.fixed import scene_c_fixed
from coscrew_codegen.backends.output_files import scene_files
from coscrew_codegen.dynamics import derive
from coscrew_codegen.program import Constant, Op
from coscrew_codegen.program.fixed.fixed_arithmetic import sine_and_cosine
from coscrew_codegen.program.fixed.fixed_program import Products
from coscrew_codegen.runtime.load import load_scene
from coscrew_codegen.scene.readers.scene_error import SceneError
from coscrew_codegen.scene.readers.toml.toml_scene import SceneOverrides, read_scene
from tests.support.compiled.c_harness import COMPILERS, DIALECTS, STRICT, run
from tests.support.scenes import fixed_point as fx
from tests.support.truth.newton_euler import inverse_dynamics

GIMBAL = Path(__file__).parents[2] / "examples/fixed_point/gimbal.toml"
FIXED = tier_named("fixed")
COUNT = 2000
COMPILED = ("inverse_dynamics", "energy")
JUDGED = 1 + 1e-9  # constants err by as much as is stated; the judge rounds, too
each_products = pytest.mark.parametrize("products", Products, ids=lambda x: x.value)
each_function = pytest.mark.parametrize("name", fx.POLYNOMIAL)


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> FixedScene:
    """The arm of examples/cost, for the ranges of a comparison."""
    return in_fixed(derive(fx.panda(tmp_path_factory.mktemp("panda")), fx.POLYNOMIAL), FIXED)


@pytest.fixture(scope="module")
def small(made: FixedScene) -> FixedScene:
    """The functions that tests compile."""
    return replace(made, functions=tuple(named(made, x) for x in COMPILED))


@pytest.fixture(scope="module")
def gimbal() -> FixedScene:
    """A small scene, which selects the tier."""
    return in_fixed(derive(read_scene(GIMBAL)), FIXED)


def named(made: FixedScene, name: str) -> FixedFunction:
    return next(f for f in made.functions if f.plain.name == name)


# bounds


@each_function
@each_products
def test_errors_are_within_bounds_and_nothing_overflows(made, name, products):
    function = named(made, name)
    given, bounds = fx.states(function, COUNT), fx.bounds(function, products)
    assert (fx.errors(function, products, given) <= JUDGED * bounds[:, None]).all()
    fixed = function.programs[products]
    assert (fx.results(fixed, given, fx.checked(fixed.program)) == fx.results(fixed, given)).all()


@pytest.mark.parametrize(("products", "stated"), (
    (Products.FULL, 5.5e-6), (Products.HIGH, 1.1e-5)), ids=("full", "high"))
def test_bounds_of_torques_are_below_those_of_the_comparison(made, products, stated):
    """1e-3 N m there."""
    assert fx.bounds(named(made, "inverse_dynamics"), products).max() <= stated


@each_products
def test_climbing_from_the_worst_states_exceeds_no_bound(made, products):
    function = named(made, "inverse_dynamics")
    bounds = fx.bounds(function, products)
    start, end = (fx.worst(function, products, 256, rounds, 1) / bounds for rounds in (0, 20))
    assert start.max() < end.max() <= 1
    assert end.max() > 0.02


@each_products
def test_torques_are_within_bounds_of_newtons_and_eulers_laws(made, products, tmp_path):
    """The truth shares nothing with the generator but the model."""
    scene, function = fx.panda(tmp_path), named(made, "inverse_dynamics")
    given, fixed = fx.states(function, 8, 3), function.programs[products]
    torques, bounds = fx.results(fixed, given), fx.bounds(function, products)
    gravity = scene.effects[0].vector("g")
    for n in range(8):
        with mpmath.workdps(50):
            rows = [[mpmath.mpf(int(x[n])) / mpmath.mpf(2)**value.bits
                     for x, value in zip(parts, values, strict=True)]
                    for parts, values in zip(given, function.inputs, strict=True)]
            true = inverse_dynamics(scene.model, gravity, *rows)
            for made_, value, exact, bound in zip(torques[:, n], fixed.results, true, bounds,
                                                  strict=True):
                assert abs(mpmath.mpf(int(made_)) / mpmath.mpf(2)**value.bits - exact) <= bound


@each_products
def test_every_shift_that_is_off_by_one_exceeds_a_bound(made, products):
    """Shifts of terms that hardly matter excepted: those are less than a bound themselves."""
    function = named(made, "gravity_torques")
    fixed, given = function.programs[products], fx.states(function, 64)
    bounds, true = fx.bounds(function, products), fx.results(function.programs[products], given)
    unit = np.array([2.0**-x.bits for x in fixed.results])
    unnoticed, count = [], 0
    for number, step in enumerate(fixed.program.instructions):
        place = {Op.ROUNDED_SHIFT: 1, Op.WIDE_PRODUCT: 2}.get(step.op)
        if place is None:
            continue
        shift = int(step.operands[place].double)
        other = fx.with_constant(fixed, number, place, shift + 1)
        moved = np.abs(fx.results(other, given) - true).max(1) * unit
        count += 1
        if not (moved > 2 * bounds).any():
            unnoticed.append(step.name)
    assert count > 20
    assert len(unnoticed) <= count // 20, unnoticed


def test_constants_are_nearest_to_the_models_decimals(made):
    """Each integer is a constant of the plain program times a power of two, rounded."""
    for function in made.functions:
        known = {abs(round(x.double * Fraction(2)**bits)) for bits in range(-10, 62)
                 for step in function.plain.program.instructions
                 for x in step.operands if isinstance(x, Constant)}
        for fixed in function.programs.values():
            for step in fixed.program.instructions:
                if step.op not in (Op.HIGH_PRODUCT, Op.ADD, Op.SUB):
                    continue
                assert all(abs(x.double) in known for x in step.operands
                           if isinstance(x, Constant)), step.name


# the same bits everywhere


@each_products
@pytest.mark.parametrize(("compiler", "flags"), (
    (COMPILERS[0], ("-O2",)), (COMPILERS[-1], ("-O1", "-DCOSCREW_FIXED_HALVES"))),
    ids=("wide", "halves"))
def test_compiled_c_has_the_bits_of_numpy(small, products, compiler, flags, tmp_path):
    for name in COMPILED:
        folder, function = tmp_path / name, named(small, name)
        folder.mkdir()
        given = fx.states(function, COUNT)
        results = fx.compiled(small, function, products, folder, given, (
            compiler, "-std=c11", *STRICT, *flags))
        assert (results == fx.results(function.programs[products], given)).all()


@pytest.mark.parametrize(("compiler", "language"), DIALECTS, ids=lambda x: " ".join(x))
def test_files_compile_without_warnings(small, compiler, language, tmp_path):
    fx.written(small, tmp_path)
    for path in sorted(tmp_path.glob("*.c")):
        run((compiler, *language, *STRICT, "-O0", "-c", path, "-o", "/dev/null"))


@each_products
@pytest.mark.parametrize("flags", ((), ("-DCOSCREW_FIXED_HALVES",)), ids=("wide", "halves"))
def test_the_sanitizer_finds_no_undefined_behaviour(small, products, flags, tmp_path):
    made, function = small, named(small, "inverse_dynamics")
    given = fx.states(function, COUNT)
    fx.written(made, tmp_path)
    (tmp_path / "main.c").write_text(fx.many(made, function, products) + _MAIN)
    run(("gcc", "-O1", "-g", "-fsanitize=undefined", "-fno-sanitize-recover=all", *flags, "-I",
         tmp_path, tmp_path / "main.c", tmp_path / f"{made.stem}{fx.MARKS[products]}.c", "-o",
         tmp_path / "main"))
    rows = b"".join(np.stack(parts).T.astype(np.int32).tobytes() for parts in given)
    done = subprocess.run([tmp_path / "main"], input=rows, capture_output=True)
    assert (done.returncode, done.stderr) == (0, b"")
    results = np.frombuffer(done.stdout, np.int32).reshape(COUNT, -1).T
    assert (results == fx.results(function.programs[products], given)).all()


_MAIN = f"""#include <stdio.h>
static int32_t given[3][{COUNT} * 7], made[{COUNT} * 7];
int main(void) {{
  if (fread(given, sizeof given, 1, stdin) != 1) return 2;
  many({COUNT}, given[0], given[1], given[2], made);
  return fwrite(made, sizeof made, 1, stdout) != 1;
}}
"""


# text


def literals(body: str) -> list[re.Match[str]]:
    """The shifts and constants of a body: indices excepted."""
    return list(re.finditer(r"(?<![\w\[.])-?\d+(?![\w\]])", body))


@each_products
def test_every_number_of_the_text_that_changes_is_noticed(gimbal, products):
    """The text is read as Python, which spells these expressions alike, with every number changed
    in turn, by one or by a millionth: a value or a result differs.  Constants are the Program's."""
    function = named(gimbal, "inverse_dynamics")
    mark = fx.MARKS[products]
    (text,) = re.findall(rf"\nvoid gimbal_inverse_dynamics_fixed{mark}\([^{{]*{{\n(.*?)\n}}\n",
                         scene_c_fixed.files(gimbal, "")[f"gimbal_fixed{mark}.c"], re.DOTALL)
    body, given = re.sub(r"/\*.*?\*/", "", text), fx.states(function, 300)
    true = _read(body, given)
    assert (true["tau"] == fx.results(function.programs[products], given)).all()
    places = literals(body)
    assert len(places) > 100
    assert Counter(x for x in (abs(int(place[0])) for place in places) if x > 2**16) == Counter(
        int(abs(x.double)) for step in function.programs[products].program.instructions
        for x in step.operands if isinstance(x, Constant) and abs(x.double) > 2**16)
    for place in places:
        number = int(place[0]) + max(1, abs(int(place[0])) >> 20)
        changed = body[:place.start()] + str(number) + body[place.end():]
        other = _read(changed, given)
        assert any((other[name] != x).any() for name, x in true.items()), \
            body[place.start() - 40:place.end() + 40]


def _read(body: str, given: list[list[np.ndarray]]) -> dict[str, np.ndarray]:
    """The values of a body's variables and results, for these arguments."""
    known = {"tau": np.zeros_like(np.stack(given[0])), "ksl_sincos_fixed": sine_and_cosine,
             "ksl_high_product": lambda a, b: (a * b + 2**31) // 2**32,
             "ksl_wide_product": lambda a, b: a * b,
             "ksl_rounded_shift": lambda x, s: (x + 2**s // 2) // 2**s,
             "ksl_narrow": lambda x, s: (x + 2**s // 2) // 2**s,
             **{name: np.stack(parts) for name, parts in zip("qva", given, strict=True)}}
    flat = re.sub(r"\s+", " ", body).replace("(int32_t)", "").replace("(void)", "")
    for statement in filter(None, map(str.strip, flat.split(";"))):
        if statement.startswith("int32_t "):
            continue
        for part in re.split(r", (?=\w+ = )", statement.removeprefix("const int32_t ")):
            name, _, text = part.partition(" = ")
            if cosine := re.search(r", &(\w+)\)", text):
                known[name], known[cosine[1]] = eval(text.replace(cosine[0], ")"), known)
            elif "[" in name:
                exec(part, known)
            else:
                known[name] = eval(text, known)
    return {name: np.array(x) for name, x in known.items()
            if isinstance(x, (np.ndarray, np.integer))}


# selection


def test_the_tier_needs_ranges(tmp_path):
    with pytest.raises(SceneError, match=r"tiers: the fixed tier needs the ranges of arguments; "
                                         r"wanted \[ranges\] with the largest sizes"):
        fx.panda(tmp_path, ranges="")
    with pytest.raises(SceneError, match="needs the ranges"):
        read_scene(fx.PANDA, overrides=SceneOverrides(tiers=("fixed",)))
    alone = replace(derive(read_scene(fx.PANDA), ("energy",)), tiers=("fixed",))
    with pytest.raises(NoFunctionsError, match="the fixed tier needs the ranges of arguments"):
        in_fixed(alone, FIXED)


def test_other_functions_are_left_out_with_their_reasons(tmp_path):
    names = ("gravity_torques", "forward_dynamics", "integrated")
    result = in_fixed(derive(fx.panda(tmp_path), names), FIXED)
    assert [f.plain.name for f in result.functions] == ["gravity_torques"]
    assert dict(result.left_out) == {
        "forward_dynamics": "it is no polynomial of its arguments, their sines and cosines (div)",
        "integrated": "the scene states no range of phi"}
    text = " ".join(scene_c_fixed.files(result, "")["panda_fixed.h"].split())
    assert "Left out: forward_dynamics: it is no polynomial of its arguments" in text
    with pytest.raises(NoFunctionsError, match="none of the selected functions: forward_dynamics"):
        in_fixed(derive(fx.panda(tmp_path), ("forward_dynamics",)), FIXED)


def test_unbounded_arguments_leave_functions_out(tmp_path):
    scene = fx.panda(tmp_path, "\n[ranges]\nv = 1\n")
    result = in_fixed(derive(scene, ("inverse_dynamics", "energy")), FIXED)
    assert dict(result.left_out) == {"inverse_dynamics": "the scene states no range of a"}


def test_arguments_have_the_same_bits_in_all_functions(made):
    for function in made.functions:
        for a, values in zip(function.plain.inputs, function.inputs, strict=True):
            assert [x.bits for x in values] == [x.bits for x in made.arguments[a.name]]
    assert all(x.bits <= 30 for x in made.arguments["q"])


def test_scenes_without_the_tier_have_no_trace_of_it(tmp_path):
    without = scene_files(derive(fx.panda(tmp_path, tiers=""), ("energy",)))
    plain = scene_files(derive(read_scene(fx.PANDA), ("energy",)))
    assert without.keys() == plain.keys() and not any("fixed" in path for path in plain)
    with_tier = scene_files(derive(fx.panda(tmp_path), ("energy",)))
    rest = {path: text.replace(", fixed", "").replace("'double', 'single', 'fixed'",
                                                      "'double', 'single'")
            for path, text in with_tier.items() if "fixed" not in path}
    assert rest == without


# conversions


def test_conversions_round_and_stay_in_the_ranges(small, tmp_path):
    fx.written(small, tmp_path)
    library = tmp_path / "double.so"
    run((COMPILERS[0], "-O1", "-fsanitize=undefined", "-fsanitize-undefined-trap-on-error",
         "-shared", "-fPIC", "-I", tmp_path, tmp_path / "panda_fixed.c",
         tmp_path / "panda_fixed_double.c", "-o", library, "-lm"))
    opened, values = ctypes.CDLL(str(library)), small.arguments["v"]
    for numbers, fits in (([0.5, -0.5, 0.1, -0.1, 0, 1e-9, 0.3], 1),
                          ([0.5, 0.51, -7, 1e300, -inf, np.nan, 0], 0)):
        given, result = np.array(numbers, float), np.zeros(7, np.int32)
        pointers = (x.ctypes.data_as(ctypes.c_void_p) for x in (given, result))
        assert opened.panda_v_to_fixed(*pointers) == fits
        inside = np.clip(np.nan_to_num(given, nan=0), -0.5, 0.5)
        assert list(result) == [int(np.floor(x * 2.0**y.bits + 0.5))
                                for x, y in zip(inside, values, strict=True)]
        assert opened.panda_energy_fixed_fits(
            *(x.ctypes.data_as(ctypes.c_void_p) for x in (np.zeros(7, np.int32), result))) == 1
    again = np.zeros(2)
    energy = named(small, "energy").programs[Products.FULL].results
    integers = np.array([12345, -2**31 + 2], np.int32)
    opened.panda_energy_fixed_to_double(*(x.ctypes.data_as(ctypes.c_void_p)
                                          for x in (integers, again)))
    assert list(again) == [int(x) * 2.0**-y.bits for x, y in zip(integers, energy, strict=True)]
    result[3] = int(values[3].largest) + 1
    assert opened.panda_energy_fixed_fits(
        *(x.ctypes.data_as(ctypes.c_void_p) for x in (np.zeros(7, np.int32), result))) == 0


# Python


@each_products
def test_python_has_the_bits_of_the_interpreter_and_broadcasts(gimbal, products):
    module = load_scene(GIMBAL).fixed
    for function in gimbal.functions:
        given = fx.states(function, 60)
        rows = [np.stack(parts, -1).reshape(5, 12, -1).astype(np.int32) for parts in given]
        result = getattr(module, function.plain.name + fx.MARKS[products])(*rows)
        shape = function.plain.program.outputs[0].quantity.shape
        assert result.shape == (5, 12, *shape) and result.dtype == np.int32
        true = fx.results(function.programs[products], given)
        assert (true == result.reshape(60, -1).T).all()


def test_python_converts_and_refuses_what_is_outside(gimbal):
    module = load_scene(GIMBAL).fixed
    q, v, a = (module.to_fixed(*x) for x in (
        ("q", [1, -0.5, 0.3]), ("v", np.ones(3)), ("a", [[1, 2, 3], [4, 5, 6]])))
    tau = module.to_double("inverse_dynamics", "tau", module.inverse_dynamics(q, v, a))
    plain = load_scene(GIMBAL).double.inverse_dynamics([1, -0.5, 0.3], np.ones(3),
                                                       [[1, 2, 3], [4, 5, 6]])
    assert np.abs(tau - plain).max() < 1e-7
    with pytest.raises(ValueError, match="v: outside its range, sizes up to"):
        module.to_fixed("v", [7, 0, 0])
    with pytest.raises(ValueError, match="a: outside its range, integers up to"):
        module.inverse_dynamics(q, v, np.full(3, 2**31 - 1))
    with pytest.raises(TypeError, match="q: got float64; wanted integers"):
        module.inverse_dynamics(np.zeros(3), v, a)
    with pytest.raises(ValueError, match="q: got shape"):
        module.inverse_dynamics(np.zeros(2, int), v, a)


def test_the_snippet_of_the_guide_prints_what_its_comment_says(tmp_path):
    guide = (GIMBAL.parents[2] / "docs/fixed_point.md").read_text(encoding="utf-8")
    (snippet,) = re.findall(r"```c\n(.*?)```", guide, re.DOTALL)
    (tmp_path / "program.c").write_text(snippet)
    assert main(["generate", str(GIMBAL), "-o", str(tmp_path)]) == 0
    sources = ("program.c", "gimbal_fixed.c", "gimbal_fixed_double.c")
    run((COMPILERS[0], "-std=c99", "-Wall", "-Wextra", "-Werror", "-I", tmp_path,
         *(tmp_path / x for x in sources), "-o", tmp_path / "program", "-lm"))
    (printed,) = re.findall(r"/\* (.*?) \*/", snippet)
    assert run((tmp_path / "program",)).strip() == printed
