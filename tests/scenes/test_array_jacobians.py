"""jax.jacfwd of a scene's functions: many directions at one place take one Jacobian."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from coscrew_codegen.runtime.arrays import in_jax
from coscrew_codegen.runtime.load import Kernels, kernels_of
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


def test_jacobians_are_taken_once(robot: Robot, kernels: Kernels) -> None:
    """The text that XLA gets calls the Jacobian, and no tangent."""
    with jax.enable_x64(True):
        slopes = jax.vmap(jax.jacfwd(kernels.arrays(jnp).inverse_dynamics, argnums=(0, 1)))
        text = jax.jit(slopes).lower(*map(jnp.asarray, robot.states(COUNT))).as_text()
    assert "inverse_dynamics_jacobian" in text and "inverse_dynamics_tangent" not in text
