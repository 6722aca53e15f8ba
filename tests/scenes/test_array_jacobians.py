"""jax.jacfwd of a scene's functions: many directions at one place take one Jacobian."""

import re
from dataclasses import replace

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from coscrew_codegen.runtime.arrays import in_jax
from coscrew_codegen.runtime.load import Kernels, kernels_for, kernels_of
from tests.support.scenes.robots import Robot, model_of, paired, scene_of

UR5 = "ur_description/urdf/ur5_robot.urdf"
COUNT = 7


@pytest.fixture(scope="module")
def robot() -> Robot:
    names = ("inverse_dynamics", "inverse_dynamics_derivatives", "energy")
    return paired(scene_of(UR5), model_of(UR5, False), names)


@pytest.fixture(scope="module")
def kernels(robot: Robot) -> Kernels:
    return kernels_of(robot.functions)


@pytest.mark.parametrize("by", [(0, 1, 2), (0,), (2,), (1, 2), (0, 2), (2, 0)], ids=str)
@pytest.mark.parametrize("jitted", [False, True], ids=["", "jit"])
def test_columns_are_the_derivatives_of_dynamics(robot: Robot, kernels: Kernels, by: tuple,
                                                 jitted: bool) -> None:
    """They hold for one state and for many, by all or some inputs, in any order."""
    with jax.enable_x64(True):
        function, states = kernels.arrays(jnp).inverse_dynamics, robot.states(COUNT)
        slopes = jax.jacfwd(function, argnums=by)
        many = jax.vmap(slopes)
        result = (jax.jit(many) if jitted else many)(*map(jnp.asarray, states))
        one = slopes(*(jnp.asarray(x[3]) for x in states))
    wanted = kernels.double.inverse_dynamics_derivatives(*states)
    for k, of_many, of_one in zip(by, result, one, strict=True):
        assert np.abs(np.asarray(of_many) - wanted[k]).max() < 1e-13 * np.abs(wanted[k]).max()
        assert np.abs(np.asarray(of_one) - wanted[k][3]).max() < 1e-13 * np.abs(wanted[k]).max()


def test_any_directions_are_tangents(robot: Robot, kernels: Kernels,
                                     monkeypatch: pytest.MonkeyPatch) -> None:
    """Jacobians and tangents agree, also on second derivatives."""
    with jax.enable_x64(True):
        function, rng = kernels.arrays(jnp).inverse_dynamics, np.random.default_rng(4)
        q, v, a = (jnp.asarray(x[0]) for x in robot.states(1))
        directions = jnp.asarray(rng.standard_normal((9, 6)))

        def along(d: jax.Array) -> jax.Array:
            return jax.jvp(lambda x: function(x, v, a), (q,), (d,))[1]

        def twice(x: jax.Array) -> jax.Array:
            return jax.jacfwd(jax.jacfwd(lambda y: function(y, v, a)))(x)

        results = []
        for fewest in (3, 1000):
            monkeypatch.setattr(in_jax, "FEWEST", fewest)
            results.append((jax.vmap(along)(directions), twice(q)))
    for x, y in zip(*results, strict=True):
        assert np.abs(x - y).max() < 1e-12 * np.abs(y).max()


@pytest.mark.parametrize("selected", [True, False], ids=["selected", "not selected"])
def test_derivatives_of_dynamics_are_taken_once_and_copied_never(robot: Robot, kernels: Kernels,
                                                                 selected: bool) -> None:
    """Text that XLA compiles calls the scene's function, whose results are those of jacfwd."""
    wanted = kernels.double.inverse_dynamics_derivatives
    if not selected:
        kernels = kernels_for(replace(scene_of(UR5), name="robot"), ("inverse_dynamics",))
    with jax.enable_x64(True):
        slopes = jax.jit(jax.vmap(jax.jacfwd(kernels.arrays(jnp).inverse_dynamics, (0, 1, 2))))
        given = [*map(jnp.asarray, robot.states(COUNT))]
        calls, root = calls_and_root(slopes.lower(*given).compile().as_text())
        result = slopes(*given)
    assert calls == {"robot_inverse_dynamics_derivatives_double"} and root == "conditional"
    for x, y in zip(result, wanted(*given), strict=True):
        assert np.array_equal(np.asarray(x), y)


def test_jacobians_of_other_functions_are_taken_once(robot: Robot, kernels: Kernels) -> None:
    """A function whose derivatives the scene has not has its Jacobian from its Program."""
    with jax.enable_x64(True):
        slopes = jax.jit(jax.vmap(jax.jacfwd(kernels.arrays(jnp).energy, (0, 1))))
        given = [jnp.asarray(x) for x in robot.states(COUNT)[:2]]
        calls, root = calls_and_root(slopes.lower(*given).compile().as_text())
        by_v = slopes(*given)[1][:, 0]
        M = kernels.double.inverse_dynamics_derivatives(*given, given[1])[2]
    assert calls == {"robot_energy_jacobian_double"} and root == "conditional"
    momentum = (M @ np.asarray(given[1])[..., None])[..., 0]
    assert np.abs(np.asarray(by_v) - momentum).max() < 1e-14 * np.abs(momentum).max()


def calls_and_root(text: str) -> tuple[set[str], str]:
    """Names that compiled text calls, without numbers, and the operation of its results."""
    calls = {x.rpartition("_")[0] for x in re.findall(r'custom_call_target="(robot_\w+)"', text)}
    last = re.search(r"ROOT .* (\w+)\(", text.rpartition("\nENTRY ")[2])
    assert last
    return calls, last[1]
