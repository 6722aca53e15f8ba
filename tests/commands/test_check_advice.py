"""The step that `coscrew check` advises does in the precision that it is advised for."""

import re
from pathlib import Path

import pytest

from coscrew_codegen.simulate.check import check
from coscrew_codegen.simulate.findings import Along
from coscrew_codegen.simulate.outcome import RunOverrides
from coscrew_codegen.simulate.verdict import table
from tests.support.scenes.selecting import checked

SPRING = """
[bodies]
b = {{ mass = 1 }}
[joints]
j = {{ type = "prismatic", child = "b", axis = [0, 0, 1] }}
[effects.spring.j]
k = {k}
q0 = {rest}
[start.q]
j = {start}
[run]
duration = 20
step = 0.1
"""
NEAR = {"k": 1, "rest": 10, "start": 11}
FAR = {"k": 1, "rest": 100, "start": 100.1}  # where q is rounded to 4e-5 of its swing
UNRESOLVED = {"k": 1, "rest": 1000, "start": 1000.1}  # to 3e-4
EULER, DEFAULT = "semi-implicit-euler", "leapfrog"
WITH_DOUBLE = " with --precision double"


@pytest.fixture
def found(tmp_path: Path):
    """The check of a spring: its results, and its last paragraph."""
    def found(values: dict[str, float], integrator: str, precision: str,
              step: float | None = None) -> tuple[Along, str]:
        path = tmp_path / "spring.toml"
        path.write_text(SPRING.format(**values))
        findings = check(checked(path, integrator),
                         RunOverrides(None, step, integrator, precision))
        return findings.along[-1], table(findings).rpartition("\n\n")[2]

    return found


def step_of(said: str) -> float:
    """The advised step, for one of 0.1 s."""
    return 0.1 * float(re.search(r"take one (\S+) times as long", said)[1])


def test_an_advised_step_passes(found):
    for precision in ("double", "single"):
        along, said = found(NEAR, EULER, precision)
        assert not along.true and WITH_DOUBLE not in said
        again, _ = found(NEAR, EULER, precision, step_of(said))
        assert again.true


@pytest.mark.parametrize("precision", ("single", "both"))
def test_a_step_that_single_precision_does_not_resolve_is_advised_in_double(found, precision):
    along, said = found(FAR, EULER, precision)
    assert (along.precision, along.helps) == ("single", False)
    assert f"{WITH_DOUBLE}, since single precision does not resolve it" in said
    assert not found(FAR, EULER, "single", step_of(said))[0].true
    assert found(FAR, EULER, "double", step_of(said))[0].true


@pytest.mark.parametrize("precision", ("single", "both"))
def test_double_precision_is_advised_where_no_step_helps_in_single(found, precision):
    along, said = found(UNRESOLVED, DEFAULT, precision)
    assert along.precision == "single" and "neither half the step nor 1/8 of it helps" in said
    assert said.endswith("not resolved; take --precision double")
    assert found(UNRESOLVED, DEFAULT, "double")[0].true


def test_a_step_that_takes_very_long_is_advised_in_double_untried(found, monkeypatch):
    monkeypatch.setattr("coscrew_codegen.simulate.check._MOST_STEPS", 1000)
    along, said = found(NEAR, EULER, "single")
    assert along.helps is None and "times as long with --precision double" in said
    assert found(NEAR, EULER, "double", step_of(said))[0].true
