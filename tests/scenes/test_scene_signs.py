"""A wrong sign in the accurate tier's emitted text is noticed.

Every sign of the C text is flipped, and some of Python's: some result is then off by more than half
a unit of its last digit and a bit, or hi + lo by more than their own errors of second order.  A
value's own error is only ever added to it: that law is read off the text.  `make attack` tries more
states.
"""

import importlib
import re
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from coscrew_codegen.backends.output_files import scene_files
from coscrew_codegen.dynamics import derive
from tests.support.scenes.tiers import flat
from tests.support.truth.sign_mutants import less_their_errors
from tests.support.truth.signed_arm import (
    ARMS,
    MOST,
    Judged,
    judge,
    named_scene,
    scene,
    unnoticed,
)

STATES = 400
MOST_SIGNS = 16  # flipped in a function's Python
NOTICED = 0.995  # of the signs in C, at few states of one arm
ASSIGNED = re.compile(r"^    (\w+)(?:, \w+)* = (.*(?:\n        .*)*)", re.M)
CORRECTION = re.compile(r"_(lo|right|left|rest|cross|nearest|rounded|error|final)")
SIGN = re.compile(r" ([-+]) ")
OWN_ERROR = re.compile(r"([\w>.-]*?\w)(?:_\d+)? \+ \1_lo\w*")


def worst(judged: Judged, text: str) -> float:
    """The largest error of this text of the function, in units of the last digit."""
    memory: dict[str, object] = {"__package__": judged.package, "__name__": judged.package}
    exec(compile(text, "mutant", "exec"), memory)
    result = flat(memory[judged.name](*judged.given), STATES)
    with np.errstate(all="ignore"):
        errors = abs((result - judged.high) - judged.low) / judged.unit
    return float(np.nan_to_num(errors, nan=np.inf)[judged.counted].max())


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
def test_every_sign_in_c_is_tried(name: str, tmp_path: Path):
    count, missed = unnoticed(name, STATES, tmp_path, ARMS[:1])
    assert count > 1500
    assert len(missed) <= (1 - NOTICED) * count, "\n".join(missed)


@pytest.mark.parametrize("tier", ("accurate", "pairs"))
def test_a_value_and_its_own_error_are_never_subtracted(tier: str):
    files = scene_files(replace(derive(replace(scene(ARMS[0]), tiers=(tier,))), name="arm"))
    texts = [text for name, text in files.items() if tier in name]
    assert sum(len(OWN_ERROR.findall(x)) for x in texts) > 50
    assert [result for text in texts for result in less_their_errors(text)] == []


def test_a_subtracted_error_is_noticed():
    assert less_their_errors("x = t->w_1 - t->w_lo_2 + a") == ["t->w_1 - t->w_lo_2"]
    assert less_their_errors("x = w - wp_lo - (v + v_lo)") == []
