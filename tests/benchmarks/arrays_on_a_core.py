"""Times of 4,096 states of a Panda on arrays of JAX and of NumPy, and by frax, printed as JSON.

arrays.py runs it with the settings that frax recommends, which must hold before JAX is imported.
frax's file of the robot is the model of both, with the fingers fixed; results are compared to 1e-9,
because the right angles in it have 12 digits.
"""

import json
import warnings
from collections.abc import Callable, Iterator
from importlib.resources import files
from importlib.util import find_spec
from pathlib import Path
from tempfile import TemporaryDirectory

import jax
import jax.numpy as jnp
import numpy as np

from coscrew_codegen import load_scene
from coscrew_codegen.reports.timing.loop_timing import timed_calls
from coscrew_codegen.runtime.load import Kernels
from tests.support.scenes.robots import path_of

FUNCTIONS = ("inverse_dynamics", "forward_dynamics", "mass_matrix")
STATES = 4096
SECONDS = 12.0  # of each function
GRAVITY = (0.0, 0.0, 9.81, 0.0, 0.0, 0.0)



def model() -> Path:
    """frax's Panda; without frax that of example-robot-data, with its fingers."""
    if find_spec("frax"):
        return files("frax") / "assets" / "franka_panda" / "panda.urdf"
    return path_of("panda_description/urdf/panda.urdf")


def kernels(folder: Path) -> Kernels:
    """The robot under gravity."""
    path = folder / "panda.toml"
    path.write_text(f'model = "{model()}"\n[effects.gravity]\n')
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of its link without mass
        return load_scene(path, functions=FUNCTIONS, implausible="warn")


def theirs() -> dict[str, Callable[..., jax.Array]]:
    """frax's functions of many states, if it is installed."""
    try:
        import frax
    except ImportError:
        return {}
    robot = frax.Robot(str(model()))
    gravity = jnp.array(GRAVITY)
    one = {"inverse_dynamics": lambda q, v, a: robot.rnea(q, v, a, gravity, None),
           "forward_dynamics": lambda q, v, tau: robot.forward_dynamics(q, v, tau, None),
           "mass_matrix": robot.mass_matrix}
    return {name: jax.jit(jax.vmap(f)) for name, f in one.items()}


def waited(function: Callable[..., object], *given: object) -> Callable[[], object]:
    """The call, until its results are there."""
    return lambda: jax.block_until_ready(function(*given))


def measured() -> Iterator[tuple[str, dict[str, list[float]]]]:
    """A function, and its times in ns a state, round by round: on arrays of JAX, their gradient, on
    arrays of NumPy, frax."""
    with TemporaryDirectory() as folder:
        result = kernels(Path(folder))
        arrays, rng = result.arrays(jnp), np.random.default_rng(1)
        states = rng.standard_normal((3, STATES, result.NV))
        rivals = theirs()
        for name in FUNCTIONS:
            given = list(states[:1 if name == "mass_matrix" else 3])
            in_jax = [jnp.asarray(x) for x in given]
            value, plain = getattr(arrays, name), getattr(result.double, name)
            gradient = jax.grad(lambda *x, f=value: f(*x).sum(), argnums=tuple(range(len(given))))
            calls = {"arrays": waited(jax.jit(value), *in_jax),
                     "gradient": waited(jax.jit(gradient), *in_jax),
                     "numpy": lambda f=plain, x=given: f(*x)}
            if name in rivals:
                calls["frax"] = waited(rivals[name], *in_jax)
                compare(name, np.asarray(calls["frax"]()), plain(*given))
            timings = timed_calls(list(calls.values()), 1e9 * SECONDS)
            yield name, {way: (x.rounds / STATES).tolist()
                         for way, x in zip(calls, timings, strict=True)}


def compare(name: str, other: np.ndarray, own: np.ndarray) -> None:
    """Raise ValueError unless results are equal to 1e-9 of the largest of each state."""
    error = (abs(own - other).reshape(STATES, -1).max(axis=1)
             / abs(own).reshape(STATES, -1).max(axis=1)).max()
    if not error < 1e-9:
        raise ValueError(f"{name}: frax's results differ from ours by {error:.1e} of the largest")


if __name__ == "__main__":
    print(json.dumps(dict(measured())))
