"""Tables that are read at a computed index: rows as exact arithmetic chooses them, the bits of one
state in every target, and defined results at any number."""

from collections.abc import Callable
from fractions import Fraction
from itertools import pairwise
from math import inf, nan
from pathlib import Path

import numpy as np
import pytest

from coscrew_codegen import load_scene
from coscrew_codegen.accuracy.precision_tuning.array_evaluation import evaluator
from coscrew_codegen.algebra.recording import numbers as n
from coscrew_codegen.algebra.recording.recorder import Recorder, array
from coscrew_codegen.backends.python_extension import scene_calls
from coscrew_codegen.dynamics import derive
from coscrew_codegen.program import Program
from coscrew_codegen.program.in_python import FLOATS
from coscrew_codegen.program.interpreter import evaluate
from coscrew_codegen.program.scene_functions import SceneFunctions
from coscrew_codegen.program.tables import ConstantTable, TableColumn, index_of
from coscrew_codegen.program.values.formats import DOUBLE, PRECISIONS, SINGLE, Precision
from coscrew_codegen.program.values.table_arrays import rounded
from coscrew_codegen.runtime.load import kernels_of
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.scene.readers.toml.trajectories.interpolant import Interpolant
from tests.support.compiled.c_harness import CXX_COMPILERS
from tests.support.compiled.flags import HASWELL, SANITIZERS
from tests.support.scenes.cuda_program import of_scene
from tests.support.scenes.cuda_runs import compared
from tests.support.scenes.generated_scenes import imported
from tests.support.scenes.scene_values import inputs, same_bits

ROWS = ConstantTable(tuple(map(Fraction, ("0.1", 7, -3, "1e-9", 5, 11))), 2, 2)
OVERLAPPING = ConstantTable(tuple(map(Fraction, range(10, 17))), 1, 4)


@pytest.mark.parametrize("x, index", [
    (nan, 0), (-inf, 0), (-1, 0), (-0.0, 0), (0.99, 0), (1, 1), (2.99, 2), (3, 2), (1e300, 2),
    (inf, 2), (Fraction(5, 2), 2)])
def test_an_index_is_an_integer_part_within_the_rows(x: float, index: int) -> None:
    assert index_of(x, 3) == index


def test_rows_may_overlap() -> None:
    assert (ROWS.rows, OVERLAPPING.rows) == (3, 4)
    assert [TableColumn(ROWS, 1).at(k) for k in range(4)] == [7, Fraction("1e-9"), 11, 11]
    assert TableColumn(OVERLAPPING, 3).values == (13, 14, 15, 16)
    assert TableColumn(OVERLAPPING, 1).values == (11, 12, 13, 14)


def reading(columns: list[TableColumn]) -> Program:
    """The columns' numbers at x, and x's index."""
    recorder = Recorder([array("x", ())])
    (x,) = recorder.argument("x")
    results = [*(n.gather(column, x) for column in columns), n.index(x, 3)]
    return recorder.program("reading", [(array("y", (len(results),)), results)])


def test_constant_indices_and_equal_numbers_fold() -> None:
    recorder = Recorder([array("x", ())])
    (x,) = recorder.argument("x")
    same = ConstantTable((Fraction(1), Fraction(4), Fraction(2), Fraction(4)), 2, 2)
    at = recorder.number(Fraction(3, 2))
    assert n.gather(TableColumn(ROWS, 1), at).constant == Fraction("1e-9")
    assert n.gather(TableColumn(same, 1), x).constant == 4
    assert n.gather(TableColumn(same, 0), x).constant is None
    assert n.index(recorder.number(Fraction(-1, 2)), 3).constant == 0


@pytest.mark.parametrize("precision", PRECISIONS, ids=lambda x: x.name)
def test_arrays_and_numbers_read_the_same(precision: Precision) -> None:
    program = reading([TableColumn(ROWS, 0), TableColumn(OVERLAPPING, 2)])
    places = np.array([nan, -inf, -2, 0, 0.5, 1, 1.5, 2, 2.5, 3, 99, inf], precision.numpy_type)
    results = evaluator(program, precision)([[places]])
    for k, x in enumerate(places):
        exact = evaluate(program, [[float(x)]], FLOATS)
        assert [y[k] for y in results] == [getattr(np, precision.numpy_type)(y) for y in exact]


@pytest.mark.parametrize("precision", PRECISIONS, ids=lambda x: x.name)
def test_numbers_are_rounded_once(precision: Precision) -> None:
    """Takes values beside the middle of two numbers of single precision, and tiny ones."""
    middle = 1 + Fraction(1, 2**24)
    values = (middle, middle + Fraction(1, 2**80), middle - Fraction(1, 2**80), Fraction("0.1"),
              Fraction(3, 2**150), Fraction(1, 2**150) + Fraction(1, 2**200), Fraction(0))
    results = rounded(ConstantTable(values, 1, 1), precision)
    assert [float(x).hex() for x in results] == [float(precision.rounded(x)).hex() for x in values]


