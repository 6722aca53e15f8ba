"""Tangents and adjoints of a scene's functions, and the derivatives of its steps: differences in 50
digits, along velocities, with every effect and with free, spherical and other joints."""

from pathlib import Path

import mpmath
import numpy as np
import pytest
from mpmath import mpf

from coscrew_codegen.dynamics import derive
from coscrew_codegen.program import Op
from coscrew_codegen.scene.function_selection import all_names, names, resolved
from coscrew_codegen.scene.functions import functions_of
from coscrew_codegen.scene.integrator import Integrator
from coscrew_codegen.scene.integrators import EMITTED, named
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.scene.scene import Scene
from tests.support.scenes import mechanisms as m
from tests.support.scenes.differences import ACTING, scene_with, state
from tests.support.scenes.differentiated import (
    CLOSE,
    STEP,
    arguments,
    check,
    check_step,
    entry,
    results,
)
from tests.support.scenes.evaluation import DOUBLE, SINGLE, evaluator
from tests.support.scenes.scene_texts import TIMED


@pytest.fixture(scope="module")
def scene() -> Scene:
    return scene_with(ACTING)


WHOLE = ["inverse_dynamics", "forward_dynamics", "mass_matrix", "bias_torques", "energy", "power",
         "momentum", "body_poses", "body_twists", "integrated", "difference", "gravity_torques",
         "torque_regressor", "coriolis_matrix", "energy_gradients", "centroidal_momentum_matrix",
         "centroidal_momentum_rate", "center_of_mass", "center_of_mass_velocity",
         "center_of_mass_jacobian", "chart", "step_leapfrog", "step_linear_implicit_euler"]


@pytest.mark.parametrize("name", WHOLE)
def test_they_are_differences_in_50_digits(scene: Scene, name: str) -> None:
    check(scene, entry(scene, name))


@pytest.mark.parametrize("stem", [
    "jacobian_", "point_jacobian_", "aligned_jacobian_", "aligned_point_jacobian_",
    "world_jacobian_", "acceleration_", "twist_rate_", "point_twist_rate_", "aligned_twist_rate_",
    "aligned_point_twist_rate_", "world_twist_rate_", "reaction_", "effect_"])
def test_of_members_of_families(scene: Scene, stem: str) -> None:
    check(scene, [x for x in functions_of(scene) if x.name.startswith(stem)][2])


@pytest.fixture(scope="module")
def timed(tmp_path_factory: pytest.TempPathFactory) -> Scene:
    """Masses, a damping and a gain at run time, and a torque that changes with time."""
    path = tmp_path_factory.mktemp("timed") / "arm.toml"
    path.write_text(TIMED)
    return read_scene(path)


@pytest.fixture(scope="module")
def undamped(tmp_path_factory: pytest.TempPathFactory) -> Scene:
    """A mass at run time and a torque that changes with time, without damping and stiffness, so
    that implicit accelerations are explicit."""
    path = tmp_path_factory.mktemp("undamped") / "arm.toml"
    table, _, _ = TIMED.partition("[effects.viscous]")
    path.write_text(table.replace(', "viscous.elbow.d", "actuator.elbow.kp"', "") +
                    '[effects.actuator.elbow]\nkind = "torque"\ntorque = "sin(t)"\n')
    return read_scene(path)


@pytest.mark.parametrize("name", ["inverse_dynamics", "forward_dynamics", "energy", "momentum",
                                  *(x.step_with_tau for x in EMITTED)])
def test_by_parameters_and_time(timed: Scene, name: str) -> None:
    function = entry(timed, name)
    check(timed, function)
    assert {"g_p", "g_q"} <= {x.name for x in entry(timed, f"{name}_adjoint").outputs}
    assert ("g_t" in {x.name for x in entry(timed, f"{name}_adjoint").outputs}) == (
        name != "momentum")


@pytest.mark.parametrize("acting, integrator", [
    ("all", named("semi-implicit-euler")), *(("timed", x) for x in EMITTED),
    *(("undamped", x) for x in EMITTED)],
    ids=lambda x: getattr(x, "name", x))
def test_derivatives_of_steps(request: pytest.FixtureRequest, acting: str, integrator: Integrator
                              ) -> None:
    """A, B_tau and B_p are the tangents along unit directions."""
    fixture = "scene" if acting == "all" else acting
    check_step(request.getfixturevalue(fixture), integrator)


