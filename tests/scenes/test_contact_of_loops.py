"""A mechanism with a closed loop lands on the ground and stands: a plate on two legs on a foot."""

from pathlib import Path

import numpy as np
import pytest

from coscrew_codegen import run

G, MASS = 9.81, {"foot": 2.0, "left": 0.3, "right": 0.3, "plate": 1.5}
TABLE = f"""
[bodies]
foot = {{ mass = {MASS["foot"]}, inertia = [0.01, 0.02, 0.02] }}
left = {{ mass = {MASS["left"]}, com = [0, 0, 0.15], inertia = [0.002, 0.002, 0.0002] }}
right = {{ mass = {MASS["right"]}, com = [0, 0, 0.15], inertia = [0.002, 0.002, 0.0002] }}
plate = {{ mass = {MASS["plate"]}, com = [0.1, 0, 0], inertia = [0.005, 0.01, 0.01] }}
[joints.base]
type = "free"
child = "foot"
[joints.left_leg]
type = "continuous"
parent = "foot"
child = "left"
axis = [0, 1, 0]
origin = {{ xyz = [-0.1, 0, 0.05] }}
[joints.right_leg]
type = "continuous"
parent = "foot"
child = "right"
axis = [0, 1, 0]
origin = {{ xyz = [0.1, 0, 0.05] }}
[joints.hinge]
type = "continuous"
parent = "left"
child = "plate"
axis = [0, 1, 0]
origin = {{ xyz = [0, 0, 0.3] }}
[loops.top]
kind = "point"
bodies = ["plate", "right"]
first = [0.2, 0, 0]
second = [0, 0, 0.3]
[effects.gravity]
[effects.spring_damper.brace]
bodies = ["foot", "plate"]
first = [0.1, 0, 0.05]
second = [0, 0, 0]
k = 1e4
d = 20
length = {(0.2**2 + 0.3**2) ** 0.5!r}
[effects.contact.foot]
shape = "box"
size = [0.3, 0.2, 0.1]
mu = 0.6
[start.q]
base = [0, 0, 0.055, 0, 0, 0, 1]
"""


@pytest.mark.parametrize("precision, open_by, off", [("double", 1e-10, 1e-4),
                                                     ("single", 1e-5, 1e-2)])
def test_it_stands_with_its_weight_on_the_ground(tmp_path: Path, precision: str, open_by: float,
                                                 off: float) -> None:
    path = tmp_path / "table.toml"
    path.write_text(TABLE)
    result = run(path, until=2, step=1e-3, precision=precision,
                 record=["q", "v", "x", *(
                     f"contact.foot.{k}.force" for k in range(8))])
    q = np.asarray(result.q[-1], float)
    left, right, hinge = q[7:10]
    ends = [np.array([x - 0.1 + 0.3 * np.sin(a), 0.3 * np.cos(a)]) for x, a in
            ((0.0, left), (0.2, right))]
    plate = ends[0] + 0.2 * np.array([np.cos(left + hinge), -np.sin(left + hinge)])
    assert np.linalg.norm(plate - ends[1]) < open_by
    assert np.abs(result.v[-1]).max() < 1e-3
    weight = sum(result.recorded[f"contact.foot.{k}.force.2"][-1] for k in range(8))
    assert weight == pytest.approx(G * sum(MASS.values()), rel=off)
