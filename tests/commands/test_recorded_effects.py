"""Forces and torques of effects, their powers, energies and saturation: in recordings, tables of
sweeps, expectations, pages and generated functions."""

import json
import math
from dataclasses import replace
from pathlib import Path

import mpmath
import numpy as np
import pytest
from selenium.webdriver.common.by import By
from selenium.webdriver.support.ui import WebDriverWait

from coscrew_codegen import load_scene, run
from coscrew_codegen.__main__ import main
from coscrew_codegen.scene.effect import Place
from coscrew_codegen.scene.effect_quantities import (
    functions_of_effects,
    quantities_by_name,
    units_of,
)
from coscrew_codegen.scene.function_selection import resolved
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.scene.recorded_quantities import QuantityError, recorded
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.simulation.recordings.result import Result
from tests.support.browser import chromium, resize
from tests.support.scenes.effect_laws import assert_same
from tests.support.scenes.effect_scenes import PLACES, STATEFUL, effects, mechanism
from tests.support.scenes.evaluation import MULTIPRECISE, Evaluated
from tests.support.scenes.mechanisms import CATALOGUE, scene
from tests.support.scenes.scene_values import random_state
from tests.support.scenes.sweeps import prepared, table

DRIVEN = """
runtime = ["viscous.slide.d"]
[bodies]
cart = { mass = 2, inertia = [0.1, 0.1, 0.1] }
bob = { mass = 1, com = [0, 0, -0.5], inertia = [0.02, 0.02, 0.02] }
[joints]
slide = { type = "prismatic", child = "cart", axis = [1, 0, 0] }
hinge = { type = "revolute", parent = "cart", child = "bob", axis = [0, 1, 0] }
[effects.gravity]
[effects.viscous]
d = { slide = 3, hinge = 0.1 }
[effects.spring.slide]
k = 40
[effects.actuator.hinge]
kind = "pd"
kp = 30
kd = 2
target = "sin(3*t)"
limit = 4
[effects.drag.bob]
kind = "stokes"
b = 0.5
point = [0, 0, -1]
[effects.wrench.gust]
body = "cart"
force = [2, 0, 0]
[effects.spring_damper.cord]
bodies = ["world", "cart"]
first = [3, 0, 4]
k = 5
length = 1
[effects.armature.hinge]
inertia = 0.2
[run]
duration = 1.5
[outputs]
record = RECORD
"""
RECORD = ("q", "v", "viscous.slide.torque", "viscous.slide.power", "viscous.hinge.torque",
          "spring.slide.torque", "spring.slide.energy", "actuator.hinge.torque",
          "actuator.hinge.power", "actuator.hinge.saturated", "drag.bob.force", "drag.bob.torque.y",
          "drag.bob.power", "wrench.gust.force.x", "wrench.gust.power", "spring_damper.cord.force",
          "spring_damper.cord.energy", "spring_damper.cord.power", "armature.hinge.energy",
          "gravity.energy", "gravity.power", "energy", "power")


def written(folder: Path, record: tuple[str, ...] = RECORD, more: str = "") -> Path:
    path = folder / "driven.toml"
    path.write_text(DRIVEN.replace("RECORD", json.dumps(record)) + more)
    return path


@pytest.mark.parametrize("precision", ["double", "single"])
def test_recorded_effects_are_their_formulas(tmp_path: Path, precision: str) -> None:
    """At each sample, of the recorded q and v."""
    result = run(written(tmp_path), precision=precision, p={"viscous.slide.d": 5})
    got = {name: np.asarray(x, float) for name, x in result.recorded.items()}
    t, (x, q), (u, w) = result.t, np.asarray(result.q, float).T, np.asarray(result.v, float).T
    demanded = 30 * (np.sin(3 * t) - q) - 2 * w
    torque = np.clip(demanded, -4, 4)
    s, c, zero = np.sin(q), np.cos(q), 0 * q
    tip = np.array([u - c * w, zero, s * w])  # velocity of the drag's point, 1 m from the hinge
    line = np.hypot(x - 3, 4)
    rate = u * (x - 3) / line
    wanted = {
        "viscous.slide.torque": -5 * u, "viscous.slide.power": -5 * u * u,
        "viscous.hinge.torque": -0.1 * w, "spring.slide.torque": -40 * x,
        "spring.slide.energy": 20 * x * x, "actuator.hinge.torque": torque,
        "actuator.hinge.power": torque * w, "actuator.hinge.saturated": torque != demanded,
        **{f"drag.bob.force.{i}": -0.5 * tip[i] for i in range(3)},
        "drag.bob.torque.1": -0.5 * (-c * tip[0] + s * tip[2]),
        "drag.bob.power": -0.5 * (tip**2).sum(0), "wrench.gust.force.0": 2 + zero,
        "wrench.gust.power": 2 * u, "spring_damper.cord.force": 5 * (line - 1),
        "spring_damper.cord.energy": 2.5 * (line - 1)**2,
        "spring_damper.cord.power": -5 * (line - 1) * rate,
        "armature.hinge.energy": 0.1 * w * w, "gravity.energy": -9.81 * 0.5 * c,
        "gravity.power": -9.81 * 0.5 * s * w}
    assert 0 < got["actuator.hinge.saturated"].mean() < 1
    unit = np.finfo(result.q.dtype).eps
    for name, values in wanted.items():
        size = max(1, np.abs(values).max())
        clear = np.abs(np.abs(demanded) - 4) > 1e-4 if name.endswith("saturated") else t >= 0
        assert np.abs(got[name] - values)[clear].max() <= 200 * unit * size, name
    stored = sum(got[x] for x in ("spring.slide.energy", "spring_damper.cord.energy",
                                  "gravity.energy"))
    assert np.abs(stored - got["energy.potential"]).max() <= 50 * unit * np.abs(stored).max()


