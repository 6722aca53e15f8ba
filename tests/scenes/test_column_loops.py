"""Columns that are alike are a loop in C, for one state: the bits are those of straight lines."""

import ctypes
import re
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from coscrew_codegen.backends.scene import scene_c, scene_c_many, scene_c_parts
from coscrew_codegen.backends.scene.scene_c_columns import column_loops
from coscrew_codegen.dynamics import derive
from coscrew_codegen.program import Input, Instruction, Op, Program, Ref
from coscrew_codegen.program.scene_functions import SceneFunctions
from coscrew_codegen.program.splitting.columns import FEWEST, SHORTEST, columns, has_columns, marked
from coscrew_codegen.program.splitting.parts import cut
from coscrew_codegen.program.values.formats import DOUBLE
from tests.support.compiled.c_harness import C11, STRICT, run
from tests.support.each import each_compiler, each_precision
from tests.support.scenes.generated_scenes import BANNER, argument, imported
from tests.support.scenes.kinds import Kind
from tests.support.scenes.mechanisms import Y, Z, at, chain, gravity, inertia, scene

NAME, JOINTS = "forward_dynamics_derivatives", 7
COUNT = FEWEST + 1


@pytest.fixture(scope="module")
def functions() -> SceneFunctions:
    links = [(Kind.REVOLUTE, (Y, Z)[n % 2], at(0.25, 0, 1),
              inertia(1 + n, (n % 3, 1, 0), (4, 5, 6, 0, 1, 0))) for n in range(JOINTS)]
    return derive(scene(chain(*links, name="snake"), gravity()), (NAME,))


def compiled(functions: SceneFunctions, compiler: str, suffix: str, folder: Path
             ) -> Callable[..., None]:
    """The function in C, on arrays."""
    for name, text in scene_c.files(functions, BANNER).items():
        (folder / name).write_text(text)
    run((compiler, *C11, *STRICT, "-O2", "-shared", "-fPIC", folder / f"snake{suffix}.c", "-o",
         folder / "x.so", "-lm"))
    function = getattr(ctypes.CDLL(str(folder / "x.so")), f"snake_{NAME}{suffix}")
    return lambda *arrays: function(*(ctypes.c_void_p(x.ctypes.data) for x in arrays))


@each_precision
@each_compiler
@pytest.mark.parametrize("long", (False, True), ids=("short", "long"))
def test_bits_are_those_of_numpy(functions, compiler: str, precision, long: bool, tmp_path: Path,
                                 monkeypatch: pytest.MonkeyPatch):
    # and where an output overlaps an input
    monkeypatch.setattr(scene_c_parts, "LONG", 500 if long else 10_000)
    monkeypatch.setattr(scene_c_parts, "LONGEST", 60)
    package = getattr(imported(functions, tmp_path), precision.name)
    function = compiled(functions, compiler, precision.suffix, tmp_path)
    kind = np.dtype(precision.numpy_type)
    for given in np.random.default_rng(1).normal(size=(8, 3, JOINTS)).astype(kind):
        wanted = getattr(package, NAME)(*given)
        made = [np.full(x.size, np.nan, kind) for x in wanted]
        function(*given, *made)
        over = np.concatenate((given[1], np.zeros(JOINTS * JOINTS, kind)))
        function(given[0], over, given[2], over[1:], *made[1:])
        for result, x in zip((*made, over[1:1 + JOINTS * JOINTS]), (*wanted, wanted[0]),
                             strict=True):
            assert result.tobytes() == x.tobytes()


def test_a_loop_has_nearly_all_columns(functions):
    text = scene_c.files(functions, BANNER)["snake.c"]
    loops = re.findall(r"  for \(int c = 0; c < (\d+); \+\+c\) \{\n(.*?)\n  \}", text, re.S)
    (count, body), = loops
    assert int(count) == 12  # of 14
    straight = text.replace(body, "")
    assert 12 * body.count("RN(") > straight.count("RN(") / 8