DAMPED = """
runtime = ["hand.mass", "armature.swing.rotor"]
[bodies]
crate = { mass = 2, com = [0, 0.1, -0.25], inertia = [0.04, 0.04, 0.002] }
arm = { mass = 1, com = [0.05, 0, -0.2], inertia = [0.01, 0.01, 0.001] }
hand = { mass = 1, com = [0.1, 0.2, 0.1], inertia = [0.01, 0.01, 0.01] }
finger = { mass = 0.5, com = [0, 0.1, 0], inertia = [0.01, 0.01, 0.01] }
thumb = { mass = 0.2, com = [0, 0.3, 0], inertia = [0.001, 0.001, 0.001] }
[joints]
base = { type = "free", child = "crate" }
socket = { type = "spherical", parent = "crate", child = "arm", origin = { xyz = [0.1, 0.2, 0] } }
swing = { type = "revolute", parent = "arm", child = "hand", axis = [0, 0.6, 0.8] }
bend = { type = "revolute", parent = "arm", child = "thumb", axis = [1, 0, 0] }
[joints.slide]
type = "prismatic"
parent = "hand"
child = "finger"
axis = [0, 0, 1]
mimic = { joint = "swing", multiplier = 0.5 }
[effects.gravity]
[effects.viscous]
d = { socket = 0.7, swing = 0.3, slide = 20 }
[effects.armature]
gear = 10
rotor = { swing = 0.001 }
[effects.coulomb.bend]
tau_c = 2
eps = 0.01
[effects.actuator.swing]
kind = "pd"
kp = 20
kd = 2
limit = 3
target = "0.5*sin(2*pi*t)"
[effects.actuator.bend]
kind = "torque"
torque = "sin(30*t)"
"""
WATER = """
[effects.added_mass.hand]
mass = [0.3, 0.5, 0.7]
"""
FOLLOWED = """
[effects.mimic]
joints = "all"
"""


@pytest.mark.parametrize("more", ["", FOLLOWED], ids=["free", "followed"])
@pytest.mark.parametrize("integrator", [named("leapfrog"), named("linear-implicit-euler")],
                         ids=lambda x: x.name)
def test_derivatives_of_damped_steps(tmp_path: Path, integrator: Integrator, more: str) -> None:
    """Joints of several freedoms, branches and leaders, all damped."""
    path = tmp_path / "crate.toml"
    path.write_text(DAMPED + more)
    check_step(read_scene(path), integrator)


def test_derivatives_of_a_step_through_water(tmp_path: Path) -> None:
    """Effects that add inertia count, beside damped joints."""
    path = tmp_path / "crate.toml"
    path.write_text(DAMPED + WATER)
    check_step(read_scene(path), named("leapfrog"))


def test_solutions_are_not_differentiated() -> None:
    """Derivatives of a damped arm's steps cost less than half as much as in forward mode."""
    functions = derive(read_scene(Path("examples/scenes/arm6.toml")), (
        "step_leapfrog_derivatives",))
    program = functions.named("step_leapfrog_derivatives").program
    assert len([x for x in program.instructions if x.op is not Op.NEG]) <= 12_200


CORNERS = """
[bodies]
door = { mass = 2, com = [0, 0.1, -0.25], inertia = [0.04, 0.04, 0.002] }
ball = { mass = 1, com = [0.05, 0, -0.2], inertia = [0.01, 0.01, 0.001] }
dust = { mass = 1, com = [0, 0, 0], inertia = [0.01, 0.01, 0.01] }
[joints]
hinge = { type = "revolute", child = "door", axis = [0, 1, 0] }
socket = { type = "spherical", parent = "door", child = "ball" }
base = { type = "free", child = "dust" }
[effects.gravity]
[effects.limit.hinge]
lower = -0.5
upper = 0.5
k = 1e4
alpha = 0.3
[effects.coulomb.hinge]
tau_c = 2
eps = 0.01
[effects.actuator.hinge]
kind = "pd"
kp = 20
kd = 2
target = 1
limit = 5
[effects.joint_drag.hinge]
c = 0.2
[effects.drag.dust]
rho = 1.2
area = 0.01
[effects.spring_damper.rope]
bodies = ["door", "dust"]
k = 100
d = 1
length = 0.3
"""


