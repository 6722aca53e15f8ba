"""A wrong sign in the accurate tier's emitted text is noticed: with one of them flipped, some
result is off by more than half a unit of its last digit and a bit.

Every sign of the C text is tried, and some of Python's.  A few in a hundred change nothing that can
be seen: terms of second order, by which hi + lo of a cancelled factor enters, which are tried in
tests/tiers/test_rounded_constants.py, and errors of sums whose operands are too unlike in size.
`make attack` tries more states and prints them.
"""

import importlib
import re
import sys
from dataclasses import dataclass, replace
from pathlib import Path

import mpmath
import numpy as np
import pytest

from coscrew_codegen.formats import DOUBLE
from coscrew_codegen.layout import scene_files
from coscrew_codegen.mechanics import derive
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.scene_functions import Function, SceneFunctions
from tests.support.scenes import mechanisms as m
from tests.support.scenes.tiers import components, flat, states, truths
from tests.support.truth.condition import conditions
from tests.support.truth.sign_mutants import mutants

STATES = 400
MOST_SIGNS = 16  # flipped in a function's Python
NOTICED = 0.96  # of the signs in C
LARGEST = 1e9  # condition
MOST = 0.5 + 1e-5  # units of the last digit
ASSIGNED = re.compile(r"^    (\w+)(?:, \w+)* = (.*(?:\n        .*)*)", re.M)
CORRECTION = re.compile(r"_(lo|right|left|rest|cross|nearest|rounded|error|final)")
SIGN = re.compile(r" ([-+]) ")


@dataclass(frozen=True)
class Judged:
    """A function's text and what it must return."""

    text: str
    name: str
    package: str
    given: list[np.ndarray]
    high: np.ndarray  # the truth in two parts, in units of its last digit from `high`
    low: np.ndarray
    unit: np.ndarray
    told: np.ndarray  # whether the condition allows a judgement

    def worst(self, text: str) -> float:
        """The largest error, in units of the last digit."""
        memory: dict[str, object] = {"__package__": self.package, "__name__": self.package}
        exec(compile(text, "mutant", "exec"), memory)
        found = flat(memory[self.name](*self.given), STATES)
        with np.errstate(all="ignore"):
            errors = abs((found - self.high) - self.low) / self.unit
        return float(np.nan_to_num(errors, nan=np.inf)[self.told].max())


def scene() -> Scene:
    """Four joints that turn about different axes, one that slides, dampers."""
    moments = ("0.22", "0.33", "0.41", "0.11", "-0.07", "0.13")
    links = [(m.Kind.PRISMATIC if n == 2 else m.Kind.REVOLUTE, axis, m.at("0.1", "-0.2", "0.3"),
              m.inertia("1.1", ("0.01", "0.07", "-0.03"), moments))
             for n, axis in enumerate((m.Z, m.Y, m.X, m.X, m.Z))]
    dampers = [m.applied("viscous", f"j{n}", d=m.Fraction("0.3")) for n in range(5)]
    return replace(m.scene(m.chain(*links, name="arm"), m.gravity(), *dampers),
                   functions=("inverse_dynamics", "forward_dynamics"), tiers=("accurate",))


def named_scene() -> SceneFunctions:
    """Its functions."""
    return replace(derive(scene()), name="signed_arm")


@pytest.fixture(scope="module")
def judged(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Judged]:
    """Both functions as NumPy."""
    folder = tmp_path_factory.mktemp("signs")
    derived = named_scene()
    for name, text in scene_files(derived).items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)
    sys.path.insert(0, str(folder))
    importlib.import_module("signed_arm.accurate")
    sys.path.remove(str(folder))
    text = (folder / "signed_arm/accurate/double.py").read_text()
    head, *functions = text.split("\n@errstate")
    return {f.name: judge(derived, f, STATES, head, next(
        x for x in functions if f"def {f.name}(" in x)) for f in derived.functions}


def judge(derived: SceneFunctions, function: Function, count: int, head: str = "", text: str = ""
          ) -> Judged:
    """Truth at random states."""
    given = states(derived, function, count, DOUBLE)
    true = truths(function.program, given)
    high = np.array([[float(x) for x in row] for row in true])
    low = np.array([[float(x - mpmath.mpf(y)) for x, y in zip(row, numbers, strict=True)]
                    for row, numbers in zip(true, high, strict=True)])
    told = np.transpose([np.broadcast_to(x, count) for x in conditions(
        function.program, components(function.program, given))]) < LARGEST
    return Judged(f"{head}\n@errstate{text}", function.name, "signed_arm.accurate", given,
                  high, low, np.spacing(abs(high)), told)


@pytest.mark.parametrize("name", ("inverse_dynamics", "forward_dynamics"))
def test_every_sign_of_a_correction_matters(judged: dict[str, Judged], name: str):
    function = judged[name]
    assert function.worst(function.text) <= MOST
    places = [statement.start(2) + sign.start(1) for statement in ASSIGNED.finditer(function.text)
              if CORRECTION.search(statement[1]) for sign in SIGN.finditer(statement[2])]
    assert len(places) > 3 * MOST_SIGNS
    unnoticed = []
    for place in places[::len(places) // MOST_SIGNS]:
        other = "-" if function.text[place] == "+" else "+"
        if function.worst(function.text[:place] + other + function.text[place + 1:]) <= MOST:
            unnoticed.append(function.text[place - 60:place + 40])
    assert not unnoticed


def unnoticed(judged: Judged, folder: Path) -> tuple[int, list[str]]:
    """How many signs the C of a function has, and those that can be flipped unnoticed."""
    size = judged.high.shape[1]
    made = mutants(folder, scene_files(named_scene()), "signed_arm_accurate",
                   f"signed_arm_{judged.name}_accurate", size)
    unit = np.where(judged.told, judged.unit, np.inf)
    high, low = (np.where(judged.told, x, 0) for x in (judged.high, judged.low))
    worst = made.worst([-1, *range(len(made.lines))], judged.given, high, low, unit, MOST)
    assert worst[0] <= MOST
    return len(made.lines), [line for line, x in zip(made.lines, worst[1:], strict=True)
                             if x <= MOST]


@pytest.mark.parametrize("name", ("inverse_dynamics", "forward_dynamics"))
def test_every_sign_in_c_is_tried(judged: dict[str, Judged], name: str, tmp_path: Path):
    count, missed = unnoticed(judged[name], tmp_path)
    assert count > 1500
    assert len(missed) <= (1 - NOTICED) * count, "\n".join(missed)
