"""Long functions of scenes consist of parts: the same bits, no long part, shared parts written
once."""

import os
import re
import subprocess
import sys
from collections.abc import Mapping, Sequence
from fractions import Fraction
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from coscrew_codegen.backends.scene import scene_c, scene_c_parts
from coscrew_codegen.dynamics import derive
from coscrew_codegen.program import Constant, Input, Instruction, Op, Program, Ref
from coscrew_codegen.program.ops import COMPARISONS
from coscrew_codegen.program.scene_functions import SceneFunctions
from coscrew_codegen.program.splitting import parts as program_parts
from coscrew_codegen.program.splitting.parts import Cut, Group, cut
from tests.support.compiled.c_harness import COMPILERS, run
from tests.support.compiled.flags import FMA
from tests.support.scenes import scene_bits
from tests.support.scenes.effect_scenes import PLACES, arm, effects, mechanism
from tests.support.scenes.evaluation import DOUBLE, evaluator
from tests.support.scenes.generated_scenes import BANNER, CASES, argument, robot
from tests.support.scenes.kinds import Kind
from tests.support.scenes.mechanisms import Y, Z, at, chain, inertia, scene

LENGTHS = (1, 25, 600)


@pytest.fixture
def in_parts(monkeypatch: pytest.MonkeyPatch):
    """Makes targets cut functions that are longer than this into parts of at most this length."""
    def short(longest: int) -> None:
        monkeypatch.setattr(scene_c_parts, "LONG", 0)
        monkeypatch.setattr(scene_c_parts, "LONGEST", longest)
    return short


@cache
def _functions(kind: str) -> SceneFunctions:
    """The functions of a scene with all kinds of joints and all effects except mimic, or of an arm
    with all effects."""
    if kind == "mechanism":
        return derive(scene(mechanism(), *effects(*(x for x in PLACES if x != "mimic"))))
    return derive(scene(arm(), *effects(*PLACES)))


def _groups(cuts: Mapping[str, Cut]) -> tuple[Group, ...]:
    return tuple({x.name: x for cut in cuts.values() for x in cut.groups}.values())


def _evaluated(result: Cut, given: Mapping[str, Sequence]) -> list:
    """The results of a program in parts, in double precision."""
    kept: dict[str, dict[str, object]] = {}

    def called(program: Program) -> list:
        arrays = [given[a.name] if a.name in given else list(kept[a.name].values())
                  for a in program.inputs]
        return evaluator(program, DOUBLE)(arrays)

    for group in result.groups:
        values = kept[group.name] = dict.fromkeys(group.kept)
        for part in group.parts:
            names = [x.name for x in part.results if isinstance(x, Ref)]
            values.update(zip(names, called(part), strict=True))
    return called(result.last)


@pytest.mark.parametrize("kind, longest", (("mechanism", 25), *(("arm", x) for x in LENGTHS)))
def test_parts_compute_what_the_functions_do(kind: str, longest: int):
    functions = _functions(kind)
    cuts = cut([f.program for f in functions.functions], longest)
    draw = np.random.default_rng(longest)
    for f in functions.functions:
        given = {a.name: list(draw.normal(size=a.quantity.size)) for a in f.program.inputs}
        with np.errstate(all="ignore"):
            whole = evaluator(f.program, DOUBLE)(list(given.values()))
            result = _evaluated(cuts[f.name], given)
        assert np.array_equal(np.array(result), np.array(whole), equal_nan=True), f.name
        assert np.array_equal(np.signbit(result), np.signbit(whole)), f.name


@pytest.mark.parametrize("longest", LENGTHS)
def test_no_part_is_longer_than_asked(longest: int):
    cuts = cut([f.program for f in _functions("arm").functions], longest)
    for part in (part for group in _groups(cuts) for part in group.parts):
        assert 0 < sum(step.op not in COMPARISONS for step in part.instructions) <= longest


def test_long_chains_are_linear_in_length():
    """Parts of longer chains are no longer, and their number, their steps and the values they keep
    grow linearly."""
    results = []
    for joints in (8, 16, 32):
        link = Kind.REVOLUTE, Y, at(0, 0, 1), inertia(1, (0, 1, 2), (3, 4, 5, 0, 0, 0))
        functions = derive(scene(chain(*[link] * joints, name="chain")), ("forward_dynamics",))
        groups = _groups(cut([functions.named("forward_dynamics").program], 100))
        lengths = [len(part.instructions) for group in groups for part in group.parts]
        assert max(lengths) <= 100
        results.append((len(lengths), sum(lengths), sum(len(group.kept) for group in groups)))
    for few, more, most in zip(*results, strict=True):
        assert most - more <= 2.2 * (more - few)


def test_what_programs_share_is_issued_once(monkeypatch: pytest.MonkeyPatch):
    """a = (x, y, z), b = (x, z, w) of the module's docstring, called differently."""
    monkeypatch.setattr(program_parts, "MOST_KEPT", Fraction(1))
    two = Constant(Fraction(2), Fraction(2))
    first = Program("a", (argument("q", 2),), (argument("r", 2),), (
        Instruction("x", Op.MUL, (two, Input(0, 1)), "one:x"),
        Instruction("y", Op.ADD, (Ref("x"), Input(0, 0)), "one:y"),
        Instruction("z", Op.SUB, (Ref("x"), Input(0, 0)), "two:z")), (Ref("y"), Ref("z")))
    second = Program("b", (argument("v", 1), argument("q", 2)), (argument("s", 2),), (
        Instruction("e", Op.MUL, (Input(1, 1), two), "one:e"),
        Instruction("f", Op.SUB, (Ref("e"), Input(1, 0)), "one:f"),
        Instruction("g", Op.MUL, (Ref("f"), Input(0, 0)), "one:g")), (Ref("g"), Input(1, 1)))
    cuts = cut((first, second), 10)
    assert [(g.name, g.users, g.kept) for g in _groups(cuts)] == [
        ("shared_1", ("a", "b"), ("x", "z")), ("a", ("a",), ("y",)), ("b", ("b",), ("g",))]
    assert [a.name for a in cuts["b"].last.inputs] == ["q", "b"]
    shared, *_ = _groups(cuts)
    assert [step.name for part in shared.parts for step in part.instructions] == ["x", "z"]


