"""Trajectories of tables are SciPy's monotone cubics, to rounding, in every target."""

from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from pathlib import Path

import mpmath
import numpy as np
import pytest
from mpmath import mpf
from scipy.interpolate import PchipInterpolator

from coscrew_codegen import load_scene, run
from coscrew_codegen.scene.readers.scene_error import SceneError
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.scene.readers.toml.trajectories.interpolant import MOST, Interpolant
from tests.support.scenes.evaluation import MULTIPRECISE, Evaluated
from tests.support.scenes.mechanisms import applied, rotor, scene

POINTS = {
    "two": ((0, 1), (2, -3)),
    "three": ((0, 1, 3), (0, 1, 0)),
    "uneven": ((-1, 0, "0.1", 2, 5, "5.5"), (0, 3, 3, -1, "-1.5", 7)),
    "steep": ((0, 1, 2, 3), (0, "1e-9", 1, 1)),
    "flat ends": ((0, 1, 2, 3, 4), (2, 2, 5, 5, 5)),
    "limited end": ((0, 1, 2), (0, "0.1", 9)),
    "end turned": ((0, 1, "1.1"), (0, 1, -9))}


def trajectory(points: str) -> Interpolant:
    times, values = (tuple(map(Fraction, x)) for x in POINTS[points])
    return Interpolant("a of b.csv", times, values)


@pytest.mark.parametrize("points", POINTS)
def test_values_and_rates_are_scipys(points: str) -> None:
    """Between the points and at them, within rounding of SciPy's sums."""
    own = trajectory(points)
    x, y = (np.array([float(a) for a in z]) for z in (own.times, own.values))
    wanted = PchipInterpolator(x, y)
    size = np.abs(y).max()
    steepest = np.abs(wanted.derivative()(np.linspace(x[0], x[-1], 999))).max()
    for t in np.linspace(x[0], x[-1], 101)[:-1]:
        assert abs(own.at(t) - wanted(t)) <= 1e-13 * size
        assert abs(own.rate.at(t) - wanted(t, 1)) <= 1e-12 * max(steepest, size)


@pytest.mark.parametrize("points", POINTS)
def test_ends_hold_their_value(points: str) -> None:
    own = trajectory(points)
    first, last = float(own.times[0]), float(own.times[-1])
    assert own.at(first - 9) == own.at(first) == float(own.values[0])
    assert own.at(last + 9) == own.at(last) == float(own.values[-1])
    assert own.rate.at(first - 1e-9) == own.rate.at(last) == 0


def test_it_is_monotone_where_the_points_are() -> None:
    own = trajectory("steep")
    values = [own.at(t) for t in np.linspace(-1, 4, 2001)]
    assert values == sorted(values) and (values[0], values[-1]) == (0, 1)


@pytest.fixture(autouse=True)
def fifty_digits() -> Iterator[None]:
    with mpmath.workdps(50):
        yield


def test_the_rate_is_the_derivative() -> None:
    own, h = trajectory("uneven"), mpf(10)**-16
    f = {"number": lambda x: mpf(x.numerator) / x.denominator, "min": min, "max": max,
         "less": lambda a, b: a < b, "where": lambda test, a, b: a if test else b,
         "gather": lambda column, at: f["number"](column.at(at))}
    for t in map(mpf, ("-0.5", "0.05", "1", "3", "5.4")):
        slope = (own.value(t + h, f) - own.value(t - h, f)) / (2 * h)
        assert abs(slope - own.rate.value(t, f)) < mpf(10)**-28


def test_programs_have_the_same_values() -> None:
    """A torque from a table, through every branch, at 50 digits."""
    own = trajectory("uneven")
    f = Evaluated(scene(rotor(), applied("actuator", "j0", kind="torque", torque=own)),
                  MULTIPRECISE)
    for t in np.linspace(-2, 7, 37):
        (a,) = f("forward_dynamics", t=mpf(float(t)), q=[0], v=[0], tau=[0])
        assert abs(a - own.at(float(t))) <= 1e-13


# scene files

REACH = """
[bodies]
arm = { mass = 1, inertia = [1, 1, 1] }
fore = { mass = 1, inertia = [1, 1, 1] }
[joints]
elbow = { type = "revolute", child = "arm", axis = [0, 0, 1] }
wrist = { type = "revolute", parent = "arm", child = "fore", axis = [0, 1, 0] }
"""
FOLLOW = """
[effects.actuator.elbow]
kind = "pd"
kp = 4e6
kd = 4e3
target = { file = "reach.csv", column = "elbow" }
"""
TIMES = (0, 0.5, 1.0, 1.25, 2.0)
ELBOW = (0, 0.3, 1.1, 1.1, -0.4)
WRIST = (1, 2, 3, 4, 5)


@pytest.fixture
def written(tmp_path: Path) -> Callable[..., Path]:
    def written(text: str, rows: Sequence[str] | None = None) -> Path:
        lines = rows if rows is not None else [
            "# by hand", "t,elbow,wrist [rad]", *(f"{t},{a},{b}" for t, a, b in zip(
                TIMES, ELBOW, WRIST, strict=True))]
        (tmp_path / "reach.csv").write_text("\n".join(lines) + "\n")
        path = tmp_path / "reach.toml"
        path.write_text(REACH + text)
        return path

    return written


