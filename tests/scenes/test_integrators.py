"""Integrators' declarations are true; another integrator is one more entry."""

import re
import shutil
import subprocess
import sys
from collections.abc import Callable, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import product
from pathlib import Path

import numpy as np
import pytest

from coscrew_codegen.dynamics.integrator_steps import stepped
from coscrew_codegen.program.interpreter import by_operation, evaluate, exactly
from coscrew_codegen.program.scene_functions import Call, IntegratorStep, SceneFunctions
from coscrew_codegen.runtime.load import kernels_of
from coscrew_codegen.scene import integrators
from coscrew_codegen.scene.integrator import Composition, Drift, Integrator, Kick, Tableau, tableau
from coscrew_codegen.scene.integrators import EMITTED, INTEGRATORS, NAMES, named
from tests.support.operators import operators
from tests.support.scenes.generated_scenes import CASES, files, imported, robot
from tests.support.walks import copied, walk

ROOT = Path(__file__).parents[2]
HALF = Fraction(1, 2)

OTHERS = tuple(x for x in (
    Integrator("midpoint", 2, "a test", tableau("1/2", "0 1")),
    Integrator("heun", 2, "a test", tableau("1", "1/2 1/2")),
    Integrator("ralston", 2, "a test", tableau("2/3", "1/4 3/4")),
    Integrator("bogacki-shampine", 3, "a test", tableau("1/2", "0 3/4", "2/9 1/3 4/9")),
    Integrator("kutta", 3, "a test", tableau("1/2", "-1 2", "1/6 2/3 1/6")),
    Integrator("three-eighths", 4, "a test", tableau("1/3", "-1/3 1", "1 -1 1",
                                                     "1/8 3/8 3/8 1/8")),
    Integrator("verlet", 1, "a test: of order 2 where forces do not depend on speeds",
               Composition((Drift(HALF), Kick(), Drift(HALF)))),
) if x.name not in NAMES)
"""Methods that are not in the catalogue, as a user would add them."""

TABLEAUS = {x.name: x for x in (*EMITTED, *OTHERS) if isinstance(x.scheme, Tableau)}


# the list

def test_each_integrator_is_a_file_of_its_name():
    result = {p.stem for p in Path(integrators.__file__).parent.glob("*.py")} - {"__init__"}
    assert result == {x.name.replace("-", "_") for x in INTEGRATORS}
    assert NAMES[0] == integrators.DEFAULT and len(set(NAMES)) == len(NAMES)


def test_names_of_integrators_stand_in_their_files_alone():
    """Other modules look them up."""
    words = re.compile("|".join(rf"\b{x}\b|step_{x}\b" for name in NAMES
                                for x in {name, name.replace("-", "_")} if name != "leapfrog"))
    for path in sorted((ROOT / "codegen").rglob("*.py")):
        if path.parent.name != "integrators":
            code = re.sub(r'""".*?"""|#[^\n]*', "", path.read_text(), flags=re.DOTALL)
            assert not words.search(code), path


# schemes

def conditions(method: Tableau) -> list[tuple[int, Fraction, Fraction]]:
    """Butcher's conditions to order 4, one for each rooted tree: (order, value, required value)."""
    b, c = method.b, method.c
    n = range(len(b))
    a = [[row[j] if j < len(row) else Fraction(0) for j in n] for row in ((), *method.a)]
    ac = [sum((a[i][j] * c[j] for j in n), Fraction(0)) for i in n]
    ac2 = [sum((a[i][j] * c[j]**2 for j in n), Fraction(0)) for i in n]
    aac = [sum((a[i][j] * ac[j] for j in n), Fraction(0)) for i in n]

    def weighted(values: Sequence[Fraction]) -> Fraction:
        return sum((x * y for x, y in zip(b, values, strict=True)), Fraction(0))

    return [(1, weighted([Fraction(1)] * len(b)), Fraction(1)), (2, weighted(c), Fraction(1, 2)),
            (3, weighted([x**2 for x in c]), Fraction(1, 3)), (3, weighted(ac), Fraction(1, 6)),
            (4, weighted([x**3 for x in c]), Fraction(1, 4)),
            (4, weighted([x * y for x, y in zip(c, ac, strict=True)]), Fraction(1, 8)),
            (4, weighted(ac2), Fraction(1, 12)), (4, weighted(aac), Fraction(1, 24))]


