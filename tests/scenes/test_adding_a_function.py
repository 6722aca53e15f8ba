"""A function of scenes is one file: CONTRIBUTING's centre of bodies, in a copy of the generator, is
selected, emitted in every language, recorded with its unit, measured, checked and documented."""

import csv
import math
import re
import subprocess
from fractions import Fraction
from pathlib import Path

import mpmath
import pytest

from coscrew_codegen import run
from coscrew_codegen.algebra.recording.numbers import dot
from coscrew_codegen.dynamics import derive
from coscrew_codegen.dynamics.derivation import Derivation
from coscrew_codegen.scene import functions
from coscrew_codegen.scene.effect import Effect, Place, Torque
from coscrew_codegen.scene.mechanism.assembly import ModelError
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.scene.recorded_quantities import QuantityError, recorded
from coscrew_codegen.scene.scene import Applied
from coscrew_codegen.scene.scene_function import (
    Array,
    AxisLength,
    Depends,
    Of,
    SceneFunction,
    SceneQuantity,
)
from tests.support.scenes import mechanisms as m
from tests.support.walks import command, copied, run_in_copy, walk

SCENE = """
runtime = ["load.mass"]
tiers = ["plain", "accurate"]
[bodies]
plinth = { mass = 4, com = [0, 0, 0.5], inertia = [1, 1, 1] }
sled = { mass = 2, com = [0, 0.25, 0], inertia = [1, 1, 1] }
frame = {}
load = { mass = 1.5, com = [0.5, 0, -0.25], inertia = [1, 1, 1] }
[joints]
base = { type = "fixed", child = "plinth", origin = { xyz = [1, 0, 0] } }
rail = { type = "prismatic", parent = "plinth", child = "sled", axis = [1, 0, 0] }
mount = { type = "fixed", parent = "sled", child = "frame" }
pin = { type = "revolute", parent = "frame", child = "load", axis = [0, 0, 1], \
origin = { xyz = [0, 0, 2] } }
[start.v]
rail = 0.5
pin = 1
[outputs]
record = ["center_of_bodies", "q"]
every = 0.125
[run]
duration = 0.5
step = 0.0078125
[expect."center_of_bodies.z"]
at = 0.5
value = 0.6166666666666667
atol = 1e-12
rtol = 0
"""


