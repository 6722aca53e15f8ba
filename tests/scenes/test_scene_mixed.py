"""The mixed tier: single precision, in pairs where a requested accuracy needs them.

Its errors at states that played no part in its choice are compared with a Newton-Euler method of
the tests' own in 60 digits; its bits are the same in C, NumPy and in the evaluation that chooses.
"""

import hashlib
import importlib
import json
import os
import re
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import mpmath
import numpy as np
import pytest

from coscrew_codegen.__main__ import main
from coscrew_codegen.accuracy.precision_tuning.array_evaluation import arrays, evaluator
from coscrew_codegen.accuracy.precision_tuning.choice import AccuracyError, chosen, operations
from coscrew_codegen.accuracy.precision_tuning.sample import States
from coscrew_codegen.accuracy.scene_tiers import NoFunctionsError, in_tier
from coscrew_codegen.accuracy.tiers import tier_named
from coscrew_codegen.accuracy.tiers.accurate_scene import in_pairs
from coscrew_codegen.accuracy.tiers.certified_wide import in_double
from coscrew_codegen.accuracy.tiers.mixed import Mixture, mixed
from coscrew_codegen.backends import emit
from coscrew_codegen.backends.output_files import scene_files
from coscrew_codegen.dynamics import derive
from coscrew_codegen.dynamics.ranges.accuracy_requests import RequestError, positions
from coscrew_codegen.program import Instruction, Op, Program
from coscrew_codegen.program.scene_functions import FunctionProgram, SceneFunctions
from coscrew_codegen.program.values.digits import two_digits_up
from coscrew_codegen.program.values.formats import DOUBLE, SINGLE
from coscrew_codegen.runtime import callables, compilation, source_text
from coscrew_codegen.scene.functions import FUNCTIONS
from coscrew_codegen.scene.functions.loops import closure
from coscrew_codegen.scene.mechanism.model import Joint
from coscrew_codegen.scene.readers.scene_error import SceneError
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.scene.scene import Scene, Tolerance
from coscrew_codegen.scene.scene_function import Of
from tests.support.compiled.c_harness import C11, COMPILERS, STRICT, run
from tests.support.scenes import mechanisms as m
from tests.support.scenes.arms import arm, inverse
from tests.support.scenes.kinds import Kind
from tests.support.scenes.scene_values import same_bits

MIXED = tier_named("mixed")
NAME, WITHIN = "inverse_dynamics", 1e-6
SHOULDER = replace(arm(), joints=arm().joints[:3], bodies=arm().bodies[:3])
SCENE = Scene("mixed_arm", SHOULDER, (m.gravity(),), functions=(NAME,), tiers=("mixed",),
              accuracy=(Tolerance(NAME, "", WITHIN),))
FRESH = 100

CHECKS = callables.checks(source_text.checks())


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Iterator[tuple[SceneFunctions, Path]]:
    """The arm's functions, and the folder of its files."""
    path, functions = tmp_path_factory.mktemp("mixed"), derive(SCENE)
    emit.write(scene_files(functions), path)
    sys.path.insert(0, str(path))
    yield functions, path
    sys.path.remove(str(path))


def drawn(functions: SceneFunctions, count: int) -> list[list[np.ndarray]]:
    """Components of states within the limits; none is one of those of the choice."""
    f, rng = functions.named(NAME), np.random.default_rng(5)
    return [[rng.uniform(low, high, count).astype(np.float32) for low, high in each]
            for each in f.accuracy.ranges]


def test_errors_at_fresh_states_are_within_what_is_asked(made):
    functions, _ = made
    given, f = drawn(functions, FRESH), functions.named(NAME)
    choice = chosen(f.program, f.accuracy)
    result = np.stack(evaluator(choice.program, SINGLE)(given), 1)
    true = [inverse(SCENE.model, *(np.stack([x[k] for x in each]) for each in given))
            for k in range(FRESH)]
    assert largest(result, true).max() <= WITHIN
    assert max(choice.worst) <= WITHIN


def test_a_search_between_the_limits_finds_no_larger_error(made):
    """By steps of its own, in a random sequence of its own; it finds larger ones of plain."""
    f = made[0].named(NAME)
    choice = chosen(f.program, f.accuracy)
    low, high = (np.array([pair[k] for each in f.accuracy.ranges for pair in each])[:, None]
                 for k in (0, 1))
    result, plain = (searched(f, p, low, high) for p in (choice.program, f.program))
    assert result <= WITHIN < plain / 1.5