@pytest.mark.parametrize("name", TABLEAUS)
def test_tableaus_have_the_order_they_say_and_no_higher(name: str):
    result = conditions(TABLEAUS[name].scheme)
    true = [all(x == y for order, x, y in result if order <= k) for k in (1, 2, 3, 4)]
    assert true == [k <= TABLEAUS[name].order for k in (1, 2, 3, 4)]


@pytest.mark.parametrize("rows, message", (
    (("1/2", "0 1 0", "1"), "stage 3 of an explicit method: wanted 2 weights, not all zero; "
                            "got 0 1 0"),
    (("0", "1/2 1/2"), "stage 2 of an explicit method: wanted 1 weights, not all zero; got 0"),
    (("1/2", "1/2 1/3"), "b: wanted 2 weights that add up to 1; got 1/2 1/3"),
    (("1/2", "1"), "b: wanted 2 weights that add up to 1; got 1")))
def test_tableaus_that_are_none_are_refused(rows: tuple[str, ...], message: str):
    with pytest.raises(ValueError, match=re.escape(message)):
        tableau(*rows)


OF_STEPS = re.compile(r"(half_)?(kick|drift)(_\w+)?|time_after_\w+|\w+_(displacement|velocity)\w*")
"""Names of the internal functions of steps."""


def test_compositions_of_other_than_one_step_are_refused():
    with pytest.raises(ValueError, match="drifts: wanted parts that add up to 1; they"):
        Composition((Drift(HALF), Kick()))
    with pytest.raises(ValueError, match="kicks: wanted parts that add up to 1; they add up to 0"):
        Composition((Drift(),))


def test_what_a_scene_cannot_take_is_refused():
    fifth = Integrator("fifth", 5, "a test", tableau("1", "1/2 1/2"))
    with pytest.raises(ValueError, match="fifth is of order 5; the chart that moves quaternions is "
                                         "true to order 4"):
        stepped(CASES["spinner"](), [fifth])
    with pytest.raises(ValueError, match="has no function 'implicit_acceleration', which "
                                         "linear-implicit-euler needs"):
        stepped(CASES["pendulum"](), [named("linear-implicit-euler")])


# steps as calls, in exact rationals

def ran(scene: SceneFunctions, step: IntegratorStep, state: dict[str, list]) -> tuple[list, list]:
    """q and v after the calls of a step, in the numbers of `state`."""
    arithmetic = by_operation(lambda x: x.double, exactly(np))
    known = {**state, **{x: [Fraction(0)] * scene.nv for x in step.zeros}}
    for call in step.body:
        assert isinstance(call, Call)
        program, given = scene.named(call.function).program, dict(call.given)
        result = evaluate(program, [known[given.get(a.name, a.name)] for a in program.inputs],
                          arithmetic)
        for name, a in zip(call.results, program.outputs, strict=True):
            known[name], result = result[:a.quantity.size], result[a.quantity.size:]
    return known["q"], known["v"]


def slider_rates(p: list, t: Fraction, q: list, v: list) -> list:
    """The slider's equations of motion."""
    push = t - 1 if t > 1 else Fraction(0)
    rub = [Fraction(3, 10) * x * abs(x) for x in v]
    return [(push - rub[0]) / p[0], (-50 * q[1] - rub[1]) / 2]


def butcher(method: Tableau, f: Callable, t: Fraction, h: Fraction, y: list) -> list:
    """A step of y' = f(t, y), as textbooks write it."""
    k: list[list] = []
    for row, c in zip(((), *method.a), method.c, strict=True):
        k.append(f(t + c * h, [x + h * sum(w * r[i] for w, r in zip(row, k, strict=True))
                               for i, x in enumerate(y)]))
    return [x + h * sum(w * r[i] for w, r in zip(method.b, k, strict=True))
            for i, x in enumerate(y)]


@pytest.mark.parametrize("name", TABLEAUS)
def test_calls_of_a_step_are_the_tableaus_method(name: str):
    """Exactly, for masses on lines with friction, a spring and a force that begins at t = 1."""
    scene = stepped(replace(CASES["slider"](), steps=()), [TABLEAUS[name]])
    p, h = [Fraction(3, 2), Fraction(0)], Fraction(1, 8)

    def rates(t: Fraction, y: list) -> list:
        return [*y[2:], *slider_rates(p, t, y[:2], y[2:])]

    for t in (Fraction(0), Fraction(15, 16), Fraction(2)):
        q, v = [Fraction(1), Fraction(1, 5)], [Fraction(-1, 2), Fraction(3, 4)]
        result = ran(scene, scene.steps[0], {"t": [t], "h": [h], "p": p, "q": q, "v": v})
        assert [*result[0], *result[1]] == butcher(TABLEAUS[name].scheme, rates, t, h, [*q, *v])