def centre(q: tuple[float, float], mass: Fraction = Fraction(3, 2)) -> list[mpmath.mpf]:
    """Σ m (R c + t) / Σ m of the scene, to 50 digits: the plinth, which is fixed, counts."""
    with mpmath.workdps(50):
        x, angle = map(mpmath.mpf, q)
        m3 = mpmath.mpf(mass.numerator) / mass.denominator
        moments = ((4 * 1 + 2 * (1 + x) + m3 * (1 + x + mpmath.cos(angle) / 2)),
                   2 * mpmath.mpf("0.25") + m3 * mpmath.sin(angle) / 2,
                   4 * mpmath.mpf("0.5") + m3 * (2 - mpmath.mpf("0.25")))
        return [y / (6 + m3) for y in moments]


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of the generator that has the function, and a scene."""
    folder = tmp_path_factory.mktemp("site")
    assert [x.name for x in walk(copied(folder), "center_of_bodies")] == ["center_of_bodies.py"]
    (folder / "cart.toml").write_text(SCENE)
    return folder


@pytest.fixture(scope="module")
def out(site: Path) -> Path:
    """Its files in C, Python and CUDA, for one state and for many."""
    done = command(site, "generate", "cart.toml", "-o", "out", "--many", "--cuda")
    assert done.returncode == 0, done.stderr
    return site / "out"


def test_it_is_declared_in_every_language_precision_and_tier(out):
    header = (out / "cart.h").read_text()
    assert re.search(r"x = Σ m \(R c \+ t\) / Σ m, the centre of mass of all bodies in the\s+world",
                     header)
    for suffix in ("", "f"):
        assert f"void cart_center_of_bodies{suffix}(const" in header
        assert f"cart_center_of_bodies_many{suffix}(" in (out / "cart_many.h").read_text()
        assert f"cart_center_of_bodies_kernel{suffix}" in (out / "cart.cuh").read_text()
        assert f"cart_center_of_bodies_accurate{suffix}(" in (out / "cart_accurate.h").read_text()
    for precision in ("double", "single"):
        assert "def center_of_bodies(p, q" in (out / f"cart/{precision}.py").read_text()


@pytest.mark.parametrize("q", [(0.0, 0.0), (0.375, 1.0), (-2.5, 40.0)])
def test_c_computes_it(out, q):
    """With the run-time parameter that a body's mass is; within 4 units in the last place of the
    largest component."""
    (out / "main.c").write_text(
        '#include <stdio.h>\n#include "cart.h"\nint main(void) {\n'
        f"  const double p[1] = {{3.5}}, q[2] = {{{q[0]!r}, {q[1]!r}}};\n  double x[3];\n"
        "  cart_center_of_bodies(p, q, x);\n"
        '  printf("%.17g %.17g %.17g\\n", x[0], x[1], x[2]);\n  return 0;\n}\n')
    subprocess.run(["gcc", "-std=c11", "-Wall", "-Wextra", "-Werror", "main.c", "cart.c", "-o",
                    "main", "-lm"], cwd=out, check=True)
    result = subprocess.run([out / "main"], text=True, capture_output=True, check=True).stdout
    assert_close(list(map(float, result.split())), centre(q, Fraction(7, 2)))


def assert_close(results: list[float], wanted: list[mpmath.mpf]) -> None:
    unit = math.ulp(float(max(map(abs, wanted))))
    assert all(abs(mpmath.mpf(x) - y) <= 4 * unit for x, y in zip(results, wanted, strict=True)), (
        [x.hex() for x in results])


def test_python_computes_it_in_c_numpy_lanes_tiers_and_arrays(site, out):
    result = run_in_copy(site, (
        "import json, sys, numpy as np, coscrew_codegen\n"
        "sys.path.insert(0, 'out')\nimport cart.double as generated\n"
        "its = coscrew_codegen.load_scene('cart.toml', functions=['center_of_bodies'])\n"
        "p, q = np.array([1.5]), np.tile([0.375, 1.0], (64, 1))\n"
        "print(json.dumps([np.asarray(x).tolist() for x in (\n"
        "    its.double.center_of_bodies(p, q[0]), generated.center_of_bodies(p, q[0]),\n"
        "    its.double.center_of_bodies(p, q)[63],\n"
        "    its.accurate.double.center_of_bodies(p, q[0]),\n"
        "    its.arrays(np).center_of_bodies(p, q[0]))]))\n"))
    for row in re.findall(r"\[([^\[\]]+)\]", result):
        assert_close(list(map(float, row.split(","))), centre((0.375, 1.0)))
    assert len(re.findall(r"\[[^\[\]]+\]", result)) == 5


def test_it_is_recorded_with_its_unit_and_expected(site):
    done = command(site, "simulate", "cart.toml", "--output", "cart.csv", "--plot", "cart.svg")
    assert done.returncode == 0, done.stderr
    lines = [x for x in (site / "cart.csv").read_text().splitlines() if not x.startswith("#")]
    header, *rows = csv.reader(lines)
    assert header[1:4] == [f"center_of_bodies.{i} [m]" for i in range(3)]
    for row in rows:
        x, *rest = map(float, row[1:])
        assert_close([x, *rest[:2]], centre((rest[2], rest[3])))
    assert "center" in (site / "cart.svg").read_text()
    done = command(site, "check", "cart.toml")
    assert done.returncode == 0 and "center_of_bodies.z" in done.stdout, done.stdout + done.stderr


def test_its_cost_is_measured_in_its_unit(site):
    done = command(site, "cost", "cart.toml", "--function", "center_of_bodies")
    assert done.returncode == 0, done.stderr
    assert "center_of_bodies" in done.stdout and re.search(r"\dm\b| [nµ]?m\b", done.stdout)


def test_it_is_in_the_reference_and_the_stub(site):
    result = run_in_copy(site, (
        "from coscrew_codegen.reports.reference import scene_pages as s\n"
        "print(s.functions_page('banner'), s.functions_stub('banner'))\n"))
    assert "| `center_of_bodies` | `p` `q` | x = Σ m (R c + t) / Σ m, the centre" in result
    assert "| `center_of_bodies` | 3 × m | 0 to 2 | `center_of_bodies` |" in result
    assert "\n    center_of_bodies: Function[Real]\n" in result


def test_an_error_in_its_arithmetic_names_it(site):
    """A scene whose bodies have no mass, which has all other kinematics."""
    (site / "ghost.toml").write_text(
        'functions = ["center_of_bodies"]\n[bodies]\nghost = {}\n[joints]\n'
        'pin = { type = "continuous", child = "ghost", axis = [0, 0, 1] }\n')
    done = command(site, "generate", "ghost.toml", "-o", "none")
    assert done.returncode == 2 and "a division by zero in center_of_bodies" in done.stderr
    assert "functions without center_of_bodies" in done.stderr and "mass matrix" not in done.stderr


def made(compute, outputs: tuple[Array, ...] = (Array("y", (), ("1",)),), inputs: str = "q",
         **others: object) -> None:
    scene = m.scene(m.pendulum(), m.gravity())
    Derivation(scene).made(SceneFunction("odd", 1, "y", inputs, outputs, compute, **others))


DIVISION = "a division by zero in odd, whatever q is; wanted other numbers, or functions without"


@pytest.mark.parametrize("compute, error, message", (
    (lambda x: [[x.number(1) / 0]], ModelError, DIVISION),
    (lambda x: [], ValueError, "odd: compute returned 0 results; wanted 1: y"),
    (lambda x: [[]], ValueError, "odd: compute returned 0 components of y; wanted 1"),
    (lambda x: [x.argument("v")], ValueError, "no input 'v': it takes q"),
    (lambda x: [[x.argument("q")[0] / 0]], ModelError, DIVISION),
    (lambda x: [[x.power()]], ValueError, r"depends on effects; wanted depends = Depends\.EFF")))
def test_errors_of_a_function_name_it(compute, error, message):
    with pytest.raises(error, match=message) as caught:
        made(compute)
    assert "odd" in " ".join((str(caught.value), *getattr(caught.value, "__notes__", ())))


def test_errors_of_effects_are_not_the_mass_matrix_s():
    """In forward dynamics, which divides by it."""
    law = Effect("odd", "divides", "tau = q/0", Place.JOINT, (),
                 joint_torque=lambda state, values: Torque(state.q / 0))
    scene = m.scene(m.pendulum(), Applied(law, "j0", {}))
    with pytest.raises(ModelError, match="odd at j0: its numbers make a division by zero in "
                                         "forward_dynamics, whatever q is; wanted other numbers"):
        derive(scene, ["forward_dynamics"])


ONE = Array("y", (), ("1",))


@pytest.mark.parametrize("words, message", (
    ({"outputs": (Array("y", (AxisLength.NV,), ("m", "m")),)},
     "odd: y has 1 components and 2 units"),
    ({"inputs": "q speed"}, "odd: no input 'speed'; wanted t, h, p, q"),
    ({"inputs": "h q", "recorded": (SceneQuantity("odd"),)},
     "'odd' is recorded of it, but it takes h"),
    ({"recorded": (SceneQuantity("odd", places=((1,),)),)},
     r"results \(1,\); wanted some of its 1 "),
    ({"recorded": (SceneQuantity("odd", components=("a", "b")),)},
     "with 2 names of its 1 components"),
    ({"recorded": (SceneQuantity("odd", Of.BODY),)}, "'odd' is recorded of it; wanted a quantity"),
    ({"recorded": (SceneQuantity("odd"),), "targets": Of.BODY},
     "wanted a quantity of the scene"),
    ({"outputs": (Array("y", (AxisLength.NV,), ("m",)),), "recorded": (SceneQuantity("odd"),)},
     "units of y depend on the scene")))
def test_entries_that_cannot_be_are_refused(words, message):
    given = {"outputs": (ONE,), "inputs": "q", **words}
    with pytest.raises(ValueError, match=message):
        made(lambda x: [[x.number(1)]], **given)


def test_names_that_exclude_each_other_are_refused():
    first, second, third = (SceneFunction(name, 1, "y", "q", (ONE,), None, recorded=(
        SceneQuantity("odd"),)) for name in ("odd", "oddf", "Odd"))
    with pytest.raises(ValueError, match="'oddf', which is odd in single precision"):
        functions.refuse_names((first, second))
    with pytest.raises(ValueError, match="called 'Odd'; wanted a name as center_of_mass"):
        functions.refuse_names((third,))
    with pytest.raises(ValueError, match="'odd' is recorded of odd and of oddf; rename one"):
        functions.quantities((first, second))


def test_a_family_is_one_entry(monkeypatch, tmp_path):
    """The speed of each body that moves, squared: selected by body, recorded with its unit."""
    def compute(x):
        velocity = x.twist(x.target)[:3]
        return [[dot(velocity, velocity)]]

    family = SceneFunction(
        "speed_BODY", 105, "s = |v|^2 of BODY", "q v",
        (Array("s", (), ("m^2/s^2",), "in m^2/s^2"),), compute, Depends.GEOMETRY,
        recorded=(SceneQuantity("speed", Of.BODY),), targets=Of.BODY)
    monkeypatch.setattr(functions, "FUNCTIONS", (*functions.FUNCTIONS, family))
    monkeypatch.setitem(functions.QUANTITIES, "speed", (family, family.recorded[0]))
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    (tmp_path / "cart.toml").write_text(SCENE.replace('"center_of_bodies", "q"', '"speed.*", "v"')
                                        .partition("[expect")[0])
    done = run(tmp_path / "cart.toml", until=0.25)
    names = [x.name for x in done.recording.columns]
    assert names == ["speed.sled", "speed.frame", "speed.load", "v.rail", "v.pin"]
    assert done.recording.columns[0].unit == "m^2/s^2"
    rail = done.recording.of("v.rail")
    assert done.recording.of("speed.sled").tolist() == (rail * rail).tolist()
    with pytest.raises(QuantityError, match="no body 'plinth' that has it; wanted one of frame"):
        recorded("speed.plinth", read_scene(tmp_path / "cart.toml"))


def test_a_function_may_take_nothing(tmp_path):
    """The mass of a scene: a number without inputs, in C and in generated Python."""
    package = copied(tmp_path)
    (package / "scene/functions/total_mass.py").write_text(
        "from coscrew_codegen.scene.scene_function import Array, SceneFunction, SceneQuantity\n"
        "FUNCTION = SceneFunction(\n"
        "    'total_mass', 86, 'm = Σ m', '', (Array('m', (), ('kg',), 'in kg'),),\n"
        "    lambda x: [[sum((x.number(y.inertia.mass) for y in x.scene.model.bodies\n"
        "                     if y.inertia), x.number(0))]],\n"
        "    recorded=(SceneQuantity('total_mass'),))\n")
    (tmp_path / "cart.toml").write_text(SCENE.replace('runtime = ["load.mass"]', "").replace(
        '"center_of_bodies", "q"', '"total_mass"').partition("[expect")[0])
    done = command(tmp_path, "generate", "cart.toml", "-o", "out", "--many")
    assert done.returncode == 0, done.stderr
    result = run_in_copy(tmp_path, (
        "import sys, coscrew_codegen as c\nsys.path.insert(0, 'out')\n"
        "import cart.double as generated\n"
        "run = c.run('cart.toml', until=0.25)\n"
        "print(generated.total_mass(), c.load_scene('cart.toml').double.total_mass(),\n"
        "      run.recording.of('total_mass').tolist(), run.recording.columns[0].unit)\n"
        "print(generated.total_mass.__doc__)\n"))
    assert result.startswith("7.5 7.5 [7.5, 7.5, 7.5] kg\n") and "Last axes: -> m ()." in result
    subprocess.run(["gcc", "-std=c11", "-Wall", "-Wextra", "-Werror", "-c", "cart.c",
                    "cart_many.c"], cwd=tmp_path / "out", check=True)