# trajectories, as the rows of exact arithmetic say


def exactly(own: Interpolant, t: Fraction) -> Fraction:
    """The piecewise cubic in rationals, as the generator's formula says."""
    def number(x: Fraction) -> Fraction:
        return x

    return own.value(t, {"number": number, "less": lambda a, b: a < b, "where": lambda test, a, b: (
        a if test else b), "gather": lambda column, at: column.at(at)})


def monotone_slopes(own: Interpolant) -> list[Fraction]:
    """The slopes at the points (Fritsch and Butland, 1984; at the ends as in SciPy's PCHIP)."""
    h = [b - a for a, b in pairwise(own.times)]
    m = [(b - a) / x for (a, b), x in zip(pairwise(own.values), h, strict=True)]
    if len(h) == 1:
        return m * 2
    ends = []
    for (h0, h1), (m0, m1) in ((h[:2], m[:2]), (h[:-3:-1], m[:-3:-1])):
        d = ((2 * h0 + h1) * m0 - h0 * m1) / (h0 + h1)
        ends.append(Fraction(0) if d * m0 <= 0 else
                    3 * m0 if m0 * m1 < 0 and abs(d) > 3 * abs(m0) else d)
    inner = [3 * (h0 + h1) / ((2 * h1 + h0) / m0 + (h1 + 2 * h0) / m1) if m0 * m1 > 0 else
             Fraction(0) for (h0, h1), (m0, m1) in zip(pairwise(h), pairwise(m), strict=True)]
    return [ends[0], *inner, ends[1]]


def by_search(own: Interpolant, t: Fraction) -> Fraction:
    """The value by Hermite's form of the piece that holds t, which a plain search finds."""
    if not own.times[0] <= t < own.times[-1]:
        return own.values[0 if t < own.times[0] else -1]
    i = max(k for k, x in enumerate(own.times) if x <= t)
    a, b = own.times[i:i + 2]
    slopes = monotone_slopes(own)[i:i + 2]
    u, h = (t - a) / (b - a), b - a
    return ((1 + 2 * u) * (1 - u)**2 * own.values[i] + u * (1 - u)**2 * h * slopes[0]
            + u * u * (3 - 2 * u) * own.values[i + 1] + u * u * (u - 1) * h * slopes[1])


def points(kind: str, count: int) -> Interpolant:
    rng = np.random.default_rng(5)
    times = {"even": [Fraction(k, 100) for k in range(count)],
             "nearly even": [Fraction(k, 100) + Fraction(int(e), 1000) for k, e in enumerate(
                 rng.integers(0, 2, count))],
             "uneven": [Fraction(int(x), 10**4) for x in np.cumsum(rng.integers(1, 300, count))]}
    values = tuple(Fraction(int(x), 1000) for x in rng.integers(-1000, 1000, count))
    return Interpolant(f"{kind} points", tuple(times[kind]), values)


KINDS = ("even", "nearly even", "uneven")


def edges(own: Interpolant, kind: type) -> np.ndarray:
    """Times before, at, an ulp beside, between and behind the points."""
    knots = np.array([float(x) for x in own.times], kind)
    inside = np.array([(a + b) / 2 for a, b in pairwise(knots)], kind)
    return np.concatenate([knots, np.nextafter(knots, kind(-inf)), np.nextafter(knots, kind(inf)),
                           inside, kind([-1e30, -1, knots[-1] + 1, 1e30])])


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("count", [2, 3, 4, 5, 17, 200])
def test_the_row_is_that_of_a_search(kind: str, count: int) -> None:
    """In exact arithmetic, at every knot and beside it."""
    own = points(kind, count)
    h = Fraction(1, 10**9)
    for x in own.times:
        for t in (x - h, x, x + h):
            assert abs(exactly(own, t) - by_search(own, t)) < Fraction(1, 10**25)
    first, last = own.times[0], own.times[-1]
    assert exactly(own, first - 10**40) == own.values[0]
    assert exactly(own, last + 10**40) == own.values[-1]


def scene(folder: Path, own: Interpolant, more: str = "") -> Path:
    """A torque that is a trajectory."""
    rows = [f"{float(t)!r},{float(y)!r}" for t, y in zip(own.times, own.values, strict=True)]
    (folder / "own.csv").write_text("\n".join(["t,elbow", *rows]))
    path = folder / "own.toml"
    path.write_text(f"""
[bodies]
arm = {{ mass = 1, inertia = [1, 1, 1] }}
[joints]
elbow = {{ type = "revolute", child = "arm", axis = [0, 0, 1] }}
[effects.actuator.elbow]
kind = "torque"
torque = {{ file = "own.csv", column = "elbow" }}
{more}""")
    return path