def test_calls_of_a_composition_are_its_drifts_and_kicks():
    """With a kick at half a step, where the time is t + h/2."""
    scene = stepped(replace(CASES["slider"](), steps=()), [OTHERS[-1]])
    t, h, p = Fraction(15, 16), Fraction(1, 2), [Fraction(3, 2), Fraction(0)]
    q, v = [Fraction(1), Fraction(1, 5)], [Fraction(-1, 2), Fraction(3, 4)]
    result = ran(scene, scene.steps[0], {"t": [t], "h": [h], "p": p, "q": q, "v": v})
    middle = [x + h / 2 * y for x, y in zip(q, v, strict=True)]
    a = slider_rates(p, t + h / 2, middle, v)
    v = [x + h * y for x, y in zip(v, a, strict=True)]
    assert result == ([x + h / 2 * y for x, y in zip(middle, v, strict=True)], v)


# what is emitted

@pytest.fixture(scope="module")
def all_steps(tmp_path_factory: pytest.TempPathFactory):
    """The slider with all tableaus and compositions it can have: compiled, and in NumPy."""
    known = [x for x in (*EMITTED, *OTHERS) if x.name != integrators.DEFAULT]
    scene = stepped(replace(CASES["slider"](), name="stepper", steps=(), functions=tuple(
        f for f in CASES["slider"]().functions if not OF_STEPS.fullmatch(f.name)
    )), known)
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("XDG_CACHE_HOME", str(tmp_path_factory.mktemp("cache")))
        return scene, kernels_of(scene), imported(scene, tmp_path_factory.mktemp("package"))


@pytest.mark.parametrize("precision", ("double", "single"))
def test_c_and_numpy_step_alike(all_steps, precision: str):
    """To the last bit, in both precisions, also many states at once."""
    scene, kernels, package = all_steps
    assert kernels.compiled and len(scene.steps) >= 10
    draw = np.random.default_rng(7)
    q, v = (draw.normal(size=(5, 2)).astype(getattr(kernels, precision).energy([1, 0], [0, 0],
                                                                               [0, 0])[0].dtype)
            for _ in "qv")
    for step, t in product(scene.steps, (0.0, 0.999)):
        result, wanted = (getattr(getattr(x, precision), step.name)(t, 1 / 8, [1.5, 0], q, v)
                          for x in (kernels, package))
        for x, y in zip(result, wanted, strict=True):
            assert x.dtype == y.dtype and x.tobytes() == y.tobytes(), step.name


@pytest.mark.parametrize("integrator", [x.name for x in (*EMITTED, *OTHERS)
                                        if x.name != integrators.DEFAULT])
def test_errors_fall_with_the_declared_order(all_steps, integrator: str):
    """The order is observed with the slider's spring and force, from a start where its friction is
    smooth."""
    scene, kernels, _ = all_steps
    order = {x.name: x.order for x in (*EMITTED, *OTHERS)}[integrator]
    step = getattr(kernels.double, f"step_{integrator.replace('-', '_')}").repeated

    def end(take: Callable, n: int) -> np.ndarray:
        q, v = take(n, 2.0, 0.1 / n, np.array([1.5, 0]), np.array([0.0, 0.1]), np.array([1.0, 2.0]))
        return np.concatenate((q, v))

    truth = end(kernels.double.step_rk4.repeated, 5000)
    errors = [np.linalg.norm(end(step, n) - truth) for n in (16, 32)]
    assert np.log2(errors[0] / errors[1]) == pytest.approx(order, abs=0.15)


@pytest.mark.parametrize("precision", ("double", "single"))
def test_runs_are_steps_one_by_one_at_their_times(all_steps, precision: str):
    """To the last bit: step k begins at t + k h, in double, then rounded to the precision."""
    scene, kernels, _ = all_steps
    kind = {"double": np.float64, "single": np.float32}[precision]
    p, t, h = kind([1.5, 0]), 0.7, 1 / 30
    for step in scene.steps:
        take = getattr(getattr(kernels, precision), step.name)
        q, v = results = kind([0, 0.1]), kind([1, 2])
        for k in range(20):
            q, v = take(kind(t + k * h), kind(h), p, q, v)
        results = take.repeated(20, t, h, p, *results)
        assert [x.tobytes() for x in results] == [q.tobytes(), v.tobytes()], step.name


