"""What a state of a Panda takes on arrays of JAX on a CPU: functions and their gradients, against
frax's published times for 4,096 states on a core, on another machine.

`python -m tests.benchmarks.arrays`.  XLA runs on one thread if started under `taskset -c 0`.
"""

import time
from collections.abc import Callable

import jax
import jax.numpy as jnp
import numpy as np
from tabulate import tabulate

from coscrew_codegen.simulate.load import kernels_of
from tests.benchmarks.scene_lanes import panda

STATES, RUNS = 4096, 40
PUBLISHED = {"inverse_dynamics": 3914, "forward_dynamics": 8507}
"""frax's ns a state: what its authors state, not measured here."""


def nanoseconds(function: Callable[[], object]) -> float:
    """A state's, the least of many runs."""
    times = []
    for _ in range(RUNS):
        start = time.perf_counter()
        jax.block_until_ready(function())
        times.append(time.perf_counter() - start)
    return min(times) / STATES * 1e9


def main() -> None:
    jax.config.update("jax_enable_x64", True)
    kernels = kernels_of(panda())
    functions, rng, rows = kernels.arrays(jnp), np.random.default_rng(1), []
    q, v, a = (jnp.asarray(rng.standard_normal((STATES, kernels.NV))) for _ in range(3))
    for name, published in PUBLISHED.items():
        function = getattr(functions, name)
        value = jax.jit(function)
        gradient = jax.jit(jax.grad(lambda *x, f=function: f(*x).sum(), argnums=(0, 1, 2)))
        times = []
        for made in (value, gradient):
            jax.block_until_ready(made(q, v, a))
            times.append(nanoseconds(lambda f=made: f(q, v, a)))
        rows.append((name, *times, published, published / times[0]))
    print(tabulate(rows, ("function", "ns", "ns, gradient", "frax ns", "ratio"), floatfmt=".0f"))


if __name__ == "__main__":
    main()
