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
from pathlib import Path

import numpy as np
import pytest

from coscrew_codegen.layout import scene_files
from tests.support.scenes.tiers import flat
from tests.support.truth.signed_arm import MOST, Judged, judge, named_scene, unnoticed

STATES = 400
MOST_SIGNS = 16  # flipped in a function's Python
NOTICED = 0.96  # of the signs in C
ASSIGNED = re.compile(r"^    (\w+)(?:, \w+)* = (.*(?:\n        .*)*)", re.M)
CORRECTION = re.compile(r"_(lo|right|left|rest|cross|nearest|rounded|error|final)")
SIGN = re.compile(r" ([-+]) ")


def worst(judged: Judged, text: str) -> float:
    """The largest error of this text of the function, in units of the last digit."""
    memory: dict[str, object] = {"__package__": judged.package, "__name__": judged.package}
    exec(compile(text, "mutant", "exec"), memory)
    found = flat(memory[judged.name](*judged.given), STATES)
    with np.errstate(all="ignore"):
        errors = abs((found - judged.high) - judged.low) / judged.unit
    return float(np.nan_to_num(errors, nan=np.inf)[judged.told].max())


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


@pytest.mark.parametrize("name", ("inverse_dynamics", "forward_dynamics"))
def test_every_sign_of_a_correction_matters(judged: dict[str, Judged], name: str):
    function = judged[name]
    assert worst(function, function.text) <= MOST
    places = [statement.start(2) + sign.start(1) for statement in ASSIGNED.finditer(function.text)
              if CORRECTION.search(statement[1]) for sign in SIGN.finditer(statement[2])]
    assert len(places) > 3 * MOST_SIGNS
    unnoticed = []
    for place in places[::len(places) // MOST_SIGNS]:
        other = "-" if function.text[place] == "+" else "+"
        if worst(function, f"{function.text[:place]}{other}{function.text[place + 1:]}") <= MOST:
            unnoticed.append(function.text[place - 60:place + 40])
    assert not unnoticed


@pytest.mark.parametrize("name", ("inverse_dynamics", "forward_dynamics"))
def test_every_sign_in_c_is_tried(judged: dict[str, Judged], name: str, tmp_path: Path):
    count, missed = unnoticed(judged[name], tmp_path)
    assert count > 1500
    assert len(missed) <= (1 - NOTICED) * count, "\n".join(missed)
