"""Functions with many results store them while they run, and read no argument behind the first
store: outputs may overlap inputs, and bits are those of separate arrays."""

import ctypes
import re
from pathlib import Path

import numpy as np
import pytest

from coscrew_codegen.backends.scene import scene_c, scene_c_parts
from coscrew_codegen.dynamics import derive
from coscrew_codegen.program.scene_functions import SceneFunctions
from tests.support.compiled.c_harness import C11, STRICT, run
from tests.support.each import each_compiler, each_precision
from tests.support.scenes.generated_scenes import BANNER, imported
from tests.support.scenes.kinds import Kind
from tests.support.scenes.mechanisms import Y, Z, at, chain, gravity, inertia, scene

JOINTS = 6
NAMES = ("inverse_dynamics", "mass_matrix", "inverse_dynamics_derivatives")
MANY = NAMES[1:]


@pytest.fixture(scope="module")
def functions() -> SceneFunctions:
    links = [(Kind.REVOLUTE, (Y, Z)[n % 2], at(0.25, 0, 1),
              inertia(1 + n, (n % 3, 1, 0), (4, 5, 6, 0, 1, 0))) for n in range(JOINTS)]
    return derive(scene(chain(*links, name="snake"), gravity()), NAMES)


def lines_of(functions: SceneFunctions, name: str) -> list[str]:
    """The body of a function in double precision."""
    text = scene_c.files(functions, BANNER)["snake.c"]
    return re.search(rf"^void snake_{name}\([^{{]*{{\n(.*?)^}}", text, re.S | re.M)[1].splitlines()


@pytest.mark.parametrize("name", MANY)
def test_stores_stand_among_declarations_and_behind_all_arguments(functions, name: str):
    outputs = "|".join(a.name for a in functions.named(name).program.outputs)
    lines = lines_of(functions, name)
    stores = [n for n, line in enumerate(lines) if re.match(rf"  ({outputs})\[", line)]
    declared = [n for n, line in enumerate(lines) if line.startswith("  const double")]
    assert sum(n < declared[-1] for n in stores) > len(stores) // 2
    behind = "\n".join(lines[stores[0]:])
    assert not re.search(r"\b[qva]\[", behind)


def test_parts_store_results(functions, monkeypatch: pytest.MonkeyPatch):
    """Constants, too, beside values of the same row; the function that calls them gives them copies
    of arguments."""
    monkeypatch.setattr(scene_c_parts, "LONG", 1000)
    monkeypatch.setattr(scene_c_parts, "LONGEST", 60)
    lines = lines_of(functions, "inverse_dynamics_derivatives")
    assert not [line for line in lines if re.match(r" +(dtau_d[qv]|M)\[", line)]
    calls = [line for line in lines if re.match(r"  snake_part_", line)]
    assert len(calls) > 10 and not any(re.search(r"[(,] ?[qva][,)]", line) for line in calls)


def test_few_results_are_stored_last(functions):
    *declared, last = lines_of(functions, "inverse_dynamics")
    assert last.startswith("  tau[") and not any(x.startswith("  tau[") for x in declared[:-1])


@each_precision
@each_compiler
@pytest.mark.parametrize("parts", (False, True), ids=("whole", "parts"))
def test_many_results_may_overlap_arguments(functions, compiler: str, precision, parts: bool,
                                            tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    """Each output, from one number before an input's first to its last one."""
    if parts:
        monkeypatch.setattr(scene_c_parts, "LONG", 0)
        monkeypatch.setattr(scene_c_parts, "LONGEST", 60)
    package = getattr(imported(functions, tmp_path), precision.name)
    for name, text in scene_c.files(functions, BANNER).items():
        (tmp_path / name).write_text(text)
    source = tmp_path / f"snake{precision.suffix}.c"
    run((compiler, *C11, *STRICT, "-O2", "-shared", "-fPIC", source, "-o", tmp_path / "x.so",
         "-lm"))
    library, kind = ctypes.CDLL(str(tmp_path / "x.so")), np.dtype(precision.numpy_type)
    given = np.random.default_rng(1).normal(size=(3, JOINTS)).astype(kind)
    for name in MANY:
        function = functions.named(name)
        arguments = given[:len(function.inputs)]
        wanted = getattr(package, name)(*arguments)
        wanted = wanted if isinstance(wanted, tuple) else (wanted,)
        for into in range(len(arguments)):
            for output, right in enumerate(wanted):
                for shift in range(-1, JOINTS):
                    memory = np.zeros(2 * JOINTS + right.size, kind)
                    memory[1:1 + JOINTS] = arguments[into]
                    both = list(arguments.copy())
                    both[into] = memory[1:1 + JOINTS]
                    made = [np.zeros(x.size, kind) for x in wanted]
                    made[output] = memory[1 + shift:1 + shift + right.size]
                    getattr(library, f"snake_{name}{precision.suffix}")(
                        *(ctypes.c_void_p(x.ctypes.data) for x in (*both, *made)))
                    for result, x in zip(made, wanted, strict=True):
                        assert result.tobytes() == x.tobytes(), (name, into, output, shift)