@pytest.fixture(scope="module")
def spun(tmp_path_factory: pytest.TempPathFactory):
    """A free body on a spherical joint, with the step of every tableau."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("XDG_CACHE_HOME", str(tmp_path_factory.mktemp("cache")))
        plain = replace(CASES["spinner"](), name="spun", steps=(), functions=tuple(
            f for f in CASES["spinner"]().functions if not OF_STEPS.fullmatch(f.name)))
        return kernels_of(stepped(plain, TABLEAUS.values())).double


@pytest.mark.parametrize("name", TABLEAUS)
def test_orders_hold_on_quaternions(spun, name: str):
    """Each step is taken in the chart at its start; speeds are about 1 rad/s."""
    def end(name: str, n: int) -> np.ndarray:
        take = getattr(spun, f"step_{name.replace('-', '_')}").repeated
        q, v = take(n, 0.0, 1 / n, np.zeros(0), np.array([0, 0, 0, 1.0]), np.array([1.0, 2, -0.5]))
        return np.concatenate((q, v))

    truth = end("rk4", 4000)
    errors = [np.linalg.norm(end(name, n) - truth) for n in (64, 128)]
    assert np.log2(errors[0] / errors[1]) == pytest.approx(TABLEAUS[name].order, abs=0.15)


@pytest.mark.parametrize("scene", [*CASES, "stepper"])
def test_steps_call_and_compute_nothing(scene: str, all_steps):
    functions = all_steps[0] if scene == "stepper" else CASES[scene]()
    texts = files(functions)
    source, module = texts[f"{functions.name}.c"], texts[f"{functions.name}/single.py"]
    bodies = re.findall(rf"^void {functions.name}_step_[^{{]*{{\n(.*?)^}}", source, re.S | re.M)
    assert len(bodies) == len(functions.steps)
    defined = re.findall(r"^def step_.*?(?=^@|\Z)", module, re.S | re.M)
    assert len(defined) == len(functions.steps)
    assert not [x for body in bodies for x in operators(body, "c")]
    assert not [x for body in defined for x in operators(body, "python")]


def test_long_scenes_print_their_dynamics_once():
    """Steps of rk4 with 35 joints are calls.  With its internal functions and a second integrator a
    step adds less than a third of the text of forward dynamics."""
    scene = robot(35, 4000)
    text = files(scene)["robot.c"]
    assert text.count("robot_forward_dynamics(const double") == 1
    scene = replace(scene, steps=())
    plain = files(scene)["robot.c"]
    once = len(plain) - len(files(replace(scene, functions=scene.functions[1:]))["robot.c"])
    assert len(text) - len(plain) < once / 3


def test_adding_heun_is_one_file(tmp_path: Path):
    """In a copy of the generator: scenes, commands and generated files know it."""
    walk(copied(tmp_path), "heun")
    shutil.copy(ROOT / "examples/scenes/pendulum.toml", tmp_path)
    program = ("import sys; sys.path.insert(0, '.'); from coscrew_codegen.__main__ import main; "
               "import coscrew_codegen; "
               f"assert coscrew_codegen.__file__.startswith({str(tmp_path)!r}); "
               "sys.exit(main(sys.argv[1:]))")

    def printed(*words: str) -> str:
        done = subprocess.run([sys.executable, "-c", program, *words], cwd=tmp_path,
                              capture_output=True, encoding="utf-8", check=False)
        assert done.returncode == 0, done.stderr
        return done.stdout

    printed("generate", "pendulum.toml", "-o", "out", "--functions", "default", "step_heun")
    header = (tmp_path / "out/pendulum.h").read_text()
    assert "pendulum_step_heun(double h" in header and "pendulum_step_heunf(float h" in header
    assert "def step_heun(h" in (tmp_path / "out/pendulum/double.py").read_text()
    assert "heun, of order 2: smooth motions" in " ".join(printed("simulate", "--help").split())
    assert "heun" in printed("simulate", "pendulum.toml", "--integrator", "heun", "--until", "0.1",
                          "--output", "out.csv")