def test_arrays_of_columns_are_aligned(functions):
    """A vector in two lines of the cache took a UR5's columns up to 1.3 times as long."""
    for name in ("snake.c", "snakef.c"):
        arrays = re.findall(r"^ *(.*)(?:double|float) \w+\[\d+\]\[\d+\];",
                            scene_c.files(functions, BANNER)[name], re.M)
        assert arrays == ["COSCREW_ALIGNED "] * 2, name


def test_vectors_of_states_are_written_straight(functions):
    """A column is a vector there; loops over vectors were up to 7 % slower."""
    for name, text in scene_c_many.files(functions, BANNER).items():
        assert "int c = 0" not in text and "COSCREW_COLUMNS" not in text, name


def _columns(count: int = COUNT, last: Op = Op.SUB, linked: bool = False) -> Program:
    """x[k] = b[k] - c[0] - c[1] - …, in as many steps as a column must have; the last one ends with
    another operation, or begins with the result of the one before."""
    steps, results, before = [], [], Input(0, 0)
    for k in range(count):
        x, b = Ref(""), Input(0, k)
        for n in range(SHORTEST):
            ends = k == count - 1 and n == SHORTEST - 1
            first = before if linked and n == 0 and k else b
            steps.append(Instruction(f"x{k}_{n}", last if ends else Op.SUB,
                                     (x if n else first, Input(1, n)), f":{marked(str(k))}"))
            x = Ref(steps[-1].name)
        results.append(x)
        before = x
    return Program("f", (argument("b", count), argument("c", SHORTEST)), (argument("x", count),),
                   tuple(steps), tuple(results))


def test_columns_are_a_program_of_one_with_what_differs():
    of = columns(_columns(), "given")
    assert of and of.given == (tuple(Input(0, k) for k in range(COUNT)),)
    assert of.results == (tuple(f"x{k}_{SHORTEST - 1}" for k in range(COUNT)),)
    first, second, *_ = of.program.instructions
    assert first.operands == (Input(2, 0), Input(1, 0))
    assert second.operands == (Ref(first.name), Input(1, 1))
    assert len(of.program.instructions) == SHORTEST


@pytest.mark.parametrize("program", (
    _columns(FEWEST - 1), _columns(FEWEST, last=Op.ADD),
    replace(_columns(), instructions=tuple(x._replace(component=":x" + x.name.split("_")[0])
                                           for x in _columns().instructions))),
    ids=("few", "another operation", "without marks"))
def test_others_are_no_columns(program: Program):
    assert not has_columns(program)


def test_a_value_stands_in_one_array():
    """The columns of a second loop read values that the array of the first one holds."""
    def negated(k: int) -> Instruction:
        return Instruction(f"y{k}", Op.NEG, (Input(0, k),), ":y")

    steps, results = [negated(k) for k in range(COUNT)], []
    for loop, op in enumerate((Op.SUB, Op.ADD)):
        for k in range(COUNT):
            x = Ref(f"y{k}")
            for n in range(SHORTEST):
                steps.append(Instruction(f"x{loop}_{k}_{n}", op, (x, Input(1, n)),
                                         f":{marked(f'{loop}_{k}')}"))
                x = Ref(steps[-1].name)
            results.append(x)
    program = Program("f", (argument("b", COUNT), argument("c", SHORTEST)),
                      (argument("x", 2 * COUNT),), tuple(steps), tuple(results))
    first, second = column_loops(cut([program], SHORTEST, columns=True)["f"].groups)
    assert [*first.slots] == [f"y{k}" for k in range(COUNT)] and not second.slots
    lines = "\n".join(second.lines(DOUBLE, lambda x: f"r{x.argument}[{x.index}]", lambda *x: ()))
    for k in range(COUNT):
        assert f"f->columns_2[0][{k}] = " in lines


def test_a_column_stays_behind_what_it_reads():
    """Each reads the result of the one before: none may move to the first."""
    for linked in (False, True):
        program = _columns(linked=linked)
        (group,) = cut([program], SHORTEST, columns=True)["f"].groups
        lengths = [len(part.instructions) for part in group.parts]
        assert lengths == ([SHORTEST] * COUNT if linked else [SHORTEST * COUNT])
        names = [step.name for part in group.parts for step in part.instructions]
        assert names == [step.name for step in program.instructions]
