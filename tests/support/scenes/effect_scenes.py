"""A mechanism with all kinds of joints, and effects on it as data: scenes of any of them.

`python -m tests.support.scenes.effect_scenes drag viscous` prints which effects the generator has,
and the hashes of the files generated for all effects except drag and viscous; it also works with a
generator that lacks these effects' files.
"""

import json
import sys
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from hashlib import sha256

from coscrew_codegen.backends.output_files import scene_files
from coscrew_codegen.dynamics import derive
from coscrew_codegen.scene import effects as catalogue
from coscrew_codegen.scene.mechanism.model import HERE, Model
from coscrew_codegen.scene.scene import Applied, Scene
from tests.support.scenes.kinds import Kind
from tests.support.scenes.mechanisms import (
    Formula,
    Value,
    X,
    Y,
    Z,
    applied,
    at,
    chain,
    inertia,
    numbers,
    scene,
)

HALF = Fraction(1, 2)
STATEFUL = tuple(x.name for x in catalogue.EFFECTS if x.ground or any(
    not state.of for state in x.states))
"""Effects that always have states, and the ground of contacts: tests/scenes/test_effect_states.py,
test_lag_and_gear.py and test_contact.py are about them."""
TIMED = (Formula("sin(t)"), Fraction(2), Formula("1 - t"))

PLACES: Mapping[str, Sequence[tuple[str, Mapping[str, Value]]]] = {
    "actuator": [
        ("j1", {"kind": "pd", "kp": 3, "kd": 2, "target": Formula("t"), "limit": 5, "speed": 4}),
        ("j2", {"kind": "dc", "voltage": 9, "kt": 2, "ke": 1, "R": 3}),
        ("j1", {"kind": "torque", "torque": Formula("cos(3*t)")})],
    "added_mass": [
        ("b3", {"mass": (1, 2, 3), "inertia": (HALF, 0, 1), "point": (0, 0, 1)}),
        ("b0", {"matrix": (3, 1, 2, 0, HALF, 4, 0, 0, 1, 2, HALF, 0, 0, 0, 1, 0, 1, 0, 0, 0, 3)})],
    "armature": [("j1", {"inertia": 3}), ("j2", {"rotor": 1, "gear": 2})],
    "buoyancy": [("b2", {"rho": 2, "V": HALF, "centre": (0, 1, 0)})],
    "coulomb": [("j1", {"tau_c": 2, "eps": HALF})],
    "drag": [("b3", {"rho": 2, "area": HALF, "point": (0, 0, 1)}),
             ("b0", {"kind": "stokes", "b": 2})],
    "field": [("b3", {"mu": 70, "centre": (9, -7, 8)}), ("b1", {"mu": 60, "centre": (9, 9, 9)})],
    "gravity": [("", {"g": numbers(1, 2, -9)})],
    "joint_drag": [("j1", {"c": 2}), ("j2", {"c": HALF})],
    "limit": [("j1", {"lower": 1, "k": 9, "alpha": HALF}),
              ("j2", {"lower": -1, "upper": Fraction(1, 5), "k": 9, "alpha": HALF})],
    "mimic": [("", {})],
    "reaction": [("j2", {})],
    "speed_limit": [("j2", {"speed": HALF, "d": 3})],
    "spring": [("j1", {"k": 7, "q0": 1})],
    "spring_damper": [
        ("a", {"bodies": ("world", "b3"), "first": (1, 1, 1), "second": (0, 0, 1), "k": 5, "d": 2,
               "length": HALF}),
        ("b", {"bodies": ("b3", "b1"), "first": (1, 0, 1), "k": 3, "length": 1}),
        ("c", {"bodies": ("b2", "b0"), "first": (1, 2, 1), "d": 3})],
    "stribeck": [("j2", {"tau_c": 1, "tau_s": 2, "v_s": HALF, "eps": HALF})],
    "viscous": [("j1", {"d": 2}), ("j2", {"d": 3})],
    "wind": [("", {"velocity": TIMED})],
    "wrench": [("b3", {"force": TIMED, "torque": TIMED, "point": (1, 0, 1)}),
               ("b2", {"force": TIMED, "frame": "body"})]}


def mechanism() -> Model:
    """A free body with a revolute arm, a slider on it, and a ball joint at its end."""
    full = (3, 4, 5, HALF, Fraction(1, 3), Fraction(-1, 4))
    return chain((Kind.FREE, Z, HERE, inertia(5, (HALF, 0, 1), full)),
                 (Kind.REVOLUTE, Y, at(1, 0, HALF), inertia(2, (0, HALF, 1), full)),
                 (Kind.PRISMATIC, X, at(0, 1, 0), inertia(1, (1, 1, 0), full)),
                 (Kind.SPHERICAL, Z, at(1, 0, 0), inertia(2, (0, 0, 1), full)))


def arm() -> Model:
    """Only its arm and slider, on a fixed base."""
    whole = mechanism()
    kinds = (Kind.FIXED, Kind.REVOLUTE, Kind.PRISMATIC, Kind.FIXED)
    return replace(whole, joints=tuple(replace(joint, kind=kind) for joint, kind in
                                       zip(whole.joints, kinds, strict=True)))


def effects(*names: str) -> tuple[Applied, ...]:
    """The effects of these names, applied to their joints and bodies."""
    return tuple(applied(name, on, **values) for name in names for on, values in PLACES[name])


def all_but(names: Collection[str]) -> Scene:
    """The scene of all effects except these."""
    return scene(arm(), *effects(*(x for x in PLACES if x not in names)))


def assert_listed(listed: Iterable[str], wanted: Iterable[str], table: str, file: str) -> None:
    """Assert that the table in this file has an entry for each wanted effect without states, and no
    others."""
    wanted = set(wanted) - {*STATEFUL}
    missing, unknown = wanted - set(listed), set(listed) - wanted
    assert not missing, f"add {', '.join(sorted(missing))} to {table} in {file}"
    assert not unknown, f"remove {', '.join(sorted(unknown))} from {table} in {file}"


def hashes(made: Scene) -> dict[str, str]:
    """Hashes of the texts of a scene's files."""
    return {path: sha256(text.encode()).hexdigest()
            for path, text in scene_files(derive(made)).items()}


if __name__ == "__main__":
    print(json.dumps([catalogue.__file__, [x.name for x in catalogue.EFFECTS],
                      hashes(all_but(sys.argv[1:]))]))