@pytest.mark.parametrize("name", ["forward_dynamics", "inverse_dynamics", "energy", "power",
                                  "difference", "integrated", "step_leapfrog", "step_rk4"])
def test_they_are_numbers_at_corners(tmp_path: Path, name: str) -> None:
    """At ends of ranges, at rest, where bodies coincide, and at rotations by 0 and π."""
    path = tmp_path / "corners.toml"
    path.write_text(CORNERS)
    its = read_scene(path)
    kinds = ["tangent", "adjoint", *(["derivatives"] * name.startswith("step"))]
    functions = derive(its, tuple(f"{name}_{kind}" for kind in kinds))
    turn, half = [0.0, 0.0, 0.0, 1.0], [0.0, 1.0, 0.0, 0.0]
    for angle in (-0.5, 0.0, 0.5):
        for first, second in ((turn, turn), (half, turn), (turn, half)):
            given = {"q": [angle, *first, 0.0, 0.0, 0.0, *second],
                     "q1": [0.5, *second, 0.0, 0.0, 0.0, *first], "h": [0.01]}
            for f in functions.functions:
                arguments = [given.get(a.name, [float(a.name[:2] in ("d_", "w_"))]
                                       * a.quantity.size) for a in f.program.inputs]
                for numbers in (DOUBLE, SINGLE):
                    with np.errstate(all="ignore"):
                        result = evaluator(f.program, numbers)([
                            [numbers.number(x) for x in y] for y in arguments])
                    assert np.isfinite(np.array(result, float)).all(), (f.name, angle, first)


def test_chart_turns_velocities_into_rates(scene: Scene) -> None:
    """∂(q ⊕ φ)/∂φ, by differences."""
    functions = derive(scene, ("chart", "integrated"))
    with mpmath.workdps(50):
        given, nq, nv = state(scene, functions), functions.nq, functions.nv
        N = results(functions, "chart", given)["N"]
        for j in range(nv):
            ends = [results(functions, "integrated", {**given, "phi": [
                sign * STEP * int(i == j) for i in range(nv)]})["qo"] for sign in (-1, 1)]
            for i in range(nq):
                assert abs(N[i * nv + j] - (ends[1][i] - ends[0][i]) / (2 * STEP)) <= CLOSE


def test_difference_inverts_motion(scene: Scene) -> None:
    """(q ⊕ φ) ⊖ q = φ for rotations up to nearly π, and q ⊕ (q1 ⊖ q) = ±q1."""
    functions = derive(scene, ("difference", "integrated"))
    with mpmath.workdps(50):
        for seed, size in enumerate((mpf(10)**-20, 1, mpf("1.8"))):
            given = arguments(scene, functions, seed)
            phi = [size * x for x in given["a"]]
            q1 = results(functions, "integrated", {**given, "phi": phi})["qo"]
            again = results(functions, "difference", {**given, "q1": q1})["phi"]
            for a, b in zip(phi, again, strict=True):
                assert abs(a - b) <= mpf(10)**-22 * size


def test_all_of_a_scene_can_be_derived() -> None:
    """A function of no inputs has neither tangent nor adjoint."""
    scene = m.scene(m.pendulum(2, 1), m.gravity(0, 0, -10))
    selected = resolved(scene, ("*_tangent", "*_adjoint"))
    assert {"body_poses_tangent", "mass_matrix_adjoint"} <= selected
    assert not {"linear_parameters_tangent", "base_parameters_adjoint"} & {*all_names(scene)}
    derived = {f.name for f in derive(scene, selected).functions}
    assert derived <= selected and {"body_poses_tangent", "mass_matrix_adjoint"} <= derived


def test_they_are_selected_by_name_alone() -> None:
    """Neither `all` nor a pattern that matches other functions selects them."""
    scene = m.scene(m.pendulum(2, 1), m.gravity(0, 0, -10))
    assert {"energy_tangent", "step_rk4_derivatives"} <= set(all_names(scene)) - set(names(scene))
    assert resolved(scene, ("all",)) == set(names(scene))
    assert resolved(scene, ("power*",)) == {"power"}
    assert resolved(scene, ("power_*",)) == {"power_tangent", "power_adjoint"}
    assert resolved(scene, ("*_dynamics_adjoint",)) == {
        "inverse_dynamics_adjoint", "forward_dynamics_adjoint"}
    assert not {x for x in all_names(scene) if x.endswith(("_tangent_adjoint", "parts_tangent"))}
