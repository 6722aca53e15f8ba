"""A tangent or an adjoint product takes at most three times its function's operations, for all
functions of arms and a quadruped, and many of a humanoid.

An adjoint also reads the weight of each result, where the function does nothing: it has an addition
more for each result that varies.  A product of two variables takes one operation, and four with its
tangent, which is the least: numbers with derivatives have no product of fewer than three
multiplications.  So functions of a few such products may take four times as many, and so may the
logarithm of a rotation."""

from collections.abc import Collection

import pytest

from coscrew_codegen.dynamics import derive
from coscrew_codegen.program import Constant, Program
from coscrew_codegen.program.flops import flops
from coscrew_codegen.scene.function_selection import all_names
from coscrew_codegen.scene.scene import Scene
from tests.support.scenes import robots

FEW = 100
"""Operations of a function of a few products."""
OF_HUMANOID = ("inverse_dynamics", "forward_dynamics", "mass_matrix", "bias_torques", "energy",
               "power", "momentum", "body_poses", "body_twists", "center_of_mass_jacobian",
               "centroidal_momentum_rate", "energy_gradients")
DYNAMICS = {"inverse_dynamics", "forward_dynamics", "mass_matrix", "energy", "momentum"}
"""Functions whose adjoints take less than three times as many even with these additions."""
ARMS_AND_A_QUADRUPED = [("ur_description/urdf/ur5_robot.urdf", False),
                        ("panda_description/urdf/panda.urdf", False),
                        ("solo_description/robots/solo12.urdf", True)]
PRODUCTS = ("tangent", "adjoint")


def _varying(program: Program) -> int:
    """The number of results that are no constants."""
    return sum(not isinstance(x, Constant) for x in program.results)


def _names(scene: Scene) -> list[str]:
    """The scene's functions besides steps, without those of a quadruped's other legs."""
    names = dict.fromkeys(all_names(scene))
    return [name for name in names if f"{name}_adjoint" in names and not name.startswith("step_")
            and not any(leg in name for leg in ("FR_", "HL_", "HR_"))]


def _check(scene: Scene, names: Collection[str]) -> None:
    programs = {f.name: f.program for f in derive(scene, [
        x for name in names for x in (name, *(f"{name}_{y}" for y in PRODUCTS))]).functions}
    checked = [name for name in names if f"{name}_adjoint" in programs]
    assert {*checked} >= DYNAMICS
    for name in checked:
        own = programs[name]
        times = 3 if flops(own) >= FEW and name != "difference" else 4
        for product, weights in zip(PRODUCTS, (0, _varying(own)), strict=True):
            most = 2.8 * flops(own) if name in DYNAMICS else times * flops(own) + weights
            assert flops(programs[f"{name}_{product}"]) <= most, (name, product)


@pytest.mark.parametrize("file, free", ARMS_AND_A_QUADRUPED)
def test_products_of_all_functions(file: str, free: bool) -> None:
    scene = robots.scene_of(file, free)
    _check(scene, _names(scene))


def test_products_of_a_humanoid() -> None:
    _check(robots.scene_of("g1_description/urdf/g1_29dof_rev_1_0.urdf", True), OF_HUMANOID)
