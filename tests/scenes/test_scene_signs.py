"""No sign of the accurate tier's emitted text can be wrong unnoticed: with any one of them flipped,
some result is off by more than half a unit of its last digit and a bit.

Terms of second order, by which hi + lo of a cancelled factor enters, are tried in
tests/tiers/test_rounded_constants.py.
"""

import importlib
import re
import sys
from dataclasses import dataclass, replace

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

STATES = 1500
MOST_SIGNS = 40  # flipped in a function
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


@pytest.fixture(scope="module")
def judged(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Judged]:
    """Both functions as NumPy."""
    folder = tmp_path_factory.mktemp("signs")
    derived = replace(derive(scene()), name="signed_arm")
    for name, text in scene_files(derived).items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)
    sys.path.insert(0, str(folder))
    importlib.import_module("signed_arm.accurate")
    sys.path.remove(str(folder))
    text = (folder / "signed_arm/accurate/double.py").read_text()
    head, *functions = text.split("\n@errstate")
    return {f.name: _judged(derived, f, head, next(
        x for x in functions if f"def {f.name}(" in x)) for f in derived.functions}


def _judged(derived: SceneFunctions, function: Function, head: str, text: str) -> Judged:
    given = states(derived, function, STATES, DOUBLE)
    true = truths(function.program, given)
    high = np.array([[float(x) for x in row] for row in true])
    low = np.array([[float(x - mpmath.mpf(y)) for x, y in zip(row, numbers, strict=True)]
                    for row, numbers in zip(true, high, strict=True)])
    told = np.transpose([np.broadcast_to(x, STATES) for x in conditions(
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