def torques(functions: object, t: np.ndarray) -> np.ndarray:
    zero = np.zeros((len(t), 1), t.dtype)
    call: Callable[..., object] = functions.bias_torques  # type: ignore[attr-defined]
    return -np.asarray(call(t, zero, zero)).reshape(-1)


@pytest.mark.parametrize("precision", PRECISIONS, ids=lambda x: x.name)
@pytest.mark.parametrize("kind", KINDS)
def test_kernels_are_near_the_exact_polynomial(tmp_path: Path, kind: str, precision: Precision
                                               ) -> None:
    """Within 8 u of the sizes of its terms and, where a knot is rounded, of the slope's effect; NaN
    at NaN."""
    own = points(kind, 60)
    number = {DOUBLE: np.float64, SINGLE: np.float32}[precision]
    functions = getattr(load_scene(scene(tmp_path, own), functions=["bias_torques"]),
                        precision.name)
    t = edges(own, number)
    results = torques(functions, t)
    u = precision.u
    for x, y in zip(t.tolist(), results.tolist(), strict=True):
        at = Fraction(x)
        steepest = max(abs(exactly(own.rate, at + e)) for e in (-u * abs(at), 0, u * abs(at)))
        wanted = exactly(own, at)
        room = 8 * u * (2 + abs(wanted)) + 2 * u * min(abs(at), 10) * (steepest + 1)
        assert abs(Fraction(y) - wanted) <= room, (float(at).hex(), y.hex(), float(wanted).hex())
    assert np.isnan(torques(functions, np.array([nan], number))).all()


# in every target


def driven(folder: Path, kind: str) -> SceneFunctions:
    """An arm that a table drives, beside friction, and whose end touches heights of a table."""
    rng = np.random.default_rng(8)
    heights = rng.integers(-9, 9, (4, 5)) / 100 - 0.01
    (folder / "ground.csv").write_text("\n".join(["y,-1,-0.5,0,0.5,1", *(
        f"{y},{','.join(map(str, row))}" for y, row in zip((-1, 0, 1, 2), heights, strict=True))]))
    path = scene(folder, points(kind, 40), """
[effects.viscous.elbow]
d = 1
[effects.gravity]
[effects.ground]
height = { file = "ground.csv" }
[effects.contact.arm]
shape = "point"
point = [0.7, 0.2, 0]
mu = 0.5
k = 100
""")
    return derive(read_scene(path), ("bias_torques", "step_leapfrog"))


@pytest.mark.parametrize("kind", KINDS)
def test_c_numpy_and_many_states_have_the_same_bits(kind: str, tmp_path: Path,
                                                    monkeypatch: pytest.MonkeyPatch) -> None:
    functions = driven(tmp_path, kind)
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    kernels, package = kernels_of(functions), imported(functions, tmp_path)
    assert kernels.compiled
    for precision in PRECISIONS:
        for function in scene_calls.callables(functions):
            compiled, twin = (getattr(getattr(x, precision.name), function.name)
                              for x in (kernels, package))
            for special in (False, True):
                batch = inputs(function, precision.numpy_type, 65, special=special)
                with np.errstate(all="ignore"):
                    many = compiled(*batch)
                    assert same_bits(many, twin(*batch)), function.name
                for k in range(0 if special else 65):
                    row = tuple(x[k] for x in many) if isinstance(many, tuple) else many[k]
                    assert same_bits(compiled(*(x[k] for x in batch)), row)


@pytest.mark.parametrize("flags", [("-O2", *HASWELL, "-ffp-contract=fast"), ("-O0", *SANITIZERS)],
                         ids=["fused", "sanitized"])
def test_cuda_on_the_host_has_the_same_bits(flags: tuple[str, ...], tmp_path: Path) -> None:
    """Sanitizers watch the conversion of indices and the reads of tables."""
    made = of_scene(driven(tmp_path, "nearly even"))
    assert compared(made, tmp_path, CXX_COMPILERS[0], *flags) > 1000


@pytest.mark.parametrize("kind", KINDS)
def test_certified_bounds_hold(tmp_path: Path, kind: str) -> None:
    """At knots and beside them; between knots they are of the size of rounding errors."""
    own = points(kind, 30)
    made = load_scene(scene(tmp_path, own), functions=["bias_torques"], tiers=["certified"])
    for precision, number in ((DOUBLE, np.float64), (SINGLE, np.float32)):
        functions = getattr(made.certified, precision.name)
        between = np.random.default_rng(3).uniform(0, float(own.times[-1]), 200).astype(number)
        t = np.concatenate([between, edges(own, number)[:-4]])
        zero = np.zeros((len(t), 1), number)
        value, bound = (np.asarray(x, number).reshape(-1) for x in functions.bias_torques(
            t, zero, zero))
        for x, y, b in zip(t.tolist(), value.tolist(), bound.tolist(), strict=True):
            assert np.isfinite(b) and abs(Fraction(y) + exactly(own, Fraction(x))) <= Fraction(b)
        assert np.median(bound[:len(between)]) < 40 * float(precision.u)