def test_columns_have_the_units_of_their_joint(tmp_path: Path) -> None:
    results = {x.name: x.unit for x in run(written(tmp_path)).recording.columns}
    assert {name: results[name] for name in (
        "viscous.slide.torque", "viscous.hinge.torque", "viscous.slide.power",
        "spring.slide.energy", "actuator.hinge.saturated", "drag.bob.force.2",
        "drag.bob.torque.1", "spring_damper.cord.force")} == {
        "viscous.slide.torque": "N", "viscous.hinge.torque": "N m", "viscous.slide.power": "W",
        "spring.slide.energy": "J", "actuator.hinge.saturated": "1", "drag.bob.force.2": "N",
        "drag.bob.torque.1": "N m", "spring_damper.cord.force": "N"}


@pytest.mark.parametrize("name, says", [
    ("actuator.hinge.torqe", "did you mean 'actuator.hinge.torque'?"),
    ("actuatr.hinge.torque", "did you mean 'actuator.hinge.torque'?"),
    ("viscous.slid.power", "did you mean 'viscous.slide.power'?"),
    ("viscous.slide.energy", "stores no energy; wanted viscous.slide.torque, viscous.slide.power"),
    ("viscous.slide.saturated", "has no limit that could saturate"),
    ("spring_damper.cord.torque", "acts between two bodies"),
    ("armature.hinge.torque", "has no torque; wanted armature.hinge.energy"),
    ("drag.bob.force.w", "no component 'w'; wanted 0 to 2, or x, y, z"),
    ("spring.slide.torque.1", "no component '1'; wanted none"),
    ("foo", "or of an effect, as ")])
def test_a_name_that_no_effect_has_is_refused(tmp_path: Path, name: str, says: str) -> None:
    scene = read_scene(written(tmp_path))
    with pytest.raises(QuantityError) as error:
        recorded(name, scene)
    assert says in str(error.value)


def test_functions_of_effects_come_with_their_records_only(tmp_path: Path) -> None:
    chosen = read_scene(written(tmp_path, ("q", "drag.bob.power")))
    assert {x for x in resolved(chosen, ()) if x.startswith("effect_")} == {"effect_drag_bob"}
    kernels = load_scene(written(tmp_path, ("q",)))
    assert not [x for x in dir(kernels.double) if x.startswith("effect_")]
    name = "drag.bob.power"
    late, early = (run(x, record=[name]).recorded[name] for x in (kernels, load_scene(
        written(tmp_path, (name,)))))
    assert np.array_equal(late, early) and early.any()



def pd_torque(result: Result) -> float:
    """The actuator's at the end, by its formula, of the recorded q and v."""
    demanded = 30 * (math.sin(3 * result.t[-1]) - result.q[-1, 1]) - 2 * result.v[-1, 1]
    return min(max(float(demanded), -4.0), 4.0)


@pytest.mark.parametrize("until, saturated", [(0.2, True), (1.5, False)])
@pytest.mark.parametrize("off, status, message", [(0, 0, "pass"), (2e-9, 1, "FAIL"),
                                                  (-2e-9, 1, "FAIL")])
def test_an_expectation_may_be_of_an_effect(tmp_path: Path, capsys: pytest.CaptureFixture,
                                            until: float, saturated: bool, off: float,
                                            status: int, message: str) -> None:
    """It passes with the formula's value, and fails with one that is off by twice the tolerance."""
    torque = pd_torque(run(written(tmp_path, ("q",)), until=until))
    assert (abs(torque) == 4) == saturated
    path = written(tmp_path, ("q",), f"""[expect]
"actuator.hinge.torque" = {{ at = {until}, value = {torque + off!r}, atol = 1e-9 }}
""")
    assert main(["check", str(path), "--precision", "double"]) == status
    (line,) = (x for x in capsys.readouterr().out.splitlines() if "actuator.hinge.torque" in x)
    assert line.split()[0] == message


