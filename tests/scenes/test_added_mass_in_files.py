"""Added masses as files give them, and runs with them: SciPy integrates Kirchhoff's equations once
more."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from coscrew_codegen import run
from coscrew_codegen.scene.readers.scene_error import SceneError
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene

OARSMAN = """
[bodies.hull]
mass = 2
inertia = [0.5, 0.6, 0.7]
[joints.base]
type = "free"
child = "hull"
[effects.added_mass.hull]
mass = [1, 30, 8]
inertia = [0.1, 2, 1]
[start.v]
base = [1, 0.2, -0.1, 0.3, 0.5, -0.2]
[outputs]
record = ["q", "v", "added_mass.hull.energy", "energy.kinetic"]
[run]
duration = 4
"""


@pytest.fixture
def written(tmp_path: Path) -> Callable[[str], Path]:
    def written(text: str) -> Path:
        path = tmp_path / "hull.toml"
        path.write_text(text)
        return path

    return written


def test_a_run_is_scipys_integral_of_kirchhoffs_equations(written: Callable[[str], Path]) -> None:
    """At rtol 1e-12; leapfrog comes within the square of its step, and keeps the energy."""
    M = np.diag([3, 32, 10, 0.6, 2.6, 1.7])

    def rate(t: float, V: np.ndarray) -> np.ndarray:
        p = M @ V
        return np.linalg.solve(M, -np.concatenate([
            np.cross(V[3:], p[:3]), np.cross(V[3:], p[3:]) + np.cross(V[:3], p[:3])]))

    start = [1, 0.2, -0.1, 0.3, 0.5, -0.2]
    wanted = solve_ivp(rate, (0, 4), start, method="DOP853", rtol=1e-12, atol=1e-13).y[:, -1]
    path = written(OARSMAN.replace("duration = 4", "duration = 4\nrtol = 1e-12\natol = 1e-13"))
    assert np.abs(run(path, integrator="dop853").v[-1] - wanted).max() < 1e-10
    off = []
    for step in (2e-3, 1e-3):
        result = run(path, step=step)
        off.append(np.abs(result.v[-1] - wanted).max())
        kinetic = result.recorded["energy.kinetic"]
        assert np.ptp(kinetic) < 2e-5 * kinetic[0]
    assert off[1] < 1e-4 and 3.5 < off[0] / off[1] < 4.5
    parts = result.recorded["added_mass.hull.energy"]
    V = result.v
    assert np.allclose(parts, ((V**2) @ [1, 30, 8, 0.1, 2, 1]) / 2, rtol=1e-12, atol=0)


def test_added_mass_far_larger_than_the_mass_is_harmless(written: Callable[[str], Path]) -> None:
    """A million times, in both precisions, for many steps: the energy stays."""
    path = written(OARSMAN.replace("[1, 30, 8]", "[2e6, 3e6, 1e6]")
                   .replace("[0.1, 2, 1]", "[2e6, 1e6, 3e6]"))
    for precision, close in (("double", 1e-6), ("single", 1e-4)):
        kinetic = run(path, precision=precision, until=20.0).recorded["energy.kinetic"]
        assert np.isfinite(kinetic).all()
        assert np.ptp(kinetic.astype(float)) < close * kinetic[0]


# scene files


ROWS = "[" + ", ".join(str([2 if i == j else 0 for j in range(6)]) for i in range(6)) + "]"


def test_a_matrix_is_read_row_by_row(written: Callable[[str], Path]) -> None:
    text = OARSMAN.replace("mass = [1, 30, 8]", f"matrix = {ROWS}")
    (effect,) = read_scene(written(text)).effects
    assert effect.values["matrix"] == tuple(2 * int(i == j) for i in range(6) for j in range(i + 1))


@pytest.mark.parametrize("matrix, says", [
    ("3", "wanted six rows of six numbers"), ("[[1, 2]]", "wanted six rows of six numbers"),
    (ROWS.replace("[2, 0,", "[2, 1,"), "0 in row 2, column 1, and 1 opposite; wanted a symmetric"),
    (ROWS.replace("[2, 0,", "[-2, 0,"), "its first 1 rows and columns are not positive semidef"),
    (ROWS.replace("[2, 0,", "[2, 3,").replace("[0, 2,", "[3, 2,"), "its first 2 rows"),
    (ROWS.replace("[2, 0,", "[0, 1,").replace("[0, 2,", "[1, 2,"), "its first 1 rows")])
def test_matrices_of_negative_energy_are_refused(written: Callable[[str], Path], matrix: str,
                                                 says: str) -> None:
    with pytest.raises(SceneError) as error:
        read_scene(written(OARSMAN.replace("mass = [1, 30, 8]", f"matrix = {matrix}")))
    assert says in str(error.value) and "effects.added_mass.hull.matrix" in str(error.value)


def test_negative_masses_and_none_are_refused(written: Callable[[str], Path]) -> None:
    for old, new, says in (("[1, 30, 8]", "[1, -30, 8]", "mass: -30"),
                           ("mass = [1, 30, 8]", "", "mass: missing; wanted mass or matrix")):
        with pytest.raises(SceneError) as error:
            read_scene(written(OARSMAN.replace(old, new)))
        assert says in str(error.value)
    flat = OARSMAN.replace("[1, 30, 8]", "[0, 30, 0]").replace("[0.1, 2, 1]", "[0, 0, 0]")
    assert np.isfinite(run(written(flat), until=0.1).v).all()


def test_numbers_may_stay_arguments(written: Callable[[str], Path]) -> None:
    """Their signs are checked; the values of the file give the file's bits of single steps."""
    path = written('runtime = ["added_mass.hull.mass"]\n' + OARSMAN)
    named = run(path, p={"added_mass.hull.mass.y": 60})
    path = written(OARSMAN.replace("30", "60"))
    assert np.abs(named.v - run(path).v).max() < 1e-12