def test_a_group_that_only_keeps_dissolves():
    """The programs share one product and nothing else."""
    def program(name: str, op: Op) -> Program:
        steps = (Instruction("x", Op.MUL, (Input(0, 0), Input(0, 1)), "one:x"),
                 Instruction("y", op, (Ref("x"), Input(0, 0)), "one:y"))
        return Program(name, (argument("q", 2),), (argument("r", 1),), steps, (Ref("y"),))

    cuts = cut((program("a", Op.ADD), program("b", Op.SUB)), 10)
    assert [(g.name, g.kept) for g in _groups(cuts)] == [("a", ("y",)), ("b", ("y",))]


def test_programs_share_nothing_with_much_longer_ones():
    links = [(Kind.REVOLUTE, (Y, Z)[n % 2], at(0, 0, 1), inertia(1, (0, 1, 2), (3, 4, 5, 0, 0, 0)))
             for n in range(4)]
    functions = derive(scene(chain(*links)), (
        "inverse_dynamics", "mass_matrix", "inverse_dynamics_derivatives",
        "forward_dynamics_derivatives"))
    length = {f.name: len(f.program.instructions) for f in functions.functions}
    groups = _groups(cut([f.program for f in functions.functions], 50))
    for group in groups:
        lengths = [length[x] for x in group.users]
        assert max(lengths) <= program_parts.LONGER * min(lengths), group.users
    assert len({group.name for group in groups}) == len(groups)
    assert any(len(group.users) > 1 for group in groups)
    assert length["inverse_dynamics_derivatives"] > program_parts.LONGER * length["mass_matrix"]


@pytest.fixture(scope="module")
def right(tmp_path_factory: pytest.TempPathFactory) -> list[str]:
    """The expected output of the program."""
    return scene_bits.wanted(tmp_path_factory.mktemp("package"))


@pytest.mark.parametrize("compiler", COMPILERS)
def test_bits_in_c_are_those_of_whole_functions(compiler: str, in_parts, right: list[str],
                                                tmp_path: Path):
    in_parts(40)
    source = scene_bits.source(tmp_path)
    assert (tmp_path / "carrier.c").read_text().count("\nCARRIER_PART void") > 30
    run((compiler, "-O2", *FMA, "-ffp-contract=fast", source, "-o", tmp_path / "bits", "-lm"))
    assert run([tmp_path / "bits"]).splitlines() == right


def test_long_scenes_have_no_long_function():
    """Each function has at most as many declarations as a part may have, or consists of calls and
    results."""
    text = scene_c.files(robot(35, 2 * scene_c_parts.LONG), BANNER)["robot.c"]
    bodies = re.findall(r"^(?:ROBOT_PART |static )?void \w+\([^{]*\{\n(.*?)^\}", text, re.S | re.M)
    assert len(bodies) > 2 * 2 * scene_c_parts.LONG / scene_c_parts.LONGEST
    assert max(len(re.findall(r"\w = ", body)) for body in bodies) <= 2 * scene_c_parts.LONGEST


def test_short_scenes_are_written_whole():
    for made in CASES.values():
        assert "_PART" not in scene_c.files(made(), BANNER)[f"{made().name}.c"]


def test_parts_are_the_same_on_every_hash_seed():
    program = ("from hashlib import sha256; from coscrew_codegen.backends.scene import scene_c;"
               "from tests.support.scenes.generated_scenes import robot;"
               "print(sha256(scene_c.files(robot(3, 4100), '')['robot.c'].encode()).hexdigest())")
    made = {subprocess.run([sys.executable, "-c", program], capture_output=True, text=True,
                           check=True, cwd=Path(__file__).parents[2],
                           env={**os.environ, "PYTHONHASHSEED": seed}).stdout
            for seed in ("1", "2")}
    assert len(made) == 1


def _texts(functions: SceneFunctions) -> dict[str, str]:
    """The text of each function in double precision, by name."""
    text = scene_c.files(functions, BANNER)["chain.c"]
    return {match[1]: match[0] for match in re.finditer(
        r"^void chain_(\w+)\([^{]*\{\n.*?^\}", text, re.S | re.M)}


def test_functions_beside_a_long_one_are_as_without(monkeypatch: pytest.MonkeyPatch):
    links = [(Kind.REVOLUTE, (Y, Z)[n % 2], at(0, 0, 1), inertia(1, (0, 1, 2), (3, 4, 5, 0, 0, 0)))
             for n in range(4)]
    model = scene(chain(*links, name="chain"))
    short = ("inverse_dynamics", "forward_dynamics", "mass_matrix")
    functions = derive(model, (*short, "forward_dynamics_derivatives"))
    longest = max(len(functions.named(x).program.instructions) for x in short)
    monkeypatch.setattr(scene_c_parts, "LONG", longest)
    monkeypatch.setattr(scene_c_parts, "LONGEST", 50)
    alone, beside = _texts(derive(model, short)), _texts(functions)
    assert alone.keys() == {*short} and all(beside[name] == alone[name] for name in short)
    assert "part_1_of_" in beside["forward_dynamics_derivatives"]
    assert not any("part_1_of_" in text for text in alone.values())