def test_tables_of_sweeps_have_the_saturated_share(tmp_path: Path) -> None:
    """The mean over time of 0 and 1."""
    path = written(tmp_path, ("actuator.hinge.saturated", "actuator.hinge.torque"))
    its = prepared(tmp_path, path.read_text(), ("viscous.slide.d=1:9:3",))
    rows = table(its)
    one = run(path, p={"viscous.slide.d": 5})
    saturated = one.recorded["actuator.hinge.saturated"]
    share = np.sum(np.diff(one.t) * (saturated[1:] + saturated[:-1]) / 2) / one.t[-1]
    assert rows["actuator.hinge.saturated.mean"][1].as_py() == pytest.approx(share, rel=1e-12)
    assert rows.schema.field("actuator.hinge.torque.maximum").metadata[b"unit"] == b"N m"
    assert rows["actuator.hinge.torque.maximum"][1].as_py() == one.recorded[
        "actuator.hinge.torque"].max()


def test_the_page_shows_recorded_effects(tmp_path: Path) -> None:
    path = written(tmp_path)
    result = run(path)
    assert main(["simulate", str(path), "--view", str(tmp_path / "driven.html")]) == 0
    with chromium() as browser:
        resize(browser, 700, 400)
        browser.get((tmp_path / "driven.html").as_uri())
        WebDriverWait(browser, 20).until(lambda x: x.execute_script(
            "return document.documentElement.dataset.ready !== undefined;"))
        groups = {x.text: x for x in browser.find_elements(By.CSS_SELECTOR, "#groups button")}
        groups["Torque, N·m"].click()
        for k in (0, 40, len(result.t) - 1):
            browser.execute_script("player.clock.seek(arguments[0]); player.update();",
                                   float(result.t[k]))
            beside = dict(browser.execute_script(TORQUES))
            wanted = result.recorded["actuator.hinge.torque"][k]
            assert float(beside["actuator.hinge.torque"]) == pytest.approx(wanted, rel=1e-3)
        names = browser.execute_script("""return player.recording.groups.flatMap(group =>
            group.signals.map(signal => signal.name));""")
        assert browser.get_log("browser") == []
    assert {"Torque, N·m", "Torque, N", "Saturated"} <= {*groups}
    assert {x.name for x in result.recording.columns} <= {*names}


TORQUES = """
    const chart = [...document.querySelectorAll(".signals")].at(-1);
    return [...chart.querySelectorAll("figcaption button")].map(x =>
      [x.childNodes[1].textContent, x.querySelector("output").textContent]);"""


# laws


@pytest.fixture(scope="module")
def everything() -> Evaluated:
    """A mechanism with all kinds of joints, and all effects."""
    return Evaluated(scene(mechanism(), *effects(*PLACES)), MULTIPRECISE)


def quantities(f: Evaluated, state: dict) -> list[tuple[Scene, str, mpmath.mpf]]:
    """(effect, quantity, value) of all that are scalars."""
    results = []
    for name, applied in functions_of_effects(f.scene).items():
        values = iter(f.components(name, **state))
        for quantity, units in units_of(applied, f.scene).items():
            several = [next(values) for _ in units]
            if len(units) == 1:
                results.append((applied, quantity, several[0]))
    return results


def test_effects_add_up_to_the_energy_and_power_of_the_scene(everything: Evaluated) -> None:
    """Potential energies to the potential energy, powers of effects that store nothing to the
    power, except for limits, dampers and added masses, which do both."""
    with mpmath.workdps(50):
        state = random_state(everything, 3)
        del state["tau"]
        result = quantities(everything, state)
        stored = [x for applied, quantity, x in result
                  if quantity == "energy" and not (
                      applied.effect.joint_inertia or applied.effect.body_inertia)]
        assert_same([everything("energy", **state)[1]], [sum(stored)])
        both = {"limit", "spring_damper", "added_mass"}  # the last in wind
        plain = Evaluated(replace(everything.scene, effects=tuple(
            x for x in everything.scene.effects if x.effect.name not in both)), MULTIPRECISE)
        lost = [x for applied, quantity, x in result if quantity == "power"
                and not applied.effect.stores_energy]
        assert_same([plain("power", **state)], [sum(lost)])


def test_every_effect_that_acts_has_quantities(everything: Evaluated) -> None:
    acting = {name for name, x in CATALOGUE.items()
              if not (x.mimic or x.reaction or x.wind or name in STATEFUL)}
    assert {x.effect.name for x in functions_of_effects(everything.scene).values()} == acting
    for name, (_, applied, quantity) in quantities_by_name(everything.scene).items():
        assert name == f"{applied.name}.{quantity}"
        pair = applied.effect.place is Place.PAIR
        assert not pair or quantity != "torque"