def test_a_file_is_read_exactly(written: Callable[..., Path]) -> None:
    """The rate of the target is the default of target_v; a unit in brackets may be left out."""
    (effect,) = read_scene(written(FOLLOW)).effects
    target, rate = effect.values["target"], effect.values["target_v"]
    assert isinstance(target, Interpolant) and rate == target.rate
    assert target.times == tuple(map(Fraction, TIMES))
    assert target.values == tuple(Fraction(str(x)) for x in ELBOW)
    several = read_scene(written("""
[effects.actuator]
kind = "torque"
torque = { elbow = { file = "reach.csv", column = "elbow" }, wrist = "sin(t)" }
""")).effects
    assert [type(x.values["torque"]).__name__ for x in several] == ["Interpolant", "Formula"]
    both = read_scene(written("""
[effects.actuator]
joints = "all"
kind = "torque"
torque = { file = "reach.csv", column = "wrist", time = "t" }
[effects.wrench.fore]
force = [0, { file = "reach.csv", column = "elbow" }, 1]
""")).effects
    assert [x.values["torque"].values for x in both[:2]] == [tuple(map(Fraction, WRIST))] * 2
    assert both[2].values["force"][1].values[1] == Fraction("0.3")


def test_the_tables_numbers_belong_to_the_scene(written: Callable[..., Path]) -> None:
    """Another number in the table is another scene."""
    before = read_scene(written(FOLLOW)).content_hash
    assert read_scene(written(FOLLOW)).content_hash == before
    rows = ["t,elbow", *(f"{t},{a}" for t, a in zip(TIMES, (0, 0.3, 1.1, 1.1, -0.5), strict=True))]
    assert read_scene(written(FOLLOW, rows)).content_hash != before


@pytest.mark.parametrize("precision", ["double", "single"])
def test_a_joint_follows_its_table(written: Callable[..., Path], precision: str) -> None:
    """A stiff PD controller is within its lag, a/ω², of SciPy's monotone cubic."""
    result = run(written(FOLLOW + "[run]\nduration = 2.5\n"), precision=precision)
    wanted = PchipInterpolator(TIMES, ELBOW)(np.clip(result.t, 0, 2))
    off = np.abs(np.asarray(result.q, float)[:, 0] - wanted)
    assert off[result.t > 0.1].max() < 2e-4


def test_targets_have_the_same_bits(written: Callable[..., Path]) -> None:
    """C, NumPy and the C of many states, in both precisions."""
    kernels = load_scene(written(FOLLOW + '[effects.viscous.wrist]\nd = 1\n'))
    t = np.linspace(-1, 3, 97)
    for precision in ("double", "single"):
        functions = getattr(kernels, precision)
        kind = {"double": np.float64, "single": np.float32}[precision]
        q, v = np.zeros((len(t), 2), kind), np.zeros((len(t), 2), kind)
        many = functions.bias_torques(t.astype(kind), q, v)
        each = np.array([functions.bias_torques(x, q[0], v[0]) for x in t.astype(kind)])
        assert many.tobytes() == each.tobytes()


@pytest.mark.parametrize("rows, says", [
    ([], "is empty"), (["t,elbow"], "has 0 rows of numbers; wanted two or more"),
    (["t,elbow", "0,1"], "has 1 rows of numbers"),
    (["t,elbow", "0,1", "0,2"], "line 3: time 0 after 0; wanted times that increase"),
    (["t,elbow", "0,1", "1,x"], "line 3: 'x' is no number"),
    (["t,elbow", "0,1", "1,nan"], "line 3: nan is not finite"),
    (["t,elbow", "0,1", "1"], "line 3: 1 columns; wanted 2 or more"),
    (["t,elbw", "0,1", "1,2"], "no column of reach.csv 'elbow'; did you mean 'elbw'?"),
    (["time,elbow", "0,1", "1,2"], "no column of reach.csv 't'"),
    (["t,elbow,elbow", "0,1,1", "1,2,2"], "'elbow' names several columns"),
    (["t,elbow", *(f"{k},1" for k in range(MOST + 1))],
     f"has {MOST + 1} rows; wanted at most {MOST}: take fewer points, between which the target is "
     "smooth, or set the target by a controller")])
def test_files_that_are_no_tables_are_refused(written: Callable[..., Path], rows: list[str],
                                              says: str) -> None:
    with pytest.raises(SceneError) as error:
        read_scene(written(FOLLOW, rows))
    assert says in str(error.value)


@pytest.mark.parametrize("target, says", [
    ('{ file = "reach.csv" }', "target.column: missing"),
    ('{ file = "reach.csv", column = "elbow", tme = "t" }', "target.tme: unknown key; did you mean "
     "'time'?"), ('{ file = "other.csv", column = "elbow" }', "other.csv: cannot be read"),
    ('{ file = 3, column = "elbow" }', "target.file"), ("{ column = 3 }", "target.column")])
def test_wrong_keys_are_refused(written: Callable[..., Path], target: str, says: str) -> None:
    old = '{ file = "reach.csv", column = "elbow" }'
    with pytest.raises(SceneError) as error:
        read_scene(written(FOLLOW.replace(old, target)))
    assert says in str(error.value)


def test_numbers_that_are_no_functions_take_no_file(written: Callable[..., Path]) -> None:
    with pytest.raises(SceneError, match="kp"):
        read_scene(written(FOLLOW.replace("kp = 4e6", 'kp = { file = "a.csv", column = "x" }')))