def searched(f: FunctionProgram, program: Program, low: np.ndarray, high: np.ndarray) -> float:
    """The largest error found by steps that shrink, against the plain program in double."""
    rng, parts = np.random.default_rng(3), np.cumsum([len(x) for x in f.accuracy.ranges])[:-1]
    single, double = evaluator(program, SINGLE), evaluator(f.program, DOUBLE)
    best = rng.uniform(low, high, (len(low), 4096)).astype(np.float32)
    for number in range(20):
        given = np.split(best, parts)
        errors = np.abs(np.stack(single(given)) - np.stack(double(
            [x.astype(float) for x in given]))).max(axis=0)
        kept = best[:, np.argsort(-errors)[:64]]
        steps = rng.normal(size=best.shape) * (rng.random(best.shape) < 0.25) * 0.8**number
        best = np.clip(np.tile(kept, 64) + 0.2 * (high - low) * steps, low, high)
        best = np.concatenate((kept, best[:, 64:]), axis=1).astype(np.float32)
    return float(errors.max())


def largest(result: np.ndarray, true: list[list[mpmath.mpf]]) -> np.ndarray:
    with mpmath.workdps(60):
        return np.array([[float(abs(mpmath.mpf(float(x)) - y)) for x, y in zip(*row, strict=True)]
                         for row in zip(result, true, strict=True)])


def test_certified_bounds_hold_at_their_states(made):
    functions, _ = made
    f = functions.named(NAME)
    program = chosen(f.program, f.accuracy).program
    sample = States(f.accuracy, in_double(f.program)).drawn(20)
    result = np.stack(evaluator(program, SINGLE)(sample.given), 1)
    true = [inverse(SCENE.model, *(np.stack([x[k] for x in each]) for each in sample.given))
            for k in range(20)]
    assert (largest(result, true) <= sample.certified(program).T).all()


