"""Functions and steps that move states of effects, or solve rows of forces between bodies and on
sums of coordinates, have the same bits in C, in NumPy, in lanes and in CUDA; scenes without states
have no trace of them."""

from pathlib import Path

import pytest

from coscrew_codegen.backends.python_extension import scene_calls
from coscrew_codegen.backends.scene import scene_c
from coscrew_codegen.dynamics import derive
from coscrew_codegen.program.scene_functions import SceneFunctions
from coscrew_codegen.runtime.load import kernels_of
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from tests.support.compiled.c_harness import C11, COMPILERS, CXX_COMPILERS, run
from tests.support.compiled.flags import FMA
from tests.support.each import each_precision
from tests.support.scenes import lanes_program
from tests.support.scenes.cuda_program import of_scene
from tests.support.scenes.cuda_runs import compared
from tests.support.scenes.generated_scenes import imported
from tests.support.scenes.scene_values import inputs, same_bits

STEPS = ("step_rk4", "step_semi_implicit_euler", "step_linear_implicit_euler", "step_leapfrog")
NAMES = ("state_rates", "law_switches", "integrated", *STEPS, "energy", "power", "bristles")
WITHOUT = """
[bodies]
ball = { mass = 1, com = [0, 0, 0.01], inertia = [0.004, 0.004, 0.004] }
arm = { mass = 0.2, inertia = [0.001, 0.001, 0.001] }
[joints]
free = { type = "free", child = "ball" }
hinge = { type = "revolute", parent = "ball", child = "arm", axis = [0, 1, 0] }
[effects.gravity]
"""
WITH = """
[effects.contact.ball]
shape = "sphere"
radius = 0.1
mu = 0.5
[effects.stiction.hinge]
tau_c = 0.1
tau_s = 0.2
[effects.gear.hinge]
k = 1e4
rotor = 1e-5
gear = 50
[effects.actuator.hinge]
kind = "pd"
kp = 30
kd = 1
target = "sin(3*t)"
limit = 5
speed = 20
lag = 2e-3
"""
ROWS = """
[bodies]
ball = { mass = 1, com = [0, 0, 0.01], inertia = [0.004, 0.004, 0.004] }
arm = { mass = 0.2, inertia = [0.001, 0.001, 0.001] }
hand = { mass = 0.1, com = [0, 0, 0.1], inertia = [0.001, 0.001, 0.001] }
bead = { mass = 0.001, inertia = [4e-6, 4e-6, 4e-6] }
[joints]
free = { type = "free", child = "ball" }
hinge = { type = "revolute", parent = "ball", child = "arm", axis = [0, 1, 0] }
slide = { type = "prismatic", parent = "arm", child = "hand", axis = [0, 0, 1] }
loose = { type = "free", child = "bead" }
[effects.gravity]
[effects.spring_damper.one]
bodies = ["ball", "bead"]
k = 1e6
d = 10
length = 0.2
[effects.spring_damper.two]
bodies = ["hand", "world"]
k = 300
d = 1e4
[effects.contact_pair.bead]
bodies = ["bead", "hand"]
first_radius = 0.5
second_radius = 0.6
second_end = [0, 0, 0.3]
mu = 0.5
load = 1
[effects.spring.tendon]
joints = { hinge = 1, slide = -0.5 }
k = 1e5
[effects.viscous.tendon]
joints = { hinge = 1, slide = -0.5 }
d = 100
"""
SCENES = {"states": (WITHOUT + WITH, NAMES),
          "rows": (ROWS, (*STEPS, "forward_dynamics", "energy", "power", "bristles"))}


@pytest.fixture(scope="module", params=SCENES)
def made(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory
         ) -> SceneFunctions:
    text, names = SCENES[request.param]
    path = tmp_path_factory.mktemp(request.param) / "ball.toml"
    path.write_text(text, encoding="utf-8")
    made = derive(read_scene(path), names)
    assert {*names} <= {x.name for x in scene_calls.callables(made)}
    return made


@each_precision
def test_bits_of_numpy_are_those_of_c(made: SceneFunctions, precision, tmp_path: Path,
                                      monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    kernels, package = kernels_of(made), imported(made, tmp_path)
    assert kernels.compiled
    for function in scene_calls.callables(made):
        for special in (False, True):
            arguments = inputs(function, precision.numpy_type, 5, special=special)
            result, twin = (getattr(getattr(x, precision.name), function.name)(*arguments)
                            for x in (kernels, package))
            assert same_bits(result, twin), function.name


def test_bits_in_lanes_are_those_of_one_state(made: SceneFunctions, tmp_path: Path) -> None:
    sources = lanes_program.written(made, tmp_path)
    run((COMPILERS[0], *C11, "-O1", *FMA, *sources, "-o", tmp_path / "lanes", "-lm"))
    assert int(run([tmp_path / "lanes"])) > 5000


def test_bits_of_cuda_are_those_of_c(made: SceneFunctions, tmp_path: Path) -> None:
    assert compared(of_scene(made), tmp_path, CXX_COMPILERS[0], "-O1", *FMA) > 5000


def test_a_scene_without_states_has_no_trace_of_them(tmp_path: Path) -> None:
    path, texts = tmp_path / "ball.toml", []
    for text in (WITHOUT, WITHOUT + WITH):
        path.write_text(text, encoding="utf-8")
        texts.append("".join(scene_c.files(derive(read_scene(path), ("step_rk4",)),
                                           "banner").values()))
    for word in ("state_rates", "states_of_effects", "dx1"):
        assert word not in texts[0]
    assert "state_rates" in texts[1] and "dx1" in texts[1]
