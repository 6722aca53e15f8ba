"""`coscrew check` and the alarm judge contacts and friction: depths, slipping, pulling, what is
dissipated; with a table of each contact in both precisions."""

import re
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from coscrew_codegen.__main__ import main
from coscrew_codegen.simulation.check.check import check
from coscrew_codegen.simulation.check.check_report import table
from coscrew_codegen.simulation.check.contact_check import contacts_of
from coscrew_codegen.simulation.check.divergence_monitor import Alarm
from coscrew_codegen.simulation.check.energy_balance import bristles_of
from coscrew_codegen.simulation.check.error_limits import ENERGY, KEPT
from coscrew_codegen.simulation.plan import Trajectory, plan
from coscrew_codegen.simulation.run_summary import RunOverrides
from coscrew_codegen.simulation.system import system
from tests.support.scenes.selecting import checked

G, MU = 9.81, 0.5
BALL = """
precision = "both"
[bodies]
ball = { mass = 1, inertia = [0.004, 0.004, 0.004] }
[joints]
free = { type = "free", child = "ball" }
[effects.gravity]
[effects.contact.ball]
shape = "sphere"
radius = 0.1
mu = 0.5
"""
SLIDING = BALL + """
[start.q]
free = [0, 0, 0.099, 0, 0, 0, 1]
[start.v]
free = [9, 0, 0, 0, 0, 0]
[run]
duration = 0.2
"""
DROPPED = """
[start.q]
free = [0, 0, 0.3, 0, 0, 0, 1]
[run]
duration = 0.5
"""


def written(folder: Path, text: str) -> Path:
    path = folder / "ball.toml"
    path.write_text(text)
    return path


def test_a_ball_that_slides_slips_and_dissipates_what_friction_takes(tmp_path: Path) -> None:
    """mu m g times the way that it slides, whose speed is v - 7/2 mu g t; less what its bristles
    hold, (mu m g)²/(2 k_t)."""
    findings = check(checked(written(tmp_path, SLIDING)), RunOverrides())
    assert findings.passed, table(findings)
    t, grip, k_t = 0.2, MU * G, G / 1e-3
    stored = grip**2 / (2 * k_t)
    for x in findings.along:
        contact, = x.contacts.each
        assert contact.name == "contact.ball" and contact.closed == 1
        assert [contact.depth, contact.ends] == pytest.approx([1, 1], rel=1e-3)
        assert contact.slipping == pytest.approx(1, abs=0.02)
        assert x.bristles.stored == pytest.approx(stored, rel=1e-3)
        assert x.bristles.dissipated == pytest.approx(
            grip * (9 * t - 7 / 4 * MU * G * t**2) - stored, rel=1e-3)
    assert 1e-8 < findings.contact_distances[0] < 1e-5
    words = table(findings)
    assert re.search(r"^contact\.ball +1\.00 ", words, re.MULTILINE)
    assert "apart, m" in words
    assert re.search("least normal force of contacts, over the largest force +1", words)


def test_bounces_that_no_step_resolves_are_reported(tmp_path: Path,
                                                   capsys: pytest.CaptureFixture) -> None:
    path = written(tmp_path, BALL.replace("mu = 0.5", "mu = 0.5\nk = 1e12") + """
[start.q]
free = [0, 0, 0.1, 0, 0, 0, 1]
[start.v]
free = [0, 0, -3, 0, 0, 0]
[outputs]
every = 0.001
""")
    main(["simulate", str(path), "--until", "0.002", "--precision", "double"])
    assert "a contact bounces too fast at t = 0 s" in capsys.readouterr().err


def test_a_contact_that_never_closes_is_reported(tmp_path: Path) -> None:
    findings = check(checked(written(tmp_path, BALL + DROPPED.replace("0.3", "9"))),
                     RunOverrides(until=0.1))
    assert findings.passed and "no contact closes" in table(findings)


def test_what_sinks_deeper_than_its_radius_is_false(tmp_path: Path, capsys: pytest.CaptureFixture
                                                    ) -> None:
    """A ball on a contact for a ten-thousandth of its weight is found by runs and by checks; both
    tell what helps."""
    path = written(tmp_path, BALL.replace("mu = 0.5", "mu = 0.5\nload = 1e-3") + DROPPED)
    words = "contact.ball is deeper than its radius at t = .* give it load in N, or k"
    assert main(["simulate", str(path)]) == 1
    assert re.search(words, capsys.readouterr().err)
    findings = check(checked(path), RunOverrides())
    assert not findings.passed and re.search(words, table(findings))
    assert check(checked(written(tmp_path, BALL + DROPPED)), RunOverrides()).passed