@pytest.mark.parametrize("compiler", COMPILERS)
def test_bits_are_the_same_in_c_in_numpy_and_in_the_choice(made, compiler: str, tmp_path: Path,
                                                            monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    functions, path = made
    tier = in_tier(functions, MIXED)
    flags = ("-O3", "-march=native", "-ffp-contract=fast")
    run([compiler, *C11, *STRICT, *flags, "-c", path / f"{tier.stem}f.c", "-o", tmp_path / "x.o"])
    using = compilation.Compiler((compiler,), compiler, ("-fPIC", *flags))
    text = source_text.of_one(tier)
    library = compilation.library(text.units(("single",)), text.files, using)
    value = text.interface
    twin = importlib.import_module(f"{functions.name}.mixed.single")
    given = drawn(functions, 500)
    columns = [np.stack(each, 1) for each in given]
    call = callables.compiled(value, library.opened, CHECKS, value.signatures[0], SINGLE)
    result = call(None, *columns)
    assert same_bits(result, twin.inverse_dynamics(*columns))
    chosen_at = evaluator(tier.first.named(NAME).program, SINGLE)(given)
    assert same_bits(result, np.stack(chosen_at, 1))


def test_operations_lie_between_those_of_single_and_of_pairs(made):
    """The comment says how many; a looser accuracy takes fewer, and one that single has, none
    more."""
    f = made[0].named(NAME)
    choice = chosen(f.program, f.accuracy)
    counts = [operations(p) for p in (f.program, choice.program, choice.pairs)]
    assert counts[0] < counts[1] < counts[2] / 1.5
    words = (made[1] / "mixed_arm_mixed.h").read_text()
    assert all(f"{count:,}" in words for count in counts), words
    loose = chosen(f.program, replace(f.accuracy, tolerances=(1.0,) * 3))
    assert loose.program.counts == f.program.counts and loose.paired == 0


TEXT = """
import sys, hashlib
from tests.scenes.test_scene_mixed import SCENE
from coscrew_codegen.backends.output_files import scene_files
from coscrew_codegen.dynamics import derive
print(hashlib.sha256(scene_files(derive(SCENE))["mixed_arm_mixedf.c"].encode()).hexdigest())
"""


def test_text_is_the_same_for_every_hash_seed(made):
    mine = hashlib.sha256((made[1] / "mixed_arm_mixedf.c").read_bytes()).hexdigest()
    there = subprocess.run([sys.executable, "-c", TEXT], capture_output=True, text=True, check=True,
                           cwd=Path(__file__).parents[2],
                           env={**os.environ, "PYTHONHASHSEED": "4242"}).stdout.strip()
    assert there == mine


TARGET = """[effects.actuator.hinge]
kind = "pd"
kp = 300
kd = 30
target = "0.5*sin(2.1*pi*t)"
"""


def test_all_in_pairs_is_as_accurate_as_pairs(tmp_path: Path):
    """Sines of computed angles, which are made of several instructions, too."""
    file = tmp_path / "rod.toml"
    file.write_text(HEAD.replace("[accuracy]", TARGET))
    program = derive(read_scene(file)).named(NAME).program
    places = [(x.name, n) for x in program.instructions for n in range(len(x.operands))]
    every = Mixture(frozenset(x.name for x in program.instructions), frozenset(places))
    rng = np.random.default_rng(6)
    given = [[rng.uniform(-3, 3, 1000).astype(np.float32)] for _ in program.inputs]
    result, pairs = (np.stack(evaluator(p, SINGLE)(given))
                     for p in (mixed(program, every), in_pairs(program, SINGLE)))
    assert "sin" in {x.op.value for x in program.instructions}
    assert np.array_equal(result, pairs)


def test_an_accuracy_that_pairs_do_not_have_is_refused():
    scene = replace(SCENE, accuracy=(Tolerance(NAME, "tau", 1e-9),))
    with pytest.raises(AccuracyError,
                       match=r"accuracy of inverse_dynamics: 1e-09 is requested for tau; "
                             r"even pairs of floats, rounded at the end, err by"):
        in_tier(derive(scene), MIXED)


def test_an_unknown_output_is_refused():
    scene = replace(SCENE, accuracy=(Tolerance(NAME, "taus", 1e-4),))
    with pytest.raises(RequestError, match="accuracy.inverse_dynamics: no output 'taus'; did you "
                                         "mean 'tau'?"):
        derive(scene)


def test_a_package_names_the_modules_that_it_has(made):
    package = importlib.import_module(made[0].name)
    with pytest.raises(AttributeError, match="no attribute 'pairs'; its modules: double, single, "
                                             "mixed$"):
        package.pairs  # noqa: B018
    with pytest.raises(AttributeError, match="no attribute 'double'; its modules: single$"):
        package.mixed.double  # noqa: B018


def test_torques_without_limits_are_refused():
    scene = replace(SCENE, functions=("forward_dynamics",),
                    accuracy=(Tolerance("forward_dynamics", "", 1e-4),))
    with pytest.raises(RequestError, match="joint 'j0' has no limit of its effort"):
        derive(scene)


def test_the_tier_needs_an_accuracy():
    with pytest.raises(NoFunctionsError, match=r"the mixed tier needs a function .* \[accuracy\]"):
        in_tier(derive(replace(SCENE, accuracy=())), MIXED)


HEAD = """
functions = ["inverse_dynamics", "energy"]
[bodies.rod]
mass = 1
com = [0, 0, 0.5]
inertia = [0.1, 0.1, 0.01]
[joints.hinge]
type = "revolute"
child = "rod"
axis = [0, 1, 0]
[effects.gravity]
[accuracy]
"""


@pytest.mark.parametrize("line, where, words", [
    ("inverse_dynamic = 1e-5", "accuracy.inverse_dynamic", "did you mean 'inverse_dynamics'?"),
    ("step_rk4 = 1e-5", "accuracy.step_rk4", "steps have no tier"),
    ("inverse_dynamics = 0", "accuracy.inverse_dynamics", "0; wanted a positive number"),
    ("energy = { e = -1e-5 }", "accuracy.energy.e", "-1e-05; wanted a positive number"),
    ("energy = 'small'", "accuracy.energy",
     "unknown name 'small'; wanted a number, in the unit of the results"),
    ("energy = '1e-5*t'", "accuracy.energy", "depends on t; wanted a number, in the unit"),
    ("energy = {}", "accuracy.energy", "an empty table"),
    ("energy = true", "accuracy.energy", "the boolean true; wanted a number"),
    ("mass_matrix = 1e-5", "accuracy.mass_matrix", "the function is not selected"),
])
def test_errors_name_the_key(tmp_path: Path, line: str, where: str, words: str):
    file = tmp_path / "rod.toml"
    file.write_text(HEAD + line)
    with pytest.raises(SceneError) as error:
        read_scene(file)
    assert error.value.where == where and words in str(error.value)


LIMITS = "limits = { lower = -1, upper = 2, velocity = 3, effort = 8 }"


@pytest.mark.parametrize("function, left", [
    ("", ["effort", "velocity", "lower", "upper"]), ("gravity_torques", ["effort", "velocity"]),
    ("inverse_dynamics", ["effort"]), ("forward_dynamics", [])])
def test_limits_between_which_states_are_drawn_are_used(tmp_path: Path, function: str,
                                                        left: list[str]):
    file = tmp_path / "rod.toml"
    text = HEAD.replace('["inverse_dynamics", "energy"]', '["all"]')
    file.write_text(text.replace("[effects", f"{LIMITS}\n[effects")
                    + (f"{function} = 1e-3" if function else ""))
    assert [line.split()[2] for line in read_scene(file).unused] == left


@pytest.mark.parametrize("function", [x.name for x in FUNCTIONS if x.takes == ("q",)
                                      and x.targets is Of.SCENE and x is not closure.FUNCTION])
def test_functions_of_positions_have_no_other_input(function: str):
    made = derive(replace(SCENE, functions=(function,), tiers=(), accuracy=()))
    assert [a.name for a in made.named(function).inputs] == ["q"]


def test_a_file_selects_the_tier_by_its_accuracy(tmp_path: Path):
    file = tmp_path / "rod.toml"
    file.write_text(HEAD + "inverse_dynamics = '1/8000'\nenergy = { e = 1e-5 }")
    scene = read_scene(file)
    assert scene.tiers == ("mixed",)
    assert scene.accuracy == (Tolerance("inverse_dynamics", "", float(Fraction(1, 8000))),
                              Tolerance("energy", "e", 1e-5))


@pytest.mark.parametrize("lower, upper, results", (
    (None, None, (-1, 1)), (5, None, (5, 7)), (None, -5, (-7, -5)), (2, 3, (2, 3)), (2, 2, (2, 2))))
def test_states_are_between_limits(lower: int | None, upper: int | None, results: tuple[int, int]):
    slide = Joint("j", Kind.PRISMATIC, "", "b", m.at(0, 0, 0),
                  lower=None if lower is None else Fraction(lower),
                  upper=None if upper is None else Fraction(upper))
    assert positions(slide) == (results,)


def test_products_far_below_one_are_rounded_once():
    """Exponentials of large squares are such products."""
    draw = np.random.default_rng(8)
    a, b = np.ldexp(draw.uniform(1, 2, (2, 300)), draw.integers(-537, -400, (2, 300)))
    c = np.where(draw.random(300) < 0.5, a * b, 0)
    result = arrays(DOUBLE).arithmetic.function(
        Instruction("x", Op.PRODUCT_ERROR, (), ""), 0)(a, b, c)
    true = [float(Fraction(x) * Fraction(y) - Fraction(z)) for x, y, z in zip(a, b, c, strict=True)]
    assert np.array_equal(result, true)
    assert sum(abs(a * b) < 2.0**-960) > 100


def test_bounds_are_not_rounded_down():
    assert two_digits_up(9.5245e-7) == "9.6e-7"
    assert two_digits_up(0.25) == "2.5e-1"
    assert two_digits_up(0.0) == "0"


def test_who_generates_is_told_what_each_mixture_saves(tmp_path: Path,
                                                       capsys: pytest.CaptureFixture[str]):
    """Two functions are generated at once; the figures are those of the comments."""
    file = tmp_path / "rod.toml"
    file.write_text(HEAD + "inverse_dynamics = 2e-6\nenergy = { e = '1/800000' }")
    assert main(["generate", str(file), "-o", str(tmp_path / "rod")]) == 0
    *lines, written = capsys.readouterr().out.splitlines()
    words = " ".join((tmp_path / "rod" / "rod_mixed.h").read_text().split())
    for line, name, requested, unit in zip(
            lines, ("inverse_dynamics", "energy"), ("2e-6", "1.25e-6"), ("N m", "J"), strict=True):
        mixture, plain, pairs = re.findall(r"([\d,]+) (?:operations|in single|in pairs)", line)
        moved = re.search(r"found to move (.* at most \S+) (.+) \(asked: (\S+)\)", line)
        assert line.startswith(f"{name}: ") and moved and moved[2] == unit and moved[3] == requested
        assert f"rounding moves {moved[1]} (asked: {requested})" in words
        assert f"A call takes {mixture} operations, " in words
        assert f"all in single precision {plain}, all in pairs {pairs}." in words
    assert "files" in written


def test_cost_measures_mixtures(tmp_path: Path, monkeypatch: pytest.MonkeyPatch,
                                capsys: pytest.CaptureFixture[str]):
    """Errors are within the requested accuracy, also at the states of its own search."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    file, made = tmp_path / "rod.toml", tmp_path / "rod.json"
    file.write_text(HEAD + "energy = 1e-6")
    assert main(["cost", str(file), "--function", "energy", "--states", "4",
                 "--json", str(made)]) == 0
    function, = json.loads(made.read_text())["functions"]
    mixture, = (x for x in function["choices"] if x["tier"] == "mixed")
    assert mixture["precision"] == "single" and mixture["time"]["median"] > 0
    assert 0 < mixture["errors"][0]["worst"] <= 1e-6
    assert "single mixed" in capsys.readouterr().out
