"""Effects that a scene does not have leave no trace in its text."""

import json
import os
import subprocess
import sys
from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction
from functools import cache
from itertools import permutations
from pathlib import Path

import mpmath
import pytest

from coscrew_codegen.dynamics import derive
from coscrew_codegen.program.scene_functions import SceneFunctions
from coscrew_codegen.scene.mechanism.model import Parameter
from coscrew_codegen.scene.scene import Applied, Scene, Setting
from tests.support.scenes.effect_scenes import (
    PLACES,
    STATEFUL,
    all_but,
    assert_listed,
    effects,
    hashes,
    mechanism,
)
from tests.support.scenes.evaluation import MULTIPRECISE, Evaluated
from tests.support.scenes.mechanisms import CATALOGUE, scene
from tests.support.scenes.scene_values import random_state
from tests.support.walks import copied

ROOT = Path(__file__).parents[2]

ZEROS: Mapping[str, tuple[str, ...]] = {
    "added_mass": ("mass", "inertia", "matrix"),
    "actuator": ("torque", "kp", "kd", "kt"), "armature": ("inertia", "rotor"),
    "buoyancy": ("rho",), "coulomb": ("tau_c",), "drag": ("rho", "b"), "field": ("mu",),
    "gravity": ("g",), "joint_drag": ("c",), "limit": ("k",), "speed_limit": ("d",),
    "spring": ("k",), "spring_damper": ("k", "d"), "stribeck": ("tau_c", "tau_s"),
    "viscous": ("d",), "wind": ("velocity",), "wrench": ("force", "torque")}
"""The parameters without which an effect does nothing."""


@pytest.fixture(scope="module")
def generator(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with a copy of the generator, which can be imported from there."""
    folder = tmp_path_factory.mktemp("generator")
    copied(folder)
    return folder


ROW = 4
LEFT_OUT = [tuple(x for n, x in enumerate(sorted(PLACES)) if place(n) == k)
            for place, count in ((lambda n: n // ROW, -(-len(PLACES) // ROW)),
                                 (lambda n: n % ROW, ROW)) for k in range(count)]
LEFT_OUT.append(STATEFUL)
"""The rows and the columns of a table of the effects.  Of any two effects, each is left out once
while the other is present."""


@pytest.mark.parametrize("names", LEFT_OUT, ids="-".join)
def test_text_is_that_of_a_generator_without_the_effects(generator: Path,
                                                         names: tuple[str, ...]) -> None:
    folder = generator / "coscrew_codegen/scene/effects"
    texts = {file: file.read_bytes() for name in names for file in folder.rglob(f"{name}.py")}
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join((str(generator), str(ROOT)))}
    try:
        for file in texts:
            file.unlink()
        done = subprocess.run([sys.executable, "-m", "tests.support.scenes.effect_scenes", *names],
                              cwd=generator, env=environment, capture_output=True, text=True,
                              check=False)
    finally:
        for file, text in texts.items():
            file.write_bytes(text)
    assert done.returncode == 0, done.stderr
    place, known, result = json.loads(done.stdout)
    assert place.startswith(str(generator)) and known == sorted(set(CATALOGUE) - set(names))
    assert result == hashes(all_but(names))


def test_of_two_effects_either_is_left_out_without_the_other() -> None:
    for one, other in permutations(PLACES, 2):
        assert any(one in names and other not in names for names in LEFT_OUT), (one, other)


def test_every_effect_is_left_out_once() -> None:
    assert_listed(PLACES, CATALOGUE, "PLACES", "tests/support/scenes/effect_scenes.py")


def test_every_effect_that_acts_can_be_switched_off() -> None:
    acting = [name for name, x in CATALOGUE.items() if not (x.mimic or x.reaction)]
    assert_listed(ZEROS, acting, "ZEROS", "tests/scenes/test_absence.py")


def zeroed(name: str, number: Fraction | Parameter) -> tuple[Applied, ...]:
    """The effects of this name, with `number` for the parameters without which they do nothing."""
    def zero(parameter: str, value: Setting) -> Setting:
        if value is None or parameter not in ZEROS[name]:
            return value
        return (number,) * len(value) if isinstance(value, tuple) else number

    return tuple(replace(x, values={key: zero(key, value) for key, value in x.values.items()})
                 for x in effects(name))


@cache
def bare(*names: str) -> Evaluated:
    """The mechanism with these effects alone."""
    return Evaluated(scene(mechanism(), *effects(*names)), MULTIPRECISE)


@cache
def derived(*names: str) -> SceneFunctions:
    """All functions of a scene."""
    return derive(bare(*names).scene)


@pytest.mark.parametrize("name", sorted(ZEROS))
def test_parameters_of_zero_fold_to_the_same_programs(name: str) -> None:
    """This holds for a scene with time, gravity and other effects, too."""
    others = sorted({"gravity", "viscous", "wrench"} - {name})
    wanted = derived(*others).functions
    result = derive(scene(mechanism(), *effects(*others), *zeroed(name, Fraction(0)))).functions
    assert [f.words for f in result] == [f.words for f in wanted]
    for f, g in zip(result, wanted, strict=True):
        assert counts(f.program) == counts(g.program), f.name


def counts(program: object) -> tuple:
    """Inputs, outputs and instructions by kind."""
    return program.inputs, program.outputs, dict(program.counts)


@pytest.mark.parametrize("name", sorted(ZEROS))
def test_zeros_at_run_time_change_no_result(name: str) -> None:
    others = sorted({"gravity", "wrench"} - {name})
    number = Parameter("zero", 0, Fraction(0))
    with mpmath.workdps(50):
        without = bare(*others)
        zero = Evaluated(scene(mechanism(), *effects(*others), *zeroed(name, number),
                               parameters=(number,)), MULTIPRECISE)
        state = random_state(without, 1)
        for function in ("inverse_dynamics", "forward_dynamics", "energy", "implicit_acceleration"):
            results = [f(function, a=state["tau"], h=mpmath.mpf(1) / 8, **state)
                       for f in (without, zero)]
            for x, y in zip(*results, strict=True):
                assert abs(x - y) <= mpmath.mpf(10)**-44 * max(1, abs(x))


def test_reactions_add_a_function_and_change_none() -> None:
    unasked = derived().functions
    requested = derive(scene(mechanism(), *effects("reaction"))).functions
    assert [f.name for f in requested if f not in unasked] == ["reaction_j2"]
    assert [f for f in requested if f.name != "reaction_j2"] == list(unasked)


def test_mimic_changes_nothing_where_nothing_mimics() -> None:
    assert derive(scene(mechanism(), *effects("mimic"))) == derived()


def test_bare_scenes_know_no_time_and_no_effects() -> None:
    """Functions of a scene without effects take no time, and of the model only the bodies' inertia.
    """
    made: Scene = scene(mechanism())
    functions = derive(made)
    assert not functions.timed
    used = {op.value for f in functions.functions for op in f.program.counts}
    assert used <= {"add", "sub", "mul", "div", "neg", "abs", "sin", "cos", "sqrt", "less",
                    "select"}
    power = next(f for f in functions.functions if f.name == "power").program
    assert not power.instructions