def test_friction_that_gives_energy_back_is_false(tmp_path: Path) -> None:
    """A contact whose power has the wrong sign."""
    kernels = checked(written(tmp_path, SLIDING))
    own = {name: getattr(kernels.double, name) for name in kernels.double}

    def bristles(*state: object) -> tuple[object, object]:
        stored, power = own["bristles"](*state)
        return stored, -power

    wrong = replace(kernels, double=SimpleNamespace(**{**own, "bristles": bristles}))
    findings = check(wrong, RunOverrides(precision="double"))
    assert not findings.passed
    assert re.search("contacts or sticking joints return .* J of the energy", table(findings))


class Touching:
    """A system with one contact, whose normal force is this one of the largest force, and with
    bristles of these energies and powers."""

    dtype = np.float64
    contact = SimpleNamespace(name="contact.ball", values={"depth": Fraction(1)},
                              effect=SimpleNamespace(parts=True))
    scene = SimpleNamespace(effects=(contact,))

    def __init__(self, least: float = 0, stored: object = (), power: object = ()):
        self.least, self.bristles = least, (stored, power)

    def has(self, name: str) -> bool:
        return name in ("contacts", "bristles")

    def outputs(self, name: str, **given: np.ndarray) -> tuple[object, ...]:
        if name == "bristles":
            return self.bristles
        up = np.tile([0.0, 0, 1], (2, 1, 1))
        forces = up * np.array([100, 100 * self.least])[:, None, None]
        return up, forces, np.ones((2, 1)), np.zeros((2, 1)), up


@pytest.mark.parametrize("least, passes", [(0, True), (-1e-15, True), (-1e-3, False),
                                           (float("nan"), False)])
def test_contacts_that_pull_are_false(least: float, passes: bool) -> None:
    trajectory = Trajectory(np.array([0.0, 0.5]), np.zeros((2, 7)), np.zeros((2, 6)), 0, 0)
    its = contacts_of(Touching(least), trajectory, 1e-3)
    assert its.passed is passes
    assert its.pulls_at == 0.5


@pytest.mark.parametrize("stored, power, returned", [
    ([0, 1, 2], [-1, -1, -1], 0),        # all that friction takes is stored
    ([0, 1, 0], [-1, -1, -1], 0),        # and lost
    ([0, 1, 1], [-1, -1, 1], 0),         # they push back, and hold as much as before: 0 J
    ([0, 1, 1], [-1, -1, 3], 1),         # they push back by more than they stored
    ([0, 3, 3], [-1, -1, -1], 2),        # they store more than friction takes
    ([0, float("nan"), 0], [0, 0, 0], float("nan"))])
def test_what_friction_gives_back_is_found(stored: list[float], power: list[float],
                                           returned: float) -> None:
    """-∫ P dt - S at t = 0, 1, 2 must not fall."""
    trajectory = Trajectory(np.arange(3.0), np.zeros((3, 7)), np.zeros((3, 6)), 0, 0)
    its = bristles_of(Touching(stored=stored, power=power), trajectory, 1.0)
    assert its.returned == pytest.approx(returned, nan_ok=True)
    assert its.passed is (returned <= ENERGY)


@pytest.mark.parametrize("height, risen", [(0.5, False), (1 + 0.5 * KEPT, False), (1.2, True)])
def test_energy_may_fall_and_not_rise_where_effects_only_dissipate(tmp_path: Path, height: float,
                                                                   risen: bool) -> None:
    """A ball that came down from 1 m and is higher now; its kinetic energy was m g 1 m."""
    its = system(checked(written(tmp_path, BALL)), "double", {})
    planned = plan(its, until=1.0)
    q, v = (x.astype(float) for x in its.start())
    q[2] = 1.1
    alarm, alive = Alarm(its, planned, (q, v)), np.array(True)
    low, fast, high = q.copy(), v.copy(), q.copy()
    low[2], fast[2], high[2] = 0.101, -np.sqrt(2 * G * 0.999), 0.1 + height
    assert not alarm(500, 0.5, planned.step, low, fast, alive)
    problems = alarm(500, 1.0, planned.step, high, v, alive)
    assert any("it rose by" in words for _, words in problems.values()) is risen


@pytest.mark.parametrize("more, judged", [
    ("", True), ('[effects.drag.ball]\nkind = "stokes"\nb = 1\n', True),
    ('[effects.wrench.ball]\nforce = [1, 0, 0]\n', False)])
def test_only_scenes_that_nothing_drives_are_judged_so(tmp_path: Path, more: str, judged: bool
                                                       ) -> None:
    its = system(checked(written(tmp_path, BALL + more)), "double", {})
    assert Alarm(its, plan(its, until=1.0), its.start())._passive is judged
